// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/practice/truth.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>
#include <utility>

namespace spherewalk::practice {

namespace {

Json vectorJson(const Eigen::Vector3d& v) {
    return Json::array({v.x(), v.y(), v.z()});
}

Eigen::Vector3d vectorOf(const JsonReader& reader) {
    if (reader.arraySize(3) != 3) {
        reader.fail("expected three numbers");
    }
    return {reader.element(0).asNumber(), reader.element(1).asNumber(), reader.element(2).asNumber()};
}

std::string lineOf(const Truth& truth) {
    Json line;
    line["file"] = truth.file;
    line["url_path"] = truth.urlPath;
    line["shot"] = truth.shot;
    line["nominal_position_m"] = vectorJson(truth.nominalPositionM);
    line["position_m"] = vectorJson(truth.positionM);
    if (truth.roomFromPhoto) {
        const Eigen::Quaterniond& q = *truth.roomFromPhoto;
        line["roomFromPhoto"] = {{"w", q.w()}, {"x", q.x()}, {"y", q.y()}, {"z", q.z()}};
    } else {
        line["roomFromPhoto"] = nullptr;
    }
    line["time"] = truth.time;
    line["sha256"] = truth.sha256;
    line["options"] = truth.options;
    line["by_button"] = truth.byButton;
    return line.dump() + "\n";
}

Truth truthOf(const JsonReader& line) {
    Truth truth;
    truth.file = line.string("file");
    truth.urlPath = line.string("url_path");
    truth.shot = static_cast<int>(line.integer("shot", 1, 1 << 30));
    truth.nominalPositionM = vectorOf(line.member("nominal_position_m"));
    truth.positionM = vectorOf(line.member("position_m"));
    if (!line.isAbsent("roomFromPhoto")) {
        const JsonReader q = line.member("roomFromPhoto");
        truth.roomFromPhoto =
            checkedQuaternion(q.number("w"), q.number("x"), q.number("y"), q.number("z"), "a practice photo");
    }
    truth.time = line.string("time");
    truth.sha256 = line.string("sha256");
    if (!line.isAbsent("options")) {
        truth.options = line.member("options").value();
    }
    truth.byButton = !line.isAbsent("by_button") && line.boolean("by_button");
    return truth;
}

/// An open file that closes itself.
class Descriptor {
  public:
    explicit Descriptor(int descriptor) : m_descriptor(descriptor) {}

    ~Descriptor() {
        if (m_descriptor >= 0) {
            ::close(m_descriptor);
        }
    }

    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    int get() const { return m_descriptor; }

  private:
    int m_descriptor;
};

} // namespace

TruthFile::TruthFile(std::filesystem::path file) : m_file(std::move(file)) {
}

void TruthFile::append(const Truth& truth) const {
    const auto check = [&](bool good) {
        if (!good) {
            const int code = errno;
            throw Error(code == ENOSPC || code == EDQUOT ? ErrorKind::Full : ErrorKind::Io,
                        text("Could not write the practice camera's truth to ", m_file.string(), ": ",
                             std::string(std::strerror(code)), "."));
        }
    };
    const Descriptor file(::open(m_file.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0666));
    check(file.get() >= 0);
    const std::string line = lineOf(truth);
    for (std::size_t done = 0; done < line.size();) {
        const ssize_t wrote = ::write(file.get(), line.data() + done, line.size() - done);
        check(wrote >= 0 || errno == EINTR);
        done += wrote > 0 ? static_cast<std::size_t>(wrote) : 0;
    }
    check(::fsync(file.get()) == 0);
    const auto folder = std::filesystem::absolute(m_file).parent_path();
    syncFolder(folder);
}

std::vector<Truth> readTruth(const std::filesystem::path& file) {
    const std::string content = readTextFile(file, 256ULL << 20);
    std::vector<Truth> truths;
    std::size_t begin = 0;
    for (std::size_t end = content.find('\n'); end != std::string::npos; end = content.find('\n', begin)) {
        const std::string source = text(file.string(), ", line ", truths.size() + 1);
        const Json line = parseJson(std::string_view(content).substr(begin, end - begin), source);
        truths.push_back(truthOf(JsonReader(line, source)));
        begin = end + 1;
    }
    return truths;
}

} // namespace spherewalk::practice
