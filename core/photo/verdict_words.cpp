// SPDX-License-Identifier: GPL-3.0-or-later
#include "verdict_rules.h"

#include "spherewalk/base/text.h"
#include "spherewalk/photo/levelling.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::photo {

namespace {

constexpr int kEquirectangular = 1; ///< image type of the maker note

void addSize(Findings& findings, const Sketch& photo, const ExpectedSettings& expected) {
    if (expected.width && *expected.width != photo.width) {
        findings.push_back({Flaw::Size, Quality::Failed,
                            text("It is ", photo.width, " pixels wide instead of ", *expected.width,
                                 "; set the camera's size and take it again.")});
    }
}

void addKind(Findings& findings, const PhotoMetadata& metadata) {
    const auto& panorama = metadata.panorama;
    const bool isOther =
        (metadata.theta && metadata.theta->imageType.value_or(kEquirectangular) != kEquirectangular) ||
        (panorama && !panorama->projection.empty() && panorama->projection != "equirectangular");
    const bool isCropped = panorama && panorama->fullWidth && panorama->croppedWidth &&
                           *panorama->fullWidth != *panorama->croppedWidth;
    if (isOther || isCropped) {
        findings.push_back({Flaw::Kind, Quality::Failed,
                            "It says that it is no whole stitched sphere; switch stitching on in the camera "
                            "and take it again."});
    }
    const auto level = levelFromPhoto(metadata);
    if (!level) {
        return;
    }
    const double tilt = std::acos(std::clamp((*level * Eigen::Vector3d::UnitZ()).z(), -1.0, 1.0));
    constexpr Radians kUpsideDown = Degrees(90);
    constexpr Radians kLeaning = Degrees(15);
    if (tilt > kUpsideDown.value()) {
        findings.push_back({Flaw::UpsideDown, Quality::Failed,
                            "It says that the camera hung upside down; put it upright and take it again."});
    } else if (tilt > kLeaning.value()) {
        findings.push_back({Flaw::UpsideDown, Quality::Doubtful,
                            text("The camera leaned by ", fixed(Degrees(Radians(tilt)).value(), 0),
                                 " degrees; check its mount.")});
    }
}

/// Cameras write rounded times: 1/60 as 0.0166 or 0.017.
bool isSameExposure(double a, double b) {
    constexpr double kStops = 0.15;
    return std::abs(std::log2(a / b)) <= kStops;
}

void addSettings(Findings& findings, const PhotoMetadata& metadata, const ExpectedSettings& expected) {
    if (expected.exposureS && metadata.exposureS &&
        !isSameExposure(*metadata.exposureS, *expected.exposureS)) {
        findings.push_back({Flaw::Settings, Quality::Failed,
                            text("It was exposed for ", fixed(*metadata.exposureS, 4), " s instead of ",
                                 fixed(*expected.exposureS, 4), " s; take it again.")});
    }
    if (expected.iso && metadata.iso && *metadata.iso != *expected.iso) {
        findings.push_back(
            {Flaw::Settings, Quality::Failed,
             text("It was taken at ISO ", *metadata.iso, " instead of ", *expected.iso, "; take it again.")});
    }
    if (expected.hasFixedWhiteBalance && metadata.hasFixedWhiteBalance &&
        *metadata.hasFixedWhiteBalance != *expected.hasFixedWhiteBalance) {
        // Its colours say more: where they differ from the neighbours', that is found.
        findings.push_back(
            {Flaw::Settings, Quality::Doubtful,
             text("It was taken with ", *metadata.hasFixedWhiteBalance ? "a fixed" : "automatic",
                  " white balance, against the survey's settings; take it again if its colours "
                  "differ.")});
    }
}

} // namespace

void addWhatItSays(Findings& findings, const Sketch& photo, const PhotoMetadata& metadata,
                   const ExpectedSettings& expected) {
    addSize(findings, photo, expected);
    addKind(findings, metadata);
    addSettings(findings, metadata, expected);
}

} // namespace spherewalk::photo
