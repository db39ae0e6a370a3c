// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/scene/carried.h"

#include "polar_map.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/statistics.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

namespace spherewalk::scene {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr std::size_t kFewestPhotos = 6;
constexpr std::size_t kMostPhotos = 24;
constexpr double kLeastSpreadM = 0.1; ///< Of the photos along their line, and across it if they are in none.
constexpr float kAcrossLine = 0.35F;  ///< The sine of the least angle between a line of photos and an edge.
constexpr int kFirstStep = 6;         ///< Less is not worth a look.
constexpr int kRoomBegins = 32;       ///< Up to the next step, photos of a room usually show other things.
constexpr int kRoomEnds = 72;
constexpr int kEndOfChanges = 64;    ///< An operator's head is higher.
constexpr int kEndInLine = 42;       ///< Farther up, lines on the floor are too fine to tell their way.
constexpr float kLeastUsual = 0.05F; ///< By which photos of a room differ at least.
/// The least change of brightness from one step to the next that is an edge: of its logarithm.
constexpr float kEdge = 0.04F;
constexpr float kEdgeInLine = 0.12F; ///< The same where its way matters.
constexpr double kAgreeing = 0.7;    ///< Share of the photos that show a carried edge.
constexpr float kDeviation = 0.5F;   ///< Share of the edge by which such a photo may differ.
constexpr float kAlike = 0.6F;       ///< Of how much photos differ usually; less is what they carry along.
constexpr float kUnlike = 0.65F;
constexpr float kChange = 0.25F;             ///< Of a colour's logarithm, that a border is seen by.
constexpr float kNearlyAll = 0.85F;          ///< Of so many photos the colours change at no place by chance.
constexpr int kThick = 3;                    ///< Steps over which such a change is seen.
constexpr int kWobble = 2;                   ///< Steps by which a hand is elsewhere from photo to photo.
constexpr std::ptrdiff_t kFewestExact = 10;  ///< Azimuths with an edge; fewer come by chance,
constexpr std::ptrdiff_t kFewestInLine = 45; ///< and in one line more do.
constexpr double kLeastShareChanged = 0.5;   ///< The same of azimuths with a change, as a share.
constexpr double kMarginRad = 2.1 * kPi / 180;
constexpr std::size_t kSmoothing = 2; ///< Azimuths to either side that count.
constexpr std::size_t kDent = 7;      ///< The same for dents, of which this is half the width.
constexpr double kLeastShare = 0.001; ///< Of the sphere; less is not worth a new picture.

using Map = PolarMap<float>;
using Edges = PolarMap<std::uint8_t>;

/// The tangents of the sphere away from straight down, and along the azimuth.
std::array<Eigen::Vector3d, 2> tangents(int azimuth, int step) {
    const double at = azimuthOf(azimuth);
    return {fromBelow(at, (step + 0.5) * kPolarStepRad + kPi / 2),
            Eigen::Vector3d(-std::sin(at), std::cos(at), 0)};
}

/// Brightness, and red and blue against green. They are logarithms, so that the exposure adds to them.
Eigen::Vector3f logColour(const RgbImage& picture, const Eigen::Vector3d& way) {
    constexpr float kTint = 2; // Tints differ less than brightness.
    const Eigen::Vector3f colour = colourAt(picture, placeIn(picture, way));
    const Eigen::Vector3f log = (colour.array() + 16).log();
    return {std::log(colour.dot(Eigen::Vector3f(0.299F, 0.587F, 0.114F)) + 16), kTint * (log.x() - log.y()),
            kTint * (log.z() - log.y())};
}

/// What a photo shows from straight down up.
struct Below {
    explicit Below(const PosedPicture& photo, const Eigen::Vector3d& lineInRoom)
        : line(photo.roomFromPhoto.rotation.conjugate() * lineInRoom) {
        const RgbImage& picture = *photo.picture;
        for (int azimuth = 0; azimuth < kAzimuths; ++azimuth) {
            for (int step = 0; step < kPolarSteps; ++step) {
                const Eigen::Vector3d way = wayOf(azimuth, step);
                const Eigen::Vector3f seen = logColour(picture, way);
                slope.at(azimuth, step) = slopeAt(picture, azimuth, step);
                for (std::size_t i = 0; i < colour.size(); ++i) {
                    colour[i].at(azimuth, step) = seen[static_cast<Eigen::Index>(i)];
                }
            }
        }
        const float exposure = colour[0].median(0, kStepsForExposure);
        colour[0] = Map([&](int azimuth, int step) { return colour[0].at(azimuth, step) - exposure; });
        change = Map([&](int azimuth, int step) { return changeAt(azimuth, step); });
    }

    /// By the corners of a square, so that an edge keeps its way.
    static Eigen::Vector2f slopeAt(const RgbImage& picture, int azimuth, int step) {
        constexpr double kHalf = 0.75 * kPolarStepRad;
        const Eigen::Vector3d way = wayOf(azimuth, step);
        const auto [away, along] = tangents(azimuth, step);
        Eigen::Vector2f slope = Eigen::Vector2f::Zero();
        for (const int i : {-1, 1}) {
            for (const int k : {-1, 1}) {
                const float bright = logColour(picture, way + kHalf * (i * away + k * along)).x();
                slope += bright / 2 * Eigen::Vector2f(static_cast<float>(i), static_cast<float>(k));
            }
        }
        return slope;
    }

    /// How much the colour differs from three steps below to three steps above.
    float changeAt(int azimuth, int step) const {
        float most = 0;
        for (const Map& map : colour) {
            float sum = 0;
            for (int i = -1; i <= 1; ++i) {
                for (int k = 1; k <= 3; ++k) {
                    sum += map.at(azimuth + i, std::min(step + k, kPolarSteps - 1)) -
                           map.at(azimuth + i, std::max(step - k, 0));
                }
            }
            most = std::max(most, std::abs(sum / 9));
        }
        return most;
    }

    static constexpr int kStepsForExposure = 10; ///< What is carried along is there.

    Eigen::Vector3d line; ///< lineOf() in the photo's frame.
    std::array<Map, 3> colour;
    Map change;                      ///< See changeAt().
    PolarMap<Eigen::Vector2f> slope; ///< Of brightness, away from straight down and along the azimuth.
};

/// How far up what is carried along reaches at an azimuth.
struct Reach {
    bool isKnown = false; ///< Whether it is known where the room begins.
    float angle = 0;
};

/// The angles of all azimuths. Where it is not known where the room begins, what is carried reaches as far as
/// on that side where it is more, or less if that is far away. Range: at one azimuth it is known.
std::array<float, kAzimuths> completed(const std::array<Reach, kAzimuths>& reaches) {
    constexpr std::size_t kFar = 15; // azimuths from one side to the other
    constexpr auto kAll = static_cast<std::size_t>(kAzimuths);
    std::array<float, kAll> angles{};
    for (std::size_t i = 0; i < kAll; ++i) {
        std::size_t before = kAll;
        std::size_t after = 0;
        while (!reaches[(i + before) % kAll].isKnown) {
            --before;
        }
        while (!reaches[(i + after) % kAll].isKnown) {
            ++after;
        }
        const auto sides = std::minmax(reaches[(i + before) % kAll].angle, reaches[(i + after) % kAll].angle);
        angles[i] = kAll - before + after < kFar ? sides.second : sides.first;
    }
    return angles;
}

/// Compares what photos show below.
class Comparison {
  public:
    /// line: as lineOf() has it.
    Comparison(const std::vector<PosedPicture>& photos, const Eigen::Vector3d& line)
        : m_isInLine(!line.isZero()) {
        for (const PosedPicture& photo : photos) {
            m_photos.emplace_back(photo, line);
        }
        m_unlike = unlikeness();
    }

    /// The angle that what is carried along reaches to at each azimuth; nothing if there is none.
    std::optional<std::array<float, kAzimuths>> reach() const {
        const Borders exact =
            borders(joined(Edges([&](int azimuth, int step) { return isCarried(azimuth, step); }), 1));
        Borders changed = borders(joined(changes(0), kThick));
        if (m_isInLine) {
            changed.fill(-1); // Borders of the room that lie along the line stay in their place.
        } else if (wobbles(exact, changed)) {
            changed = borders(joined(changes(kWobble), kThick));
        }
        const bool hasChanged = count(changed) >= kLeastShareChanged * kAzimuths;
        if (count(exact) < (m_isInLine ? kFewestInLine : kFewestExact) && !hasChanged) {
            return std::nullopt;
        }
        std::array<Reach, kAzimuths> reaches;
        for (std::size_t i = 0; i < reaches.size(); ++i) {
            // Two steps beyond a border, a change is still seen.
            const int edge = std::max(exact[i], hasChanged ? changed[i] - 2 : -1);
            const int room = firstUnlike(static_cast<int>(i));
            const int end = edge >= 0 ? edge + 1 : room;
            reaches[i] = {edge >= 0 || room < kFirstStep, static_cast<float>(end * kPolarStepRad)};
        }
        return completed(reaches);
    }

  private:
    /// By how much photos differ there, in parts of how much they differ in a room usually.
    Map unlikeness() const {
        const auto spread = [&](std::size_t i) {
            return Map([&](int azimuth, int step) {
                std::vector<float> all;
                for (const Below& photo : m_photos) {
                    all.push_back(photo.colour[i].at(azimuth, step));
                }
                return medianAndSpread(all).sigma;
            });
        };
        const std::array<Map, 2> tints{spread(1), spread(2)};
        const auto smooth = [](const Map& of) {
            return Map([&](int azimuth, int step) {
                float sum = 0;
                for (int i = -1; i <= 1; ++i) {
                    for (int k = -1; k <= 1; ++k) {
                        sum += of.at(azimuth + i, std::clamp(step + k, 0, kPolarSteps - 1));
                    }
                }
                return sum / 9;
            });
        };
        const Map darkness = smooth(spread(0));
        const Map tint = smooth(Map([&](int azimuth, int step) {
            return std::hypot(tints[0].at(azimuth, step), tints[1].at(azimuth, step));
        }));
        const float usual = std::max(kLeastUsual, darkness.median(kRoomBegins, kRoomEnds));
        const float usualTint = std::max(kLeastUsual, tint.median(kRoomBegins, kRoomEnds));
        return Map([&](int azimuth, int step) {
            return std::min(darkness.at(azimuth, step) / usual, tint.at(azimuth, step) / usualTint);
        });
    }

    /// The mean of unlikeness over some steps. Range: begin < end.
    float unlikeOver(int azimuth, int begin, int end) const {
        constexpr float kMost = 1.5F;
        float sum = 0;
        for (int step = begin; step < end; ++step) {
            sum += std::min(kMost, m_unlike.at(azimuth, std::clamp(step, 0, kPolarSteps - 1)));
        }
        return sum / static_cast<float>(end - begin);
    }

    /// Whether most photos show the same edge, which an edge of the room would not be.
    bool isCarried(int azimuth, int step) const {
        std::array<std::vector<float>, 3> parts; // the slope's, and how far the edge moves in a line
        for (const Below& photo : m_photos) {
            const Eigen::Vector2f& slope = photo.slope.at(azimuth, step);
            parts[0].push_back(slope.x());
            parts[1].push_back(slope.y());
        }
        const Eigen::Vector2f usual(quantileInPlace(parts[0], 0.5), quantileInPlace(parts[1], 0.5));
        std::size_t alike = 0;
        const std::array<Eigen::Vector3d, 2> ways = tangents(azimuth, step);
        for (const Below& photo : m_photos) {
            const bool isAlike = (photo.slope.at(azimuth, step) - usual).norm() < kDeviation * usual.norm();
            alike += isAlike ? 1 : 0;
            parts[2].push_back(std::abs(usual.x() * static_cast<float>(photo.line.dot(ways[0])) +
                                        usual.y() * static_cast<float>(photo.line.dot(ways[1]))));
        }
        return usual.norm() > (m_isInLine ? kEdgeInLine : kEdge) &&
               static_cast<double>(alike) >= kAgreeing * static_cast<double>(m_photos.size()) &&
               (!m_isInLine ||
                (step < kEndInLine && quantileInPlace(parts[2], 0.5) > kAcrossLine * usual.norm())) &&
               unlikeOver(azimuth, step - 4, step) < kAlike;
    }

    /// Where the colour of most photos changes, from what they carry along to what differs between them; or
    /// of nearly all, on a plain floor. wobble: steps by which the border is elsewhere from photo to photo.
    Edges changes(int wobble) const {
        const Map share([&](int azimuth, int step) {
            float count = 0;
            for (const Below& photo : m_photos) {
                float most = 0;
                for (int k = std::max(0, step - wobble); k <= std::min(kPolarSteps - 1, step + wobble); ++k) {
                    most = std::max(most, photo.change.at(azimuth, k));
                }
                count += most > kChange ? 1.0F : 0.0F;
            }
            return count / static_cast<float>(m_photos.size());
        });
        const float usual = share.median(kRoomBegins, kEndOfChanges);
        const float least = std::max(static_cast<float>(kAgreeing), 0.5F + 0.5F * usual);
        return Edges([&](int azimuth, int step) {
            return step < kEndOfChanges && share.at(azimuth, step) >= least &&
                   unlikeOver(azimuth, step - 6, step - 1) < kAlike &&
                   (unlikeOver(azimuth, step + 2, step + 8) > kUnlike ||
                    share.at(azimuth, step) > kNearlyAll);
        });
    }

    /// The edges with others at two azimuths beside them, of which so many stand on each other at least.
    static Edges joined(const Edges& edges, int thick) {
        constexpr int kReach = 2;
        return Edges([&](int azimuth, int step) {
            int beside = 0;
            int own = 0;
            for (int i = -kReach; i <= kReach; ++i) {
                int count = 0;
                for (int k = std::max(0, step - kReach); k <= std::min(kPolarSteps - 1, step + kReach); ++k) {
                    count += edges.at(azimuth + i, k) != 0 ? 1 : 0;
                }
                beside += count > 0 && i != 0 ? 1 : 0;
                own = i == 0 ? count : own;
            }
            return edges.at(azimuth, step) != 0 && own >= thick && beside >= 2;
        });
    }

    /// The outermost edge at each azimuth; -1 if there is none.
    using Borders = std::array<int, kAzimuths>;

    static Borders borders(const Edges& edges) {
        Borders result{};
        for (int azimuth = 0; azimuth < kAzimuths; ++azimuth) {
            int step = kPolarSteps - 1;
            while (step >= kFirstStep && edges.at(azimuth, step) == 0) {
                --step;
            }
            result[static_cast<std::size_t>(azimuth)] = step < kFirstStep ? -1 : step;
        }
        return result;
    }

    static std::ptrdiff_t count(const Borders& borders) {
        return std::ranges::count_if(borders, [](int step) { return step >= 0; });
    }

    /// Whether hardly any photo shows the border exactly where the others do, as with a hand.
    static bool wobbles(const Borders& exact, const Borders& changed) {
        constexpr int kNear = 6;
        constexpr double kLeastShareExact = 0.25;
        std::ptrdiff_t near = 0;
        for (std::size_t i = 0; i < exact.size(); ++i) {
            near += changed[i] >= 0 && exact[i] >= changed[i] - kNear ? 1 : 0;
        }
        return static_cast<double>(near) < kLeastShareExact * static_cast<double>(count(changed));
    }

    /// The first step from which photos differ for some.
    int firstUnlike(int azimuth) const {
        constexpr int kFew = 5;
        int step = 0;
        while (step < kPolarSteps && unlikeOver(azimuth, step, step + kFew) < kUnlike) {
            ++step;
        }
        return step;
    }

    bool m_isInLine;
    std::vector<Below> m_photos;
    Map m_unlike; ///< See unlikeness().
};

/// The way of the line that the photos stand in; zero if they stand to its sides. Nothing if all stand at one
/// place.
std::optional<Eigen::Vector3d> lineOf(std::span<const PosedPicture> photos) {
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const PosedPicture& photo : photos) {
        mean += photo.roomFromPhoto.translation.head<2>() / static_cast<double>(photos.size());
    }
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    for (const PosedPicture& photo : photos) {
        const Eigen::Vector2d offset = photo.roomFromPhoto.translation.head<2>() - mean;
        spread += offset * offset.transpose() / static_cast<double>(photos.size());
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(spread);
    const auto isSpread = [&](int axis) { return axes.eigenvalues()[axis] >= kLeastSpreadM * kLeastSpreadM; };
    if (!isSpread(1)) {
        return std::nullopt;
    }
    Eigen::Vector3d line = Eigen::Vector3d::Zero();
    if (!isSpread(0)) {
        line.head<2>() = axes.eigenvectors().col(1);
    }
    return line;
}

/// The quantile of each angle and so many to either side.
std::array<float, kAzimuths> quantilesAbout(const std::array<float, kAzimuths>& of, std::size_t reach,
                                            double share) {
    constexpr auto kAll = static_cast<std::size_t>(kAzimuths);
    std::array<float, kAll> result{};
    for (std::size_t i = 0; i < kAll; ++i) {
        std::vector<float> beside;
        for (std::size_t k = kAll - reach; k <= kAll + reach; ++k) {
            beside.push_back(of[(i + k) % kAll]);
        }
        result[i] = quantileInPlace(beside, share);
    }
    return result;
}

/// The median, so that no single edge makes a spike. Then narrow dents are closed, where the floor happens to
/// look like the cart. At last the greatest of those beside, so that no corner looks out.
std::array<float, kAzimuths> smoothed(const std::array<float, kAzimuths>& from) {
    const auto closed =
        quantilesAbout(quantilesAbout(quantilesAbout(from, kSmoothing, 0.5), kDent, 1), kDent, 0);
    return quantilesAbout(closed, kSmoothing, 1);
}

} // namespace

bool CarriedThings::empty() const {
    return std::all_of(m_reachRad.begin(), m_reachRad.end(), [](float reach) { return reach <= 0; });
}

double CarriedThings::share() const {
    double sum = 0;
    for (const float reach : m_reachRad) {
        sum += (1 - std::cos(reach)) / 2;
    }
    return sum / kAzimuths;
}

double CarriedThings::depthInside(const Eigen::Vector3d& pInPhoto) const {
    return depthInside(std::atan2(pInPhoto.y(), pInPhoto.x()),
                       std::atan2(pInPhoto.head<2>().norm(), -pInPhoto.z()));
}

double CarriedThings::depthInside(double azimuth, double angle) const {
    const double at = indexOf(azimuth) + kAzimuths;
    const auto before = static_cast<std::size_t>(at);
    const double share = at - static_cast<double>(before);
    return (1 - share) * m_reachRad[before % kAzimuths] + share * m_reachRad[(before + 1) % kAzimuths] -
           angle;
}

CarriedThings carriedThings(std::span<const PosedPicture> photos) {
    for (const PosedPicture& photo : photos) {
        if (photo.picture == nullptr || photo.picture->empty()) {
            throw Error(ErrorKind::InvalidInput,
                        "Could not look for what the camera carries along: a picture is empty.");
        }
    }
    const auto line = lineOf(photos);
    if (photos.size() < kFewestPhotos || !line) {
        return {};
    }
    const auto found =
        Comparison(spreadEvenly(std::vector(photos.begin(), photos.end()), kMostPhotos), *line).reach();
    if (!found) {
        return {};
    }
    std::array<float, kAzimuths> reach = smoothed(*found);
    for (float& angle : reach) {
        angle += angle > 0 ? static_cast<float>(kMarginRad) : 0.0F;
    }
    const CarriedThings things(reach);
    return things.share() < kLeastShare ? CarriedThings() : things;
}

} // namespace spherewalk::scene
