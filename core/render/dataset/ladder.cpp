// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/render/ladder.h"

#include "spherewalk/base/enum_names.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace spherewalk::render {

namespace {

constexpr EnumNames<SceneKind, 5> kSceneNames{{{SceneKind::None, "none"},
                                               {SceneKind::Sphere, "sphere"},
                                               {SceneKind::Room, "room"},
                                               {SceneKind::Depth, "depth"},
                                               {SceneKind::Blend, "blend"}}};

constexpr EnumNames<Sampling, 7> kSamplingNames{{{Sampling::Nearest, "nearest"},
                                                 {Sampling::Bilinear, "bilinear"},
                                                 {Sampling::Reduced, "reduced"},
                                                 {Sampling::Footprint, "footprint"},
                                                 {Sampling::Bicubic, "bicubic"},
                                                 {Sampling::Best, "best"},
                                                 {Sampling::Auto, "auto"}}};

/// A focal length that is longer by less changes no error worth mentioning.
constexpr double kLongerFocal = 1.05;
constexpr double kMostChoicePx = 1e6;

double numberUpTo(const JsonReader& reader, std::string_view key, bool mayBeZero) {
    const double value = reader.number(key);
    if (!(value <= kMostChoicePx) || value < 0 || (value == 0 && !mayBeZero)) {
        reader.member(key).fail(text("expected a number of pixels up to ", kMostChoicePx));
    }
    return value;
}

/// The value that the member's word stands for. Errors: Corrupt, with the member's path.
template <class Parse>
auto named(const JsonReader& reader, std::string_view key, Parse&& parse) {
    const std::string word = reader.string(key);
    try {
        return parse(word);
    } catch (const Error& error) {
        reader.member(key).fail(error.sentence());
    }
}

} // namespace

std::string_view name(SceneKind kind) {
    return nameOf(kSceneNames, kind);
}

SceneKind sceneKind(std::string_view name) {
    return valueOf(kSceneNames, "The scene model", name);
}

std::string_view name(Sampling sampling) {
    return nameOf(kSamplingNames, sampling);
}

Sampling sampling(std::string_view name) {
    return valueOf(kSamplingNames, "The sampling", name);
}

double minification(const CameraModel& camera, int photoWidth) {
    const CameraIntrinsics& k = camera.intrinsics();
    const Eigen::Vector2d centre(0.5 * (k.width - 1), 0.5 * (k.height - 1));
    const double perRadian = photoWidth / (2 * std::numbers::pi);
    double most = 0;
    for (const Eigen::Vector2d& step : {Eigen::Vector2d(0.5, 0), Eigen::Vector2d(0, 0.5)}) {
        const auto a = camera.ray(centre - step);
        const auto b = camera.ray(centre + step);
        if (a && b) {
            most = std::max(most, perRadian * (*a - *b).norm());
        }
    }
    return most;
}

int samplesPerAxis(Sampling sampling, double minification) {
    return sampling == Sampling::Footprint
               ? static_cast<int>(std::clamp(std::ceil(minification / 1.5), 2.0, 8.0))
               : 1;
}

double expectedDb(Sampling sampling, double minification) {
    // Each figure is the worst of 40 directions in a made-up panorama with details down to the pixel and of 9
    // in a photo of a room; resources/docs/render.md has them all.
    struct Rung {
        double minification, nearest, bilinear, reduced, footprint, bicubic;
    };

    static constexpr std::array<Rung, 6> kMeasured{{{0.47, 32.6, 48.2, 32.5, 58.2, 42.6},
                                                    {0.72, 32.2, 45.2, 32.8, 55.3, 40.7},
                                                    {1.45, 31.5, 40.7, 35.5, 52.4, 36.7},
                                                    {2.05, 31.2, 38.0, 37.5, 50.7, 35.1},
                                                    {2.67, 30.2, 36.1, 37.7, 48.7, 33.5},
                                                    {3.82, 30.9, 35.0, 39.4, 48.7, 33.1}}};
    const auto value = [&](const Rung& row) {
        switch (sampling) {
        case Sampling::Nearest:
            return row.nearest;
        case Sampling::Bilinear:
            return row.bilinear;
        case Sampling::Reduced:
            return row.reduced;
        case Sampling::Bicubic:
            return row.bicubic;
        default:
            return row.footprint;
        }
    };
    const auto above = std::find_if(kMeasured.begin(), kMeasured.end(),
                                    [&](const Rung& row) { return row.minification >= minification; });
    if (above == kMeasured.begin() || above == kMeasured.end()) {
        return value(above == kMeasured.begin() ? kMeasured.front() : kMeasured.back());
    }
    const Rung& below = *(above - 1);
    const double share = (minification - below.minification) / (above->minification - below.minification);
    return value(below) + share * (value(*above) - value(below));
}

Sampling chosenSampling(Sampling sampling, double minification, double toleranceDb) {
    if (sampling == Sampling::Best) {
        return minification < 1 ? Sampling::Bicubic : Sampling::Footprint;
    }
    if (sampling != Sampling::Auto) {
        return sampling;
    }
    for (const Sampling each : {Sampling::Reduced, Sampling::Bilinear}) { // cheapest first
        if (expectedDb(each, minification) >= toleranceDb) {
            return each;
        }
    }
    return Sampling::Footprint;
}

bool ViewChoice::isFor(const CameraIntrinsics& camera) const {
    return std::max(camera.fx, camera.fy) <= kLongerFocal * focalPx;
}

SceneKind sceneKind(const JsonReader& reader, std::string_view key) {
    return named(reader, key, [](const std::string& word) { return sceneKind(word); });
}

Json toJson(const ViewChoice& choice) {
    return {{"scene", name(choice.scene)},        {"sampling", name(choice.sampling)},
            {"tolerance_px", choice.tolerancePx}, {"error_px", choice.errorPx},
            {"camera_focal_px", choice.focalPx},  {"reason", choice.reason}};
}

ViewChoice parseViewChoice(const JsonReader& reader) {
    ViewChoice choice;
    choice.scene = sceneKind(reader, "scene");
    choice.sampling = named(reader, "sampling", [](const std::string& word) { return sampling(word); });
    if (choice.sampling == Sampling::Auto || choice.sampling == Sampling::Best) {
        reader.member("sampling")
            .fail(text("expected the sampling that \"", name(choice.sampling), "\" stands for"));
    }
    choice.tolerancePx = numberUpTo(reader, "tolerance_px", false);
    choice.errorPx = numberUpTo(reader, "error_px", true);
    choice.focalPx = numberUpTo(reader, "camera_focal_px", false);
    choice.reason = reader.isAbsent("reason") ? "" : reader.string("reason");
    return choice;
}

} // namespace spherewalk::render
