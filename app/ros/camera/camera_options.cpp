// SPDX-License-Identifier: GPL-3.0-or-later
#include "camera_options.h"

#include "spherewalk/base/enum_names.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <vector>

namespace spherewalk::ros {

namespace {

simulator::OverlayOptions overlayOptions(const NodeOptions& options) {
    simulator::OverlayOptions overlay;
    overlay.by = simulator::objectsBy(options.overlay);
    overlay.roomLabels.clear();
    for (const int label : options.roomLabels) {
        if (label < 0 || label > 255) {
            throw Error(ErrorKind::InvalidInput,
                        text("A label of the room is ", label, "; there are 0 to 255."));
        }
        overlay.roomLabels.push_back(static_cast<std::uint8_t>(label));
    }
    if (!(options.overlayWait >= 0 && options.overlayWait <= 10)) {
        throw Error(ErrorKind::InvalidInput, "A frame can wait 0 to 10 s for its overlay.");
    }
    overlay.wait = std::chrono::duration_cast<Stamp>(std::chrono::duration<double>(options.overlayWait));
    overlay.interpolatesPoses = true; // as tf does for the stamp of a picture
    return overlay;
}

constexpr EnumNames<DepthEncoding, 3> kDepthEncodings{
    {{DepthEncoding::None, "none"}, {DepthEncoding::Metres, "32FC1"}, {DepthEncoding::Millimetres, "16UC1"}}};

/// Empty where there is none.
std::string environment(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
}

/// The folders of a path variable.
std::vector<std::filesystem::path> foldersIn(const char* variable) {
    std::vector<std::filesystem::path> folders;
    const std::string value = environment(variable);
    for (std::size_t begin = 0; begin < value.size();) {
        const std::size_t end = std::min(value.find(':', begin), value.size());
        if (end > begin) {
            folders.emplace_back(value.substr(begin, end - begin));
        }
        begin = end + 1;
    }
    return folders;
}

/// The folder with the files of an installed package of ROS 2, else of one of ROS 1.
std::filesystem::path folderOfPackage(const std::string& package) {
    for (const std::filesystem::path& prefix : foldersIn("AMENT_PREFIX_PATH")) {
        if (exists(prefix / "share/ament_index/resource_index/packages" / package)) {
            return prefix / "share" / package;
        }
    }
    for (const std::filesystem::path& folder : foldersIn("ROS_PACKAGE_PATH")) {
        if (exists(folder / package / "package.xml")) {
            return folder / package;
        }
        if (folder.filename() == package && exists(folder / "package.xml")) {
            return folder;
        }
    }
    throw Error(ErrorKind::NotFound, text("The package ", printable(package),
                                          " is neither in AMENT_PREFIX_PATH nor in ROS_PACKAGE_PATH: source "
                                          "the workspace that has it."));
}

void replaceAll(std::string& url, std::string_view variable, std::string_view value) {
    for (std::size_t at = url.find(variable); at != std::string::npos;
         at = url.find(variable, at + value.size())) {
        url.replace(at, variable.size(), value);
    }
}

std::filesystem::path fileInPackage(const std::string& url, std::string_view packageAndFile) {
    const std::size_t slash = packageAndFile.find('/');
    if (slash == 0 || slash >= packageAndFile.size() - 1) {
        throw Error(ErrorKind::InvalidInput, text("The URL ", printable(url),
                                                  " names no file of a package: write package://NAME/FILE."));
    }
    return folderOfPackage(std::string(packageAndFile.substr(0, slash))) / packageAndFile.substr(slash + 1);
}

} // namespace

std::filesystem::path fileOf(std::string_view url, std::string_view name) {
    std::string resolved(url);
    const std::string home = environment("ROS_HOME");
    replaceAll(resolved, "${NAME}", name);
    replaceAll(resolved, "${ROS_HOME}", home.empty() ? environment("HOME") + "/.ros" : home);
    constexpr std::string_view kMark = "://";
    const std::size_t mark = resolved.find(kMark);
    std::string kind = resolved.substr(0, mark);
    std::transform(kind.begin(), kind.end(), kind.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    if (mark == std::string::npos || kind.find('/') != std::string::npos) {
        return resolved;
    }
    const std::string_view rest = std::string_view(resolved).substr(mark + kMark.size());
    if (kind == "file") {
        return rest;
    }
    if (kind == "package") {
        return fileInPackage(resolved, rest);
    }
    throw Error(ErrorKind::InvalidInput, text("The URL ", printable(resolved),
                                              " cannot be read: write a path, file:// or package://."));
}

DepthEncoding depthEncoding(std::string_view name) {
    return valueOf(kDepthEncodings, "The encoding of depth images", name);
}

simulator::CameraOptions cameraOptions(const NodeOptions& options) {
    if (options.roomFrame.empty() || options.cameraFrame.empty() ||
        options.roomFrame == options.cameraFrame) {
        throw Error(ErrorKind::InvalidInput,
                    "The frames of the room and of the camera need names, and not the same one.");
    }
    if (options.threads < 0 || options.cacheMb < 1) {
        throw Error(ErrorKind::InvalidInput, "The number of threads is 0 or more, the cache 1 MB or more.");
    }
    simulator::CameraOptions camera;
    if (options.scene != "auto") {
        camera.view.scene = render::sceneKind(options.scene);
    }
    camera.view.sampling = render::sampling(options.sampling);
    camera.view.threads = options.threads;
    camera.stream.late = render::latePolicy(options.late);
    camera.mounting.axes = simulator::CameraAxes::Optical;
    camera.rateHz = options.rate;
    camera.pace = simulator::pace(options.pace);
    if (options.overlay != "none") {
        camera.overlay = overlayOptions(options);
        camera.wantsLabels = true;
    }
    camera.wantsDepth = depthEncoding(options.depth) != DepthEncoding::None;
    if (!options.sensor.empty()) {
        camera.sensor = render::readSensor(options.sensor);
    }
    camera.validate();
    return camera;
}

} // namespace spherewalk::ros
