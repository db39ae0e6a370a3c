// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/geometry/trajectory.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"

#include <algorithm>
#include <iterator>
#include <optional>

namespace spherewalk {

namespace {

constexpr std::string_view kBlank = " \t\r";

/// All numbers of a line; nothing if one of its words is not a number.
std::optional<std::vector<double>> numbers(std::string_view line) {
    std::vector<double> result;
    for (std::size_t begin = line.find_first_not_of(kBlank); begin != std::string_view::npos;
         begin = line.find_first_not_of(kBlank)) {
        line.remove_prefix(begin);
        const std::string_view word = line.substr(0, line.find_first_of(kBlank));
        const std::optional<double> number = parseNumber(word);
        if (!number) {
            return std::nullopt;
        }
        result.push_back(*number);
        line.remove_prefix(word.size());
    }
    return result;
}

Rigid3 pose(const double* v, std::string_view whose) {
    return {checkedQuaternion(v[6], v[3], v[4], v[5], whose), {v[0], v[1], v[2]}};
}

} // namespace

Rigid3 parsePose(std::string_view input) {
    const auto values = numbers(input);
    if (!values || values->size() != 7) {
        throw Error(ErrorKind::InvalidInput,
                    text("The pose \"", printable(input), "\" is not seven numbers \"x y z qx qy qz qw\"."));
    }
    return pose(values->data(), "the pose");
}

std::vector<TimedPose> readTum(const std::filesystem::path& file) {
    constexpr std::uint64_t kLargest = 1ULL << 30;
    const std::string content = readTextFile(file, kLargest);
    std::vector<TimedPose> poses;
    std::string_view rest = content;
    for (int number = 1; !rest.empty(); ++number) {
        const std::string_view line = rest.substr(0, rest.find('\n'));
        rest.remove_prefix(std::min(rest.size(), line.size() + 1));
        const std::size_t begin = line.find_first_not_of(kBlank);
        if (begin == std::string_view::npos || line[begin] == '#') {
            continue;
        }
        const std::string place = text("line ", number, " of ", file.string());
        const auto values = numbers(line);
        if (!values || values->size() != 8) {
            throw Error(ErrorKind::InvalidInput,
                        text("Could not read the path: ", place, " is not \"time x y z qx qy qz qw\"."));
        }
        poses.push_back({values->front(), pose(values->data() + 1, place)});
    }
    if (poses.empty()) {
        throw Error(ErrorKind::InvalidInput,
                    text("Could not read the path: ", file.string(), " holds no pose."));
    }
    return poses;
}

Rigid3 poseAt(const std::vector<TimedPose>& path, double timeS) {
    if (path.size() == 1) {
        return path.front().roomFromCamera;
    }
    const auto isBefore = [](double time, const TimedPose& pose) { return time < pose.timeS; };
    const auto after = std::upper_bound(std::next(path.begin()), std::prev(path.end()), timeS, isBefore);
    const auto before = std::prev(after);
    const double share = (timeS - before->timeS) / (after->timeS - before->timeS);
    return interpolated(before->roomFromCamera, after->roomFromCamera, share);
}

std::string tumText(const std::vector<TimedPose>& poses) {
    std::string result = "# time x y z qx qy qz qw\n";
    for (const auto& [time, pose] : poses) {
        const Eigen::Vector3d& t = pose.translation;
        const Eigen::Quaterniond& q = pose.rotation;
        result += text(time, " ", t.x(), " ", t.y(), " ", t.z(), " ", q.x(), " ", q.y(), " ", q.z(), " ",
                       q.w(), "\n");
    }
    return result;
}

} // namespace spherewalk
