// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/base/text.h"
#include "spherewalk/compare/picture_matches.h"
#include "spherewalk/jobs/compare_robot.h"
#include "spherewalk/render/renderer.h"

#include <algorithm>

namespace spherewalk::jobs {

namespace {

/// Of several poses the one from which the view shares most features with the picture.
const compare::TagPose& likest(const std::vector<compare::TagPose>& poses, const RgbImage& picture,
                               const render::Renderer& renderer, const CameraModel& camera,
                               const render::ViewOptions& options) {
    if (poses.size() == 1) {
        return poses.front();
    }
    const compare::PictureFeatures features(picture);
    std::vector<std::size_t> matches;
    for (const compare::TagPose& pose : poses) {
        const render::View view = renderer.render(camera, pose.roomFromCamera, options);
        matches.push_back(
            compare::placeDisplacements(features, compare::PictureFeatures(view.picture)).found.size());
    }
    return poses[static_cast<std::size_t>(std::ranges::max_element(matches) - matches.begin())];
}

} // namespace

std::vector<TagRegistered> registerPictures(const render::Renderer& renderer, const CameraModel& camera,
                                            const render::ViewOptions& view,
                                            std::vector<RobotPicture>& pictures, ProgressSink& progress,
                                            const std::stop_token& stop) {
    std::vector<TagRegistered> registered;
    const std::size_t count = pictures.size();
    for (std::size_t i = 0; i < count; ++i) {
        RobotPicture& picture = pictures[i];
        throwIfStopped(stop);
        if (picture.hasPose) {
            continue;
        }
        const RgbImage taken = readRobotPicture(picture, camera);
        const compare::TagRegistration found =
            compare::registeredByTags(photo::seenTags(taken, camera), renderer.dataset().info().tags);
        TagRegistered& one = registered.emplace_back();
        one.file = picture.file;
        one.why = found.why;
        if (!found.poses.empty()) {
            one.pose = likest(found.poses, taken, renderer, camera, view);
            picture.roomFromCamera = one.pose.roomFromCamera;
            picture.hasPose = true;
        }
        progress.progress(static_cast<double>(i + 1) / static_cast<double>(count),
                          text("Registering picture ", i + 1, " of ", count, " by its tags"));
    }
    std::erase_if(pictures, [](const RobotPicture& picture) { return !picture.hasPose; });
    return registered;
}

} // namespace spherewalk::jobs
