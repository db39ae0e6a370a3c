// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/render/view_choice.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>

namespace spherewalk::render {

namespace {

constexpr double kLongerFocal = 1.05; ///< that changes no error worth mentioning
constexpr double kMostPx = 1e6;

double numberUpTo(const JsonReader& reader, std::string_view key, bool mayBeZero) {
    const double value = reader.number(key);
    if (!(value <= kMostPx) || value < 0 || (value == 0 && !mayBeZero)) {
        reader.member(key).fail(text("expected a number of pixels up to ", kMostPx));
    }
    return value;
}

/// What the member's word stands for. Errors: Corrupt, naming the place.
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
    if (choice.sampling == Sampling::Auto) {
        reader.member("sampling").fail("expected the sampling that \"auto\" stands for");
    }
    choice.tolerancePx = numberUpTo(reader, "tolerance_px", false);
    choice.errorPx = numberUpTo(reader, "error_px", true);
    choice.focalPx = numberUpTo(reader, "camera_focal_px", false);
    choice.reason = reader.isAbsent("reason") ? "" : reader.string("reason");
    return choice;
}

} // namespace spherewalk::render
