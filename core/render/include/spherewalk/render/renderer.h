// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/render/dataset.h"
#include "spherewalk/render/sampling.h"
#include "spherewalk/render/scene_model.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace spherewalk::render {

struct RendererOptions {
    std::uint64_t cacheBytes = 512ULL << 20; ///< for decoded photos; the one in use is kept in any case
};

struct ViewOptions {
    std::optional<SceneKind> scene; ///< nothing: the best one that the dataset has
    int threads = 0;                ///< 0: all that the machine has; the pixels are the same for any number
    Sampling sampling = Sampling::Footprint;
    double toleranceDb = 40; ///< for Sampling::Auto: how far below full scale its error is to be
    /// Every pixel by itself in double precision, bilinear, a hundred times slower: for comparisons.
    bool exact = false;
};

/// What a view was made from, and how far it can be trusted.
struct ViewReport {
    std::size_t photo = 0; ///< index into DatasetInfo::photos
    std::string file;
    SceneKind scene = SceneKind::None;
    Sampling sampling = Sampling::Footprint; ///< what was used, never Auto
    double offsetM = 0;                      ///< between the camera and the photo
    /// By how much a thing at half or at twice the distance that the scene model assumes would be displaced,
    /// at worst, in pixels at the picture's centre; with SceneKind::None, a thing at the dataset's usual
    /// distance (its sphere's radius, or 2 m if it has none).
    double parallaxPx = 0;
    double trust = 0; ///< 1 / (1 + parallaxPx): 1 at a photo's own position, 0.5 where one pixel is in doubt
    double decodeMs = 0; ///< reading and decoding, 0 if the photo was in memory
    double renderMs = 0;
};

struct View {
    RgbImage picture; ///< black where the lens sees nothing
    ViewReport report;
};

/// Answers "what does my camera see from here?" from the nearest photo. Threads: render() may be called from
/// any.
class Renderer {
  public:
    explicit Renderer(std::shared_ptr<const Dataset> dataset, const RendererOptions& options = {});
    ~Renderer();
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;

    /// roomFromCamera: of the camera's optical frame. Errors: InvalidInput for a pose that is not finite, or
    /// a scene model that the dataset does not have; those of reading and decoding the photo.
    View render(const CameraModel& camera, const Rigid3& roomFromCamera,
                const ViewOptions& options = {}) const;

    const Dataset& dataset() const;

  private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace spherewalk::render
