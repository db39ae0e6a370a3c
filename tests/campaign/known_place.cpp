// SPDX-License-Identifier: GPL-3.0-or-later
#include "known_place.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/geometry/polygon.h"
#include "spherewalk/photo/picture_file.h"
#include "spherewalk/practice/practice_room.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace spherewalk::campaign {

namespace {

constexpr EquirectSize kRays{32, 16};
constexpr double kLowestM = 0.05;
constexpr double kHighestM = 1.8;

class PracticePlace : public KnownPlace {
  public:
    PracticePlace(const practice::PracticeRoomOptions& options, const render::DatasetInfo& info)
        : m_room(options) {
        for (const render::DatasetPhoto& photo : info.photos) {
            m_eyes.push_back(photo.roomFromPhoto.translation);
        }
    }

    double distanceM(const Eigen::Vector3d& point) const override { return m_room.surfaceDistanceM(point); }

    int sights(const Eigen::Vector3d& place) const override {
        return static_cast<int>(std::count_if(m_eyes.begin(), m_eyes.end(), [&](const Eigen::Vector3d& eye) {
            return rangeM(eye, place - eye) > (place - eye).norm() - 0.005;
        }));
    }

    std::vector<SeenPoint> seenPoints() const override {
        std::vector<SeenPoint> points;
        for (const Eigen::Vector3d& eye : m_eyes) {
            for (int y = 0; y < kRays.height; ++y) {
                for (int x = 0; x < kRays.width; ++x) {
                    const Eigen::Vector3d ray = direction(kRays, Eigen::Vector2d(x, y));
                    points.push_back({eye + rangeM(eye, ray) * ray, ray.head<2>().norm()});
                }
            }
        }
        return points;
    }

    bool isOccupied(const Eigen::Vector2d& middle, double cellM) const override {
        for (double z = kLowestM + cellM / 2; z < kHighestM; z += cellM / 2) {
            if (m_room.surfaceDistanceM({middle.x(), middle.y(), z}) <= cellM / 2) {
                return true;
            }
        }
        return false;
    }

    bool isSeenThrough(const Eigen::Vector3d& point) const override {
        return std::any_of(m_eyes.begin(), m_eyes.end(), [&](const Eigen::Vector3d& eye) {
            return rangeM(eye, point - eye) > (point - eye).norm();
        });
    }

    double clearanceM(const Eigen::Vector3d& point) const override { return m_room.surfaceDistanceM(point); }

    double laserM(const Eigen::Vector3d& from, const Eigen::Vector3d& along) const override {
        return rangeM(from, along);
    }

    double depthM(const Eigen::Vector3d& from, const Eigen::Vector3d& along) const override {
        return rangeM(from, along);
    }

  private:
    double rangeM(const Eigen::Vector3d& from, const Eigen::Vector3d& along) const {
        return m_room.cast(from, along, 0.001).rangeM;
    }

    practice::PracticeRoom m_room;
    std::vector<Eigen::Vector3d> m_eyes;
};

/// A photo's true distances.
class Scan {
  public:
    /// ranges: infinite where nothing is known.
    Scan(DepthImage ranges, const Rigid3& roomFromPhoto)
        : m_ranges(std::move(ranges)),
          m_size{m_ranges.width(), m_ranges.height()},
          m_roomFromPhoto(roomFromPhoto),
          m_photoFromRoom(roomFromPhoto.inverse()) {
        std::replace(m_ranges.values().begin(), m_ranges.values().end(), HUGE_VALF, 0.0F);
    }

    const EquirectSize& size() const { return m_size; }

    /// Columns go round. It is 0 where nothing is known.
    double rangeM(int x, int y) const {
        return *m_ranges.at((x + m_size.width) % m_size.width, std::clamp(y, 0, m_size.height - 1));
    }

    Eigen::Vector3d point(int x, int y) const {
        return m_roomFromPhoto * (rangeM(x, y) * direction(m_size, Eigen::Vector2d(x, y)));
    }

    /// Whether neighbouring pixels see one surface.
    bool isJoined(int x, int y, int right, int down, double mostJump = 1.08) const {
        const auto [least, most] = std::minmax(
            {rangeM(x, y), rangeM(x + right, y), rangeM(x, y + down), rangeM(x + right, y + down)});
        return least > 0 && most <= mostJump * least;
    }

    /// How much farther than a point the truth is in its direction; negative infinity if it is not known.
    double beyondM(const Eigen::Vector3d& place) const {
        const auto [x, y] = pixelOf(place);
        const double range = rangeM(x, y);
        return range > 0 ? range - (m_photoFromRoom * place).norm() : -HUGE_VAL;
    }

    /// To the nearest surface within 10 cm, or infinity: to the plane through the nearest pixel's neighbours.
    double distanceM(const Eigen::Vector3d& place) const {
        constexpr double kWithinM = 0.1;
        const Eigen::Vector3d local = m_photoFromRoom * place;
        const auto [x, y] = pixelOf(place);
        const double pixelM = local.norm() * 2 * std::numbers::pi / m_size.width;
        const int rows = std::min(static_cast<int>(kWithinM / pixelM) + 1, m_size.height / 4);
        const double level = local.head<2>().norm() / local.norm();
        const int columns = std::min(static_cast<int>(rows / std::max(level, 0.05)), m_size.width / 4);
        double nearest = kWithinM;
        std::pair<int, int> best{-1, -1};
        for (int v = std::max(1, y - rows); v <= std::min(y + rows, m_size.height - 2); ++v) {
            for (int u = x - columns; u <= x + columns; ++u) {
                const bool isNear = std::abs(rangeM(u, v) - local.norm()) < nearest;
                const double distance = isNear ? (point(u, v) - place).norm() : HUGE_VAL;
                if (distance < nearest) {
                    nearest = distance;
                    best = {u, v};
                }
            }
        }
        return best.second < 0 ? HUGE_VAL : std::min(nearest, planeDistanceM(best.first, best.second, place));
    }

  private:
    std::pair<int, int> pixelOf(const Eigen::Vector3d& place) const {
        const Eigen::Vector2d at = pixel(m_size, m_photoFromRoom * place);
        return {static_cast<int>(std::lround(at.x())), static_cast<int>(std::lround(at.y()))};
    }

    double planeDistanceM(int x, int y, const Eigen::Vector3d& place) const {
        if (!isJoined(x, y, 1, 1) || !isJoined(x, y, -1, -1)) {
            return HUGE_VAL;
        }
        const Eigen::Vector3d normal =
            (point(x + 1, y) - point(x - 1, y)).cross(point(x, y + 1) - point(x, y - 1)).normalized();
        return std::abs(normal.dot(place - point(x, y)));
    }

    DepthImage m_ranges;
    EquirectSize m_size;
    Rigid3 m_roomFromPhoto;
    Rigid3 m_photoFromRoom;
};

class ScannedPlace : public KnownPlace {
  public:
    explicit ScannedPlace(std::vector<Scan> scans) : m_scans(std::move(scans)), m_slice(kLaserHeightM) {
        for (const Scan& scan : m_scans) {
            for (int y = 0; y + 1 < scan.size().height; ++y) {
                for (int x = 0; x < scan.size().width; ++x) {
                    addPixel(scan, x, y);
                }
            }
        }
    }

    double distanceM(const Eigen::Vector3d& point) const override {
        constexpr double kBehindM = 0.1;
        double nearest = HUGE_VAL;
        bool isKnown = false;
        for (const Scan& scan : m_scans) {
            isKnown = isKnown || scan.beyondM(point) > -kBehindM;
            nearest = std::min(nearest, scan.distanceM(point));
        }
        return isKnown ? nearest : -1;
    }

    int sights(const Eigen::Vector3d& place) const override {
        constexpr double kSameM = 0.03;
        return static_cast<int>(std::count_if(m_scans.begin(), m_scans.end(), [&](const Scan& scan) {
            return std::abs(scan.beyondM(place)) < kSameM;
        }));
    }

    std::vector<SeenPoint> seenPoints() const override {
        std::vector<SeenPoint> points;
        for (const Scan& scan : m_scans) {
            const int step = scan.size().width / kRays.width;
            for (int y = step / 2; y < scan.size().height; y += step) {
                for (int x = step / 2; x < scan.size().width; x += step) {
                    const Eigen::Vector3d ray = direction(scan.size(), Eigen::Vector2d(x, y));
                    points.push_back({scan.point(x, y), ray.head<2>().norm()});
                }
            }
        }
        return points;
    }

    bool isOccupied(const Eigen::Vector2d& middle, double cellM) const override {
        const auto least = finely(middle.array() - cellM / 2);
        const auto most = finely(middle.array() + cellM / 2);
        for (int x = least.first; x <= most.first; ++x) {
            for (int y = least.second; y <= most.second; ++y) {
                if (m_occupied.contains({x, y})) {
                    return true;
                }
            }
        }
        return false;
    }

    bool isSeenThrough(const Eigen::Vector3d& point) const override {
        return std::any_of(m_scans.begin(), m_scans.end(),
                           [&](const Scan& scan) { return scan.beyondM(point) > 0; });
    }

    double clearanceM(const Eigen::Vector3d& point) const override {
        return m_slice.clearanceM(point.head<2>());
    }

    double laserM(const Eigen::Vector3d& from, const Eigen::Vector3d& along) const override {
        constexpr double kStepM = 0.03;
        const double rangeM = m_slice.rangeM(from.head<2>(), along.head<2>());
        for (double wayM = kStepM; wayM < rangeM - kStepM; wayM += kStepM) {
            if (!isSeenThrough(from + wayM * along)) {
                return HUGE_VAL; // what stands there, no scan shows
            }
        }
        return rangeM;
    }

  private:
    /// In cells of a centimetre.
    static std::pair<int, int> finely(const Eigen::Vector2d& place) {
        return {static_cast<int>(std::floor(100 * place.x())), static_cast<int>(std::floor(100 * place.y()))};
    }

    void addPixel(const Scan& scan, int x, int y) {
        const Eigen::Vector3d point = scan.point(x, y);
        if (scan.rangeM(x, y) > 0 && point.z() > kLowestM && point.z() < kHighestM) {
            m_occupied.insert(finely(point.head<2>()));
        }
        constexpr double kNearPlaneM = 0.3;
        constexpr double kMostJump = 1.03; // what is 8 % behind the leg of a chair is not its side
        if (std::abs(point.z() - m_slice.heightM()) < kNearPlaneM && scan.isJoined(x, y, 1, 1, kMostJump)) {
            m_slice.cut({point, scan.point(x + 1, y), scan.point(x, y + 1)});
            m_slice.cut({scan.point(x + 1, y), scan.point(x, y + 1), scan.point(x + 1, y + 1)});
        }
    }

    std::vector<Scan> m_scans;
    Slice m_slice;
    std::set<std::pair<int, int>> m_occupied;
};

} // namespace

void Slice::cut(const std::array<Eigen::Vector3d, 3>& corners) {
    std::vector<Eigen::Vector2d> ends;
    for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Vector3d& a = corners[i];
        const Eigen::Vector3d& b = corners[(i + 1) % 3];
        if ((a.z() < m_heightM) != (b.z() < m_heightM)) {
            ends.emplace_back((a + (m_heightM - a.z()) / (b.z() - a.z()) * (b - a)).head<2>());
        }
    }
    if (ends.size() == 2) {
        m_segments.emplace_back(ends[0], ends[1]);
    }
}

double Slice::rangeM(const Eigen::Vector2d& from, const Eigen::Vector2d& along) const {
    const auto cross = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
        return a.x() * b.y() - a.y() * b.x();
    };
    double nearest = HUGE_VAL;
    for (const auto& [a, b] : m_segments) {
        const double turn = cross(along, b - a);
        const double range = cross(a - from, b - a) / turn;
        const double share = cross(a - from, along) / turn;
        if (range > 0 && share >= 0 && share <= 1) {
            nearest = std::min(nearest, range);
        }
    }
    return nearest;
}

double Slice::clearanceM(const Eigen::Vector2d& from) const {
    double nearest = HUGE_VAL;
    for (const auto& [a, b] : m_segments) {
        nearest = std::min(nearest, distanceToEdge(Polygon{a, b}, from));
    }
    return nearest;
}

std::unique_ptr<KnownPlace> practicePlace(const std::string& style, const render::DatasetInfo& info) {
    practice::PracticeRoomOptions options;
    if (style == "flat") {
        options.style = practice::RoomStyle::Flat;
        options.sizeM = {8, 6, 2.5};
    } else if (style == "bare") {
        options.style = practice::RoomStyle::Bare;
    } else if (style != "lively") {
        throw Error(ErrorKind::InvalidInput, "The room is lively, bare, flat, or a folder with truth.json.");
    }
    return std::make_unique<PracticePlace>(options, info);
}

std::unique_ptr<KnownPlace> scannedPlace(const std::filesystem::path& folder) {
    const Json truth = parseJson(readTextFile(folder / "truth.json"), "truth.json");
    std::vector<Scan> scans;
    for (const Json& photo : truth["photos"]) {
        if (photo.contains("depth") && photo["depth"].is_string()) {
            const auto at = photo["position"].get<std::vector<double>>();
            const auto turn = photo["quaternion_wxyz"].get<std::vector<double>>();
            scans.emplace_back(photo::readDepthPng(folder / photo["depth"].get<std::string>()),
                               Rigid3{Eigen::Quaterniond(turn[0], turn[1], turn[2], turn[3]).normalized(),
                                      {at[0], at[1], at[2]}});
        }
    }
    if (scans.empty()) {
        throw Error(ErrorKind::InvalidInput, "No photo of truth.json has a depth.");
    }
    return std::make_unique<ScannedPlace>(std::move(scans));
}

} // namespace spherewalk::campaign
