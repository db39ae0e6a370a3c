// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/base/json_fwd.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/render/overlay.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace spherewalk::dataset {

/// An object that was laid into a frame.
struct LabelledObject {
    std::uint16_t instance = 0; ///< The object's number in the labels, the same in all frames; above 0.
    std::string category;
    Rigid3 roomFromBox;                              ///< The pose of the middle of the box about the object.
    Eigen::Vector3d sizeM = Eigen::Vector3d::Zero(); ///< Of the box, along its own axes.
    MaskImage whole; ///< Above 0 where the object would be seen if nothing hid it. Shape: that of the labels.
};

struct LabelledFrame {
    std::string file;       ///< Of the picture.
    std::string labelsFile; ///< Of the labels, as a picture.
    double timeS = 0;
    Rigid3 roomFromCamera;     ///< The pose of the optical frame.
    render::LabelImage labels; ///< The number of the object that each pixel shows; 0 is the room.
    std::vector<LabelledObject> objects;
};

/// The lengths of runs of other pixels and of pixels with this label by turns, column by column from the
/// left. The first run is of other pixels, and may be 0 long. Source: COCO's masks (RLE).
std::vector<std::uint32_t> runLengths(const render::LabelImage& labels, std::uint16_t label);

/// Frames with objects in the format of COCO's object detection; resources/docs/formats.md lists the members
/// and what they add to COCO's. An object of which nothing is seen gets no annotation. If other things hide
/// it, the image names it.
///
/// categories: those of all objects. They are numbered from 1; 0 is the room. frameAt: the frames, each asked
/// for once and in turn. Errors: InvalidInput for an object of an unknown category, and for a mask that has
/// not the size of the labels; those of frameAt.
Json cocoJson(std::span<const std::string> categories, std::size_t frames,
              const std::function<LabelledFrame(std::size_t frame)>& frameAt);

} // namespace spherewalk::dataset
