// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/positions_csv.h"

#include "parts/csv.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/photo/picture_file.h"

#include <algorithm>
#include <array>
#include <set>

namespace spherewalk::jobs {

namespace {

constexpr int kAbsent = -1;

[[noreturn]] void refusePositions(const std::string& source, const std::string& what) {
    throw Error(ErrorKind::InvalidInput, text("Could not read the positions ", source, ": ", what, "."));
}

struct Columns {
    int file, x, y, z, depth, yaw;
    std::array<int, 4> quaternion; ///< w, x, y, z
};

Columns columnsOf(const CsvLine& header, const std::string& source, bool mayLackPlaces) {
    const auto find = [&](std::string_view name) {
        const auto found = std::find(header.fields.begin(), header.fields.end(), name);
        return found == header.fields.end() ? kAbsent : static_cast<int>(found - header.fields.begin());
    };
    const auto need = [&](std::string_view name) {
        const int column = find(name);
        const bool mayBeAbsent = mayLackPlaces && name != "file";
        if (column == kAbsent && !mayBeAbsent) {
            refusePositions(source, text("the column ", name,
                                         " is missing; the first line should name file,x_m,y_m,z_m"));
        }
        return column;
    };
    const Columns columns{need("file"),
                          need("x_m"),
                          need("y_m"),
                          need("z_m"),
                          find("depth"),
                          find("yaw_deg"),
                          {find("qw"), find("qx"), find("qy"), find("qz")}};
    const auto absent = std::count(columns.quaternion.begin(), columns.quaternion.end(), kAbsent);
    if (absent != 0 && absent != 4) {
        refusePositions(source, "of the columns qw,qx,qy,qz some are missing");
    }
    if (absent == 0 && columns.yaw != kAbsent) {
        refusePositions(source, "it has both yaw_deg and qw,qx,qy,qz; leave one out");
    }
    return columns;
}

/// One record, with its place for sentences.
class Record {
  public:
    Record(const CsvLine& line, const std::string& source) : m_line(line), m_source(source) {}

    std::string field(int column) const {
        const auto index = static_cast<std::size_t>(column);
        return column == kAbsent || index >= m_line.fields.size() ? "" : m_line.fields[index];
    }

    double number(int column, std::string_view what) const {
        const auto value = parseNumber(field(column));
        if (!value || std::abs(*value) > 1e8) {
            refusePositions(m_source, text("line ", m_line.number, ": ", what, " is \"",
                                           printable(field(column)), "\", not a number"));
        }
        return *value;
    }

    std::string place() const { return text("line ", m_line.number, " of ", m_source); }

  private:
    const CsvLine& m_line;
    const std::string& m_source;
};

std::optional<Eigen::Quaterniond> rotationOf(const Record& record, const Columns& columns) {
    if (!record.field(columns.yaw).empty()) {
        return yawRotation(Degrees(record.number(columns.yaw, "yaw_deg")));
    }
    const auto& [w, x, y, z] = columns.quaternion;
    if (record.field(w).empty() && record.field(x).empty() && record.field(y).empty() &&
        record.field(z).empty()) {
        return std::nullopt;
    }
    return checkedQuaternion(record.number(w, "qw"), record.number(x, "qx"), record.number(y, "qy"),
                             record.number(z, "qz"), record.place());
}

} // namespace

std::vector<PhotoPosition> parsePositions(std::string_view csv, const std::string& source,
                                          bool mayLackPlaces) {
    const std::vector<CsvLine> lines = parseCsv(csv, source);
    if (lines.empty()) {
        refusePositions(source, "it is empty");
    }
    const Columns columns = columnsOf(lines.front(), source, mayLackPlaces);
    std::vector<PhotoPosition> result;
    std::set<std::string> files;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        const Record record(lines[i], source);
        PhotoPosition position;
        position.line = lines[i].number;
        position.file = record.field(columns.file);
        if (!isSafeRelativePath(position.file)) {
            refusePositions(source, text("line ", position.line, ": \"", printable(position.file),
                                         "\" is not the name of a file in the photos' folder"));
        }
        position.depthFile = record.field(columns.depth);
        if (!position.depthFile.empty() && !isSafeRelativePath(position.depthFile)) {
            refusePositions(source, text("line ", position.line, ": \"", printable(position.depthFile),
                                         "\" is not the name of a file in the photos' folder"));
        }
        if (!files.insert(position.file).second) {
            refusePositions(source, text("line ", position.line, ": ", position.file, " is listed twice"));
        }
        position.roomFromPhoto = rotationOf(record, columns);
        position.isPlaced = !mayLackPlaces || position.roomFromPhoto || !record.field(columns.x).empty() ||
                            !record.field(columns.y).empty() || !record.field(columns.z).empty();
        if (position.isPlaced) {
            position.positionM = {record.number(columns.x, "x_m"), record.number(columns.y, "y_m"),
                                  record.number(columns.z, "z_m")};
        }
        result.push_back(std::move(position));
    }
    if (result.empty()) {
        refusePositions(source, "it lists no photos");
    }
    return result;
}

std::vector<PhotoPosition> readPositions(const std::filesystem::path& file, bool mayLackPlaces) {
    constexpr std::uint64_t kLargest = 256ULL << 20;
    return parsePositions(readTextFile(file, kLargest), file.string(), mayLackPlaces);
}

std::vector<RobotPicture> readRobotPictures(const std::filesystem::path& csv, bool mayLackPoses) {
    std::vector<RobotPicture> pictures;
    for (const PhotoPosition& line : readPositions(csv, mayLackPoses)) {
        if (!line.roomFromPhoto && line.isPlaced) {
            throw Error(ErrorKind::InvalidInput,
                        text("Could not use the robot's pictures ", csv.string(), ": line ", line.line,
                             " states no rotation; give qw,qx,qy,qz of the optical frame."));
        }
        RobotPicture picture;
        picture.file = csv.parent_path() / line.file;
        picture.depthFile = line.depthFile.empty() ? "" : csv.parent_path() / line.depthFile;
        picture.hasPose = line.isPlaced;
        if (line.isPlaced) {
            picture.roomFromCamera = {*line.roomFromPhoto, line.positionM};
        }
        pictures.push_back(std::move(picture));
    }
    return pictures;
}

RgbImage readRobotPicture(const RobotPicture& picture, const CameraModel& camera) {
    RgbImage result = photo::readPicture(picture.file);
    if (result.width() != camera.width() || result.height() != camera.height()) {
        throw Error(ErrorKind::InvalidInput,
                    text("The picture ", picture.file.string(), " has ", result.width(), " x ",
                         result.height(), " pixels, not the camera's ", camera.width(), " x ",
                         camera.height(), "."));
    }
    return result;
}

} // namespace spherewalk::jobs
