// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/jobs/measure_dataset.h"

#include <compare>
#include <functional>
#include <string>
#include <vector>

namespace spherewalk::jobs {

/// A true picture, where it was taken, and what the dataset must not use for it.
struct Subject {
    Rigid3 roomFromCamera;
    RgbImage picture;
    DepthImage depth; ///< along the axis; empty: not known
    std::optional<std::size_t> without;
};

/// How many subjects there are, and each when it is its turn: they are large. Threads: any.
struct Subjects {
    /// What is known of a subject without its picture.
    struct Place {
        std::string name;
        Rigid3 roomFromCamera;
        std::optional<std::size_t> without;
    };

    std::size_t count = 0;
    std::function<Place(std::size_t)> place;
    std::function<Subject(std::size_t)> get;
    std::function<std::string(std::size_t)> key; ///< all that a subject depends on but dataset and camera
};

/// A view of a photo that is left out.
struct SpreadView {
    std::size_t photo = 0;
    std::size_t direction = 0;

    auto operator<=>(const SpreadView&) const = default;
};

/// So many views at most, spread over photos and directions: each photo once before any twice, neighbours in
/// different directions; in the order of the photos.
std::vector<SpreadView> spreadViews(std::size_t photos, int directions, std::size_t most);

Subjects robotSubjects(const MeasureOptions& options, const CameraModel& camera);

/// Photos, as spreadViews() says, as a level camera at their place would see them, with the depths that were
/// estimated for them, if they were. Owner: renderer and camera must outlive them.
Subjects leftOutSubjects(const MeasureOptions& options, const render::Renderer& renderer,
                         const CameraModel& camera);

/// Footprint where the camera has fewer pixels a degree than the photo, else Bicubic.
render::Sampling bestSampling(const render::Renderer& renderer, std::size_t photo, const CameraModel& camera);

/// The photo as a camera there would see it, with the best sampling for it.
RgbImage truthFromPhoto(const render::Renderer& renderer, std::size_t photo, const CameraModel& camera,
                        const Rigid3& roomFromCamera);

/// A level camera at the photo's place that looks this far to the left of the room's x axis.
Rigid3 levelPose(const render::DatasetPhoto& photo, Radians turn);

} // namespace spherewalk::jobs
