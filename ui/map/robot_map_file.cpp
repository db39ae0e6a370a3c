// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/map/robot_map_file.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"

#include <QFileInfo>
#include <yaml-cpp/yaml.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace spherewalk::ui {

namespace {

[[noreturn]] void refuseMap(const QString& file, const std::string& what) {
    throw Error(ErrorKind::Corrupt, text("Could not read the map ", file.toStdString(), ": ", what,
                                         "; it should be a YAML file of map_server."));
}

template <class Value>
Value entry(const YAML::Node& root, const char* key, const QString& file) {
    try {
        return root[key].as<Value>();
    } catch (const YAML::Exception&) {
        refuseMap(file, text("the entry ", key, " is missing or wrong"));
    }
}

template <class Value>
Value entry(const YAML::Node& root, const char* key, const QString& file, const Value& usual) {
    return root[key] ? entry<Value>(root, key, file) : usual;
}

RobotMapFile::Mode modeOf(const std::string& word, const QString& file) {
    if (word == "trinary") {
        return RobotMapFile::Mode::Trinary;
    }
    if (word == "scale") {
        return RobotMapFile::Mode::Scale;
    }
    if (word != "raw") {
        refuseMap(file, text("the mode ", word, " is not known"));
    }
    return RobotMapFile::Mode::Raw;
}

/// The grey that a pixel of this value is shown in.
std::uint8_t greyOf(const RobotMapFile& map, int value) {
    constexpr std::uint8_t kWall = 0;
    constexpr std::uint8_t kUnknown = 170;
    constexpr std::uint8_t kFloor = 255;
    if (map.mode == RobotMapFile::Mode::Raw) { // 0 to 100 are occupancies
        return value > 100 ? kUnknown : static_cast<std::uint8_t>(std::lround(255 - 2.55 * value));
    }
    const double occupancy = (map.isNegated ? value : 255 - value) / 255.0;
    if (occupancy > map.occupied) {
        return kWall;
    }
    if (occupancy < map.free) {
        return kFloor;
    }
    return map.mode == RobotMapFile::Mode::Trinary
               ? kUnknown
               : static_cast<std::uint8_t>(std::lround(255 * (1 - occupancy)));
}

} // namespace

RobotMapFile readRobotMap(const QString& yaml) {
    constexpr std::uint64_t kLargest = 1 << 20;
    YAML::Node root;
    try {
        root = YAML::Load(readTextFile(yaml.toStdString(), kLargest));
    } catch (const YAML::Exception&) {
        refuseMap(yaml, "it is not valid YAML");
    }
    if (!root.IsMap()) {
        refuseMap(yaml, "it is no list of entries");
    }
    RobotMapFile map;
    const QFileInfo image(QString::fromStdString(entry<std::string>(root, "image", yaml)));
    map.image = image.isAbsolute() ? image.filePath() : QFileInfo(yaml).path() + "/" + image.filePath();
    map.metresPerPixel = entry<double>(root, "resolution", yaml);
    const auto origin = entry<std::vector<double>>(root, "origin", yaml);
    if (!(map.metresPerPixel > 0) || origin.size() != 3) {
        refuseMap(yaml, "the resolution is not positive, or the origin is not [x, y, yaw]");
    }
    map.origin = {origin[0], origin[1]};
    map.yaw = Radians(origin[2]);
    const auto negate = entry<std::string>(root, "negate", yaml, "0");
    map.isNegated = negate != "0" && negate != "false";
    map.occupied = entry<double>(root, "occupied_thresh", yaml, map.occupied);
    map.free = entry<double>(root, "free_thresh", yaml, map.free);
    map.mode = modeOf(entry<std::string>(root, "mode", yaml, "trinary"), yaml);
    return map;
}

QImage mapPicture(const RobotMapFile& map, const QImage& pixels) {
    std::array<std::uint8_t, 256> greys{};
    for (std::size_t value = 0; value < greys.size(); ++value) {
        greys.at(value) = greyOf(map, static_cast<int>(value));
    }
    QImage picture(pixels.size(), QImage::Format_Grayscale8);
    for (int y = 0; y < pixels.height(); ++y) {
        const uchar* from = pixels.constScanLine(y);
        uchar* to = picture.scanLine(y);
        for (int x = 0; x < pixels.width(); ++x) {
            to[x] = greys[from[x]];
        }
    }
    return picture;
}

} // namespace spherewalk::ui
