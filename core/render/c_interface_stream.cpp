// SPDX-License-Identifier: Apache-2.0
#include "c_enums.h"
#include "c_handles.h"
#include "c_interface.h"

#include <cmath>

using namespace spherewalk;
using namespace spherewalk::render;

namespace {

StreamOptions streamOptions(const spherewalk_stream_options* options) {
    const auto source = takenOrDefaults(options);
    checkReserved(source.reserved);
    return {lateOf(source.late), source.prefetch_seconds};
}

/// The stream for this thread alone. Errors: Busy.
std::unique_lock<std::mutex> heldAlone(spherewalk_stream& stream) {
    std::unique_lock lock(stream.inUse, std::try_to_lock);
    if (!lock) {
        throw Error(ErrorKind::Busy, "The stream is in use by another thread; make one for each thread.");
    }
    return lock;
}

} // namespace

spherewalk_status spherewalk_stream_options_init(spherewalk_stream_options* options, size_t size) {
    return initialised(options, size);
}

spherewalk_status spherewalk_stream_create(const spherewalk_renderer* renderer,
                                           const spherewalk_camera* camera,
                                           const spherewalk_stream_options* options,
                                           spherewalk_stream** stream) {
    return guarded([&] {
        given(stream, "stream") = nullptr;
        const Renderer& from = given(renderer, "renderer").renderer;
        const CameraModel& model = given(camera, "camera").model;
        *stream = new spherewalk_stream{ViewStream(from, model, streamOptions(options)), model.intrinsics()};
    });
}

void spherewalk_stream_destroy(spherewalk_stream* stream) {
    delete stream;
}

spherewalk_status spherewalk_stream_next(spherewalk_stream* stream, const spherewalk_pose* room_from_camera,
                                         double time_s, const spherewalk_view_options* options,
                                         const spherewalk_view* view, spherewalk_report* report) {
    return guarded([&] {
        spherewalk_stream& from = given(stream, "stream");
        const auto lock = heldAlone(from);
        const Rigid3 pose = rigid3(given(room_from_camera, "room_from_camera"));
        if (!std::isfinite(time_s)) {
            throw Error(ErrorKind::InvalidInput, "The time of a view is not a number; give seconds.");
        }
        const ViewTarget target(view, report, from.camera);
        ViewOptions wanted = viewOptions(options, from.camera, from.spare.overlays);
        target.want(wanted);
        from.stream.next(pose, time_s, wanted, from.spare.view);
        target.fill(from.spare.view);
    });
}

spherewalk_status spherewalk_stream_wait_for_prefetch(spherewalk_stream* stream) {
    return guarded([&] {
        spherewalk_stream& from = given(stream, "stream");
        const auto lock = heldAlone(from);
        from.stream.waitForPrefetch();
    });
}

spherewalk_status spherewalk_stream_counters_init(spherewalk_stream_counters* counters, size_t size) {
    return initialised(counters, size);
}

spherewalk_status spherewalk_stream_get_counters(spherewalk_stream* stream,
                                                 spherewalk_stream_counters* counters) {
    return guarded([&] {
        spherewalk_stream& from = given(stream, "stream");
        const auto lock = heldAlone(from);
        const StreamCounters& source = from.stream.counters();
        auto result = CStruct<spherewalk_stream_counters>::defaults();
        result.views = source.views;
        result.late = source.late;
        result.waited = source.waited;
        result.coarse = source.coarse;
        result.previous = source.previous;
        give(result, counters);
    });
}
