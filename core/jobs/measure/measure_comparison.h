// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "measure/place_errors.h"

#include "spherewalk/jobs/measure_dataset.h"
#include "spherewalk/render/renderer.h"

#include <array>
#include <compare>
#include <functional>
#include <map>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

namespace spherewalk::jobs {

/// A true picture, where it was taken, and what the dataset must not use for it.
struct TruePicture {
    Rigid3 roomFromCamera;
    RgbImage picture;
    DepthImage depth;                   ///< Metres along the axis; empty if not known.
    std::optional<std::size_t> without; ///< Photo that views must not use, by its index.
    /// DatasetPhoto::exposureGain of the photo that it is made of. Views are compared as bright as that.
    std::optional<Eigen::Vector3d> exposureGain = {};
};

/// True pictures that are made one at a time, because they are large. Threads: any.
struct TruePictures {
    /// What is known of a true picture before it is made.
    struct Place {
        std::string name;
        Rigid3 roomFromCamera;
        std::optional<std::size_t> without;
    };

    std::size_t count = 0;
    std::function<Place(std::size_t)> place;
    std::function<TruePicture(std::size_t)> get;
    std::function<std::string(std::size_t)> key; ///< All that it depends on besides dataset and camera.
};

/// A direction in which a photo that is left out is compared.
struct SpreadView {
    std::size_t photo = 0;
    std::size_t direction = 0;

    auto operator<=>(const SpreadView&) const = default;
};

/// At most `most` views, spread over photos and directions, in the order of the photos. No photo has two
/// views before each has one, and neighbours look in different directions.
std::vector<SpreadView> spreadViews(std::size_t photos, int directions, std::size_t most);

/// The robot's pictures. Owner: options and camera must outlive them.
TruePictures robotTruePictures(const MeasureOptions& options, const CameraModel& camera);

/// What a level camera at the photos' places would see, for the views of spreadViews(). Depths are those that
/// were estimated for the photos, if any. Owner: renderer and camera must outlive them.
TruePictures leftOutTruePictures(const MeasureOptions& options, const render::Renderer& renderer,
                                 const CameraModel& camera);

/// The sampling that scene models are compared with: the wanted one, or what Best stands for with the
/// dataset's photos. wanted: not Auto.
render::Sampling samplingFor(render::Sampling wanted, const render::Dataset& dataset,
                             const CameraModel& camera);

/// The photo as a camera at this pose would see it, with the best sampling. Range: a pose at the photo's
/// place.
RgbImage truthFromPhoto(const render::Renderer& renderer, const CameraModel& camera,
                        const Rigid3& roomFromCamera);

/// The pose of a level camera at the photo's place. turn: angle to the left of the room's x axis.
Rigid3 levelPose(const render::DatasetPhoto& photo, Radians turn);

using SceneAndSampling = std::pair<render::SceneKind, render::Sampling>;

/// All samplings but Best and Auto, cheap to exact.
inline constexpr std::array kSamplings{render::Sampling::Nearest, render::Sampling::Bilinear,
                                       render::Sampling::Reduced, render::Sampling::Footprint,
                                       render::Sampling::Bicubic};

/// A view compared with a true picture.
struct Comparison {
    std::size_t photo = 0; ///< Photo that the view was made from, by its index.
    Looks looks;
    PlaceErrors features;
    std::vector<int> exact;        ///< Displacements of pixels whose depth is known.
    std::vector<SeenThing> things; ///< Some of these pixels, to the millimetre.
};

/// Displacements that a sampling makes by itself, in hundredths of a pixel. Features of a view are compared
/// with the same view in the best sampling.
using SamplingErrors = std::map<render::Sampling, std::vector<int>>;

/// All comparisons with one true picture.
struct Comparisons {
    std::map<SceneAndSampling, Comparison> views;
    SamplingErrors samplings; ///< Either all samplings or none.
};

/// The view from where the true picture was taken.
render::View viewOf(const TruePicture& subject, const render::Renderer& renderer, const CameraModel& camera,
                    const SceneAndSampling& with);

/// Compares the views of the scene models that are not known yet, and returns whether there were any. Only
/// then the picture is made. Errors: those of rendering. Stop: Stopped, between two views.
bool compareMissing(const std::vector<render::SceneKind>& scenes, render::Sampling sampling,
                    const std::function<TruePicture()>& picture, const render::Renderer& renderer,
                    const CameraModel& camera, const std::stop_token& stop, Comparisons& known);

/// The errors of all samplings in the view that the nearest photo alone gives from this place.
SamplingErrors samplingErrors(const TruePictures::Place& place, const render::Renderer& renderer,
                              const CameraModel& camera);

/// Comparisons in files, named after all that they depend on. Threads: any, for different keys.
class ComparisonCache {
  public:
    /// folder: empty means that nothing is kept. Errors: Io.
    ComparisonCache(std::filesystem::path folder, const render::DatasetInfo& info,
                    const CameraIntrinsics& camera);

    /// What is known of this picture. A damaged file counts as none.
    Comparisons read(const std::string& pictureKey) const;
    void write(const std::string& pictureKey, const Comparisons& comparisons) const;

  private:
    std::filesystem::path fileOf(const std::string& pictureKey) const;

    std::filesystem::path m_folder;
    std::size_t m_photos;
    std::string m_context;
};

/// How much views change at borders of cells, for each scene model. Some borders are taken, spread over the
/// dataset: those half way between a photo and its nearest neighbour. A level camera looks at each from both
/// sides, in a direction of its own. The cache folder keeps what was compared. Nothing if no photo has a
/// neighbour. Errors: those of rendering and of the cache folder. Stop: Stopped, between two views.
std::vector<BorderJump> borderJumps(const render::Renderer& renderer, const CameraModel& camera,
                                    const MeasureOptions& options,
                                    const std::vector<render::SceneKind>& scenes, ProgressSink& progress,
                                    const std::stop_token& stop);

} // namespace spherewalk::jobs
