// SPDX-License-Identifier: GPL-3.0-or-later
/// How far what `export --format` wrote of a place is from the truth: spherewalk_place_truth PLACE DATASET
/// EXPORT PLACE: see practicePlace() and scannedPlace(). EXPORT: a folder with surface.ply, map.yaml or
/// world.sdf. Of a practice room, the depths of the dataset's photos are compared, too.
#include "known_place.h"
#include "ply_reader.h"
#include "random.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/statistics.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/render/scene_depth.h"

#include <cmath>
#include <iostream>
#include <iterator>
#include <map>
#include <numbers>
#include <sstream>
#include <unordered_map>

namespace spherewalk::campaign {
namespace {

constexpr double kNearM = 0.04;

/// Points in cells, for the question whether one is near.
class NearPoints {
  public:
    explicit NearPoints(const std::vector<test::PlyVertex>& vertices) {
        for (const test::PlyVertex& vertex : vertices) {
            m_cells[cellOf(vertex.pInRoom)].push_back(vertex.pInRoom);
        }
    }

    bool hasNear(const Eigen::Vector3d& place) const {
        for (int i = 0; i < 27; ++i) {
            const Eigen::Vector3d aside(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
            const auto found = m_cells.find(cellOf(place + kNearM * aside));
            if (found == m_cells.end()) {
                continue;
            }
            for (const Eigen::Vector3d& point : found->second) {
                if ((point - place).norm() <= kNearM) {
                    return true;
                }
            }
        }
        return false;
    }

  private:
    static std::uint64_t cellOf(const Eigen::Vector3d& point) {
        const auto cell = [&](int axis) {
            return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(point[axis] / kNearM)) +
                                              1000000);
        };
        return (cell(0) << 42U) + (cell(1) << 21U) + cell(2);
    }

    std::unordered_map<std::uint64_t, std::vector<Eigen::Vector3d>> m_cells;
};

void tellErrors(const KnownPlace& place, const std::vector<test::PlyVertex>& vertices) {
    constexpr std::size_t kMostVertices = 20000;
    const std::size_t step = std::max<std::size_t>(vertices.size() / kMostVertices, 1);
    std::map<int, std::vector<double>> errors;
    int unknown = 0;
    for (std::size_t i = 0; i < vertices.size(); i += step) {
        const double error = place.distanceM(vertices[i].pInRoom);
        unknown += error < 0 ? 1 : 0;
        for (const int least : {1, 2, 3}) {
            if (error >= 0 && vertices[i].photos >= least) {
                errors[least].push_back(error);
            }
        }
    }
    std::cout << "surface: " << vertices.size() << " vertices, each " << step
              << "th is compared; the truth knows "
              << "nothing of " << unknown << "\n";
    for (const auto& [photos, some] : errors) {
        const auto within = [&, &distances = some](double share) {
            return fixed(1000 * std::min(quantile(distances, share), 1.0), 1);
        };
        std::cout << "  " << photos << " photos or more: " << some.size() << " vertices, median "
                  << within(0.5) << " mm, 95 % within " << within(0.95) << " mm, 99 % within " << within(0.99)
                  << " mm\n";
    }
}

/// The share of all directions about the photos in which there is a vertex near the truth.
void tellCompleteness(const KnownPlace& place, const std::vector<test::PlyVertex>& vertices) {
    const NearPoints near(vertices);
    double all = 0;
    double twice = 0;
    double found = 0;
    double foundTwice = 0;
    for (const KnownPlace::SeenPoint& point : place.seenPoints()) {
        const bool isTwice = place.sights(point.place) > 1;
        const double isFound = near.hasNear(point.place) ? point.weight : 0;
        all += point.weight;
        found += isFound;
        twice += isTwice ? point.weight : 0;
        foundTwice += isTwice ? isFound : 0;
    }
    std::cout << "completeness: " << fixed(100 * found / all, 1)
              << " % of all directions have a vertex within 40 mm of the truth, "
              << fixed(100 * foundTwice / twice, 1) << " % of those that two photos have in sight\n";
}

/// A map as map.yaml and map.pgm say it.
struct Map {
    explicit Map(const std::filesystem::path& folder) {
        const std::string yaml = readTextFile(folder / "map.yaml");
        cellM = std::stod(yaml.substr(yaml.find("resolution:") + 11));
        const std::size_t origin = yaml.find("origin: [") + 9;
        originM.x() = std::stod(yaml.substr(origin));
        originM.y() = std::stod(yaml.substr(yaml.find(',', origin) + 1));
        std::istringstream pgm(readTextFile(folder / "map.pgm"));
        std::string magic;
        int most = 0;
        pgm >> magic >> width >> height >> most;
        pgm.get();
        cells.assign(std::istreambuf_iterator<char>(pgm), {});
    }

    int at(int x, int y) const {
        return static_cast<unsigned char>(cells[static_cast<std::size_t>(y * width + x)]);
    }

    Eigen::Vector2d middle(int x, int y) const {
        return originM + cellM * Eigen::Vector2d(x + 0.5, height - y - 0.5);
    }

    Eigen::Vector2d originM;
    double cellM = 0;
    int width = 0;
    int height = 0;
    std::vector<char> cells;
};

/// Of the cells whose floor so many photos have in sight, those that say within one cell what the truth says.
void tellMap(const KnownPlace& place, const Map& map, int leastPhotos) {
    constexpr int kOccupied = 0;
    constexpr int kFree = 254;
    int seen = 0;
    int right = 0;
    std::map<std::pair<int, bool>, int> wrong;
    for (int y = 1; y + 1 < map.height; ++y) {
        for (int x = 1; x + 1 < map.width; ++x) {
            const Eigen::Vector2d middle = map.middle(x, y);
            if (place.sights({middle.x(), middle.y(), 0}) < leastPhotos) {
                continue;
            }
            bool isRight = false;
            for (int i = 0; i < 9 && !isRight; ++i) {
                const bool truth = place.isOccupied(map.middle(x + i % 3 - 1, y + i / 3 - 1), map.cellM);
                isRight = map.at(x, y) == (truth ? kOccupied : kFree);
            }
            ++seen;
            right += isRight ? 1 : 0;
            if (!isRight) {
                ++wrong[{map.at(x, y), place.isOccupied(middle, map.cellM)}];
            }
        }
    }
    std::cout << "map: " << seen << " cells of floor that " << leastPhotos
              << " photos or more have in sight, " << fixed(100.0 * right / seen, 2)
              << " % as the truth within one cell\n";
    for (const auto& [what, count] : wrong) {
        std::cout << "  " << count << " cells are " << what.first << " and truly "
                  << (what.second ? "occupied" : "free") << "\n";
    }
}

/// Where a map says free, and the truth says that something stands there, by more than a cell.
void tellDanger(const KnownPlace& place, const Map& map) {
    constexpr int kFree = 254;
    int free = 0;
    int wrong = 0;
    for (int y = 1; y + 1 < map.height; ++y) {
        for (int x = 1; x + 1 < map.width; ++x) {
            if (map.at(x, y) != kFree) {
                continue;
            }
            bool isInside = true;
            for (int i = 0; i < 9 && isInside; ++i) {
                isInside = place.isOccupied(map.middle(x + i % 3 - 1, y + i / 3 - 1), map.cellM);
            }
            ++free;
            wrong += isInside ? 1 : 0;
        }
    }
    std::cout << "map: of " << free << " free cells " << wrong
              << " are truly occupied, and so is all about them\n";
}

/// What a level laser meets in an exported world: walls, and the furniture.
class World {
  public:
    World(render::RoomShape room, const std::filesystem::path& furniture)
        : m_room(std::move(room)), m_furniture(m_room.floorM + kLaserHeightM) {
        std::istringstream lines(readTextFile(furniture));
        std::vector<Eigen::Vector3d> points;
        for (std::string line; std::getline(lines, line);) {
            std::istringstream words(line);
            std::string word;
            words >> word;
            if (word == "v") {
                Eigen::Vector3d& point = points.emplace_back();
                words >> point.x() >> point.y() >> point.z();
            } else if (word == "f") {
                std::array<Eigen::Vector3d, 3> corners;
                for (Eigen::Vector3d& corner : corners) {
                    words >> word;
                    corner = points.at(std::stoul(word) - 1);
                }
                m_furniture.cut(corners);
            }
        }
    }

    double rangeM(const Eigen::Vector3d& from, const Eigen::Vector3d& along) const {
        return std::min(1 / render::inverseDistance(m_room, from, along),
                        m_furniture.rangeM(from.head<2>(), along.head<2>()));
    }

  private:
    render::RoomShape m_room;
    Slice m_furniture;
};

/// A laser of 360 beams at 100 places that some photo sees.
void tellLaser(const KnownPlace& known, const render::RoomShape& room,
               const std::filesystem::path& furniture) {
    constexpr int kPlaces = 100;
    constexpr int kBeams = 360;
    constexpr double kGoalM = 0.06;
    const World world(room, furniture);
    const Bounds2 around = bounds(room.outline);
    test::Random random(25);
    std::vector<double> errors;
    double nearer = 0;
    double farther = 0;
    for (int i = 0; i < kPlaces;) {
        const Eigen::Vector3d place(random.uniform(around.least.x(), around.greatest.x()),
                                    random.uniform(around.least.y(), around.greatest.y()), kLaserHeightM);
        if (!known.isSeenThrough(place) || known.clearanceM(place) < 0.2) {
            continue;
        }
        for (int beam = 0; beam < kBeams; ++beam) {
            const double angle = beam * 2 * std::numbers::pi / kBeams;
            const Eigen::Vector3d along(std::cos(angle), std::sin(angle), 0);
            const double truthM = known.laserM(place, along);
            if (std::isfinite(truthM)) {
                const double rangeM = world.rangeM(place, along);
                errors.push_back(std::abs(rangeM - truthM));
                nearer += rangeM < truthM - kGoalM ? 1 : 0;
                farther += rangeM > truthM + kGoalM ? 1 : 0;
            }
        }
        ++i;
    }
    const auto count = static_cast<double>(errors.size());
    std::cout << "laser: " << errors.size() << " of " << kPlaces * kBeams << " beams, median "
              << fixed(1000 * quantile(errors, 0.5), 1) << " mm, 90 % within "
              << fixed(1000 * quantile(errors, 0.9), 1) << " mm, 95 % within "
              << fixed(1000 * quantile(errors, 0.95), 1) << " mm; " << fixed(100 * nearer / count, 1)
              << " % too near and " << fixed(100 * farther / count, 1) << " % too far by more than 60 mm\n";
}

/// How far depths are from the truth, as a share of the distance. Pixels count by their solid angle.
struct DepthErrors {
    double area = 0;
    double off = 0;    ///< By more than 5 %.
    double farOff = 0; ///< By more than 20 %.
    std::vector<double> errors;

    void add(double error, double pixelArea) {
        area += pixelArea;
        off += error > 0.05 ? pixelArea : 0;
        farOff += error > 0.2 ? pixelArea : 0;
        errors.push_back(error);
    }

    std::string told() const {
        return errors.empty() ? "none"
                              : text("median ", fixed(100 * quantile(errors, 0.5), 2), " %, ",
                                     fixed(100 * off / area, 1), " % off by more than 5 %, ",
                                     fixed(100 * farOff / area, 1), " % by more than 20 %");
    }
};

void tellDepths(const KnownPlace& place, const render::Dataset& dataset) {
    constexpr int kEvery = 4;
    std::map<bool, DepthErrors> errors;
    const render::DatasetInfo& info = dataset.info();
    for (std::size_t i = 0; i < info.photos.size(); ++i) {
        const render::DatasetPhoto& photo = info.photos[i];
        if (photo.depth.empty()) {
            continue;
        }
        const auto map = render::DepthMap::read(dataset.folder() / photo.depth);
        const EquirectSize size{map.width(), map.height()};
        for (int y = kEvery / 2; y < size.height; y += kEvery) {
            for (int x = kEvery / 2; x < size.width; x += kEvery) {
                const Eigen::Vector3d way = direction(size, Eigen::Vector2d(x, y));
                const double truthM = place.depthM(photo.roomFromPhoto * photo.lenses.place(way),
                                                   photo.roomFromPhoto.rotation * way);
                if (std::isfinite(truthM)) {
                    const double depthM = 1 / static_cast<double>(*map.inverseM().at(x, y));
                    errors[*map.sure().at(x, y) != 0].add(std::abs(depthM / truthM - 1),
                                                          way.head<2>().norm());
                }
            }
        }
    }
    const double all = errors[false].area + errors[true].area;
    if (all > 0) {
        std::cout << "depths: " << fixed(100 * errors[true].area / all, 1)
                  << " % of all directions are sure; of them " << errors[true].told() << "; of the others "
                  << errors[false].told() << "\n";
    }
}

void tell(const std::string& name, const std::filesystem::path& dataset,
          const std::filesystem::path& folder) {
    const render::Dataset opened = render::Dataset::open(dataset);
    const render::DatasetInfo& info = opened.info();
    const std::unique_ptr<KnownPlace> place =
        std::filesystem::exists(std::filesystem::path(name) / "truth.json") ? scannedPlace(name)
                                                                            : practicePlace(name, info);
    tellDepths(*place, opened);
    if (std::filesystem::exists(folder / "surface.ply")) {
        const auto vertices = test::readPly(folder / "surface.ply").vertices;
        tellErrors(*place, vertices);
        tellCompleteness(*place, vertices);
    }
    if (std::filesystem::exists(folder / "map.yaml")) {
        const Map map(folder);
        tellMap(*place, map, 1);
        tellMap(*place, map, 2);
        tellDanger(*place, map);
    }
    if (std::filesystem::exists(folder / "furniture.obj")) {
        tellLaser(*place, info.roomShape.value(), folder / "furniture.obj");
    }
}

} // namespace
} // namespace spherewalk::campaign

int main(int argc, char** argv) {
    using namespace spherewalk;
    try {
        if (argc != 4) {
            throw Error(ErrorKind::InvalidInput, "Usage: spherewalk_place_truth PLACE DATASET EXPORT");
        }
        campaign::tell(argv[1], argv[2], argv[3]);
        return 0;
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return 1;
    }
}
