// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/render/renderer.h"

#include <cstdint>
#include <memory>
#include <string_view>

namespace spherewalk::render {

/// What a view is made from when its part of the nearest photo is not decoded.
enum class LatePolicy {
    Wait,     ///< The view waits while that part is decoded.
    Coarse,   ///< The view is made from the photo's thumbnail.
    Previous, ///< The view is made from the photo of the view before, seen from the new pose.
};

/// The word that options and files use: "wait", "coarse", "previous".
std::string_view name(LatePolicy policy);

/// The policy of that word. Errors: InvalidInput, with all the words.
LatePolicy latePolicy(std::string_view name);

struct StreamOptions {
    LatePolicy late = LatePolicy::Wait;
    /// How far ahead of the camera's motion photos are decoded. Range: 0 (not at all) to 10.
    double prefetchSeconds = 0.2;
    /// The way in metres along which a view with depth passes from one photo to the next, by mixing both. It
    /// takes twice the time of a view there. Range: 0 (it jumps) to 1.
    double passageM = 0.04;
};

/// The numbers of a stream's views since it was made.
struct StreamCounters {
    std::uint64_t views = 0;
    std::uint64_t late = 0;
    std::uint64_t waited = 0;   ///< Late views that waited.
    std::uint64_t coarse = 0;   ///< Late views that were made from a thumbnail.
    std::uint64_t previous = 0; ///< Late views that were made from the photo of the view before.

    StreamCounters& operator+=(const StreamCounters& other) {
        views += other.views;
        late += other.late;
        waited += other.waited;
        coarse += other.coarse;
        previous += other.previous;
        return *this;
    }
};

/// The views of one moving camera in turn. A view keeps the photos of the view before until the camera is
/// 2 cm beyond the border to others, so that a camera that trembles on a border does not flicker. Then a view
/// with depth passes softly to the other photo. Its report, depth and trust are the other photo's. The stream
/// predicts the next poses from the last two, and a thread of its own decodes for them between the views.
/// Threads: one at a time; several streams of one renderer run beside each other.
class ViewStream {
  public:
    /// Owner: the stream shares what the renderer has, and may outlive it. Errors: InvalidInput for options
    /// out of range.
    ViewStream(const Renderer& renderer, const CameraModel& camera, const StreamOptions& options = {});
    ~ViewStream();
    ViewStream(ViewStream&&) noexcept;
    ViewStream& operator=(ViewStream&&) noexcept;

    /// The view of the camera at this pose of its optical frame. timeS: when the camera is there, on any
    /// clock. A time that is not later than the view before is a new start. LatePolicy::Coarse needs a
    /// thumbnail, and Previous a decoded previous photo. Without these, the next of Previous, Coarse, Wait is
    /// done, and ViewReport::origin tells which. Errors: as Renderer::render().
    View next(const Rigid3& roomFromCamera, double timeS, const ViewOptions& options = {});

    /// The same into a view whose memory is used again.
    void next(const Rigid3& roomFromCamera, double timeS, const ViewOptions& options, View& view);

    /// Moves the camera through this pose without making a view. The next view is then the same as if this
    /// one had been made. Cost: microseconds. Errors: as Renderer::render().
    void pass(const Rigid3& roomFromCamera, const ViewOptions& options = {});

    const StreamCounters& counters() const;

    /// Returns when all that was predicted is decoded.
    void waitForPrefetch();

  private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace spherewalk::render
