// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/render/renderer.h"

#include <cstdint>
#include <memory>
#include <string_view>

namespace spherewalk::render {

/// What a view is made from when its part of the nearest photo is not decoded.
enum class LatePolicy {
    Wait,     ///< that part, decoded now
    Coarse,   ///< the photo's thumbnail
    Previous, ///< the photo of the view before, seen from the new pose
};

std::string_view name(LatePolicy policy);

/// Errors: InvalidInput, listing the names.
LatePolicy latePolicy(std::string_view name);

struct StreamOptions {
    LatePolicy late = LatePolicy::Wait;
    /// How far ahead of the camera's motion is decoded; 0: not at all. Range: up to 10.
    double prefetchSeconds = 0.2;
};

/// Views of a stream, since it was made.
struct StreamCounters {
    std::uint64_t views = 0;
    std::uint64_t late = 0;
    std::uint64_t waited = 0;   ///< late ones that waited
    std::uint64_t coarse = 0;   ///< made from a thumbnail
    std::uint64_t previous = 0; ///< made from the photo of the view before
};

/// The views of one moving camera in turn. What it will see next is predicted from its last two poses and
/// decoded in a thread of its own between the views. Threads: one at a time; several streams of one renderer
/// run beside each other.
class ViewStream {
  public:
    /// Owner: the stream shares what the renderer has, and may outlive it. Errors: InvalidInput for options
    /// out of range.
    ViewStream(const Renderer& renderer, const CameraModel& camera, const StreamOptions& options = {});
    ~ViewStream();
    ViewStream(ViewStream&&) noexcept;
    ViewStream& operator=(ViewStream&&) noexcept;

    /// timeS: when the camera is there, on any clock; what is not later than the view before is a new start.
    /// LatePolicy::Coarse without a thumbnail, and Previous without a previous photo, become the next of
    /// Previous, Coarse, Wait that can be: ViewReport::origin says. Errors: as Renderer::render().
    View next(const Rigid3& roomFromCamera, double timeS, const ViewOptions& options = {});

    /// The same into a view whose memory is used again.
    void next(const Rigid3& roomFromCamera, double timeS, const ViewOptions& options, View& view);

    const StreamCounters& counters() const;

    /// Returns when all that was predicted is decoded.
    void waitForPrefetch();

  private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace spherewalk::render
