// SPDX-License-Identifier: Apache-2.0
#include "c/enums.h"
#include "c/handles.h"
#include "c/interface.h"

#include "spherewalk/geometry/trajectory.h"

#include <cmath>
#include <type_traits>
#include <vector>

namespace spherewalk::render {

namespace {

RendererOptions rendererOptions(const spherewalk_renderer_options* given, bool isVerified) {
    const auto source = takenOrDefaults(given);
    checkReserved(source.reserved);
    const VerifyPhotos verify = verifyPhotosOf(source.verify_photos);
    return {source.cache_bytes, isVerified ? VerifyPhotos::AtOpen : verify};
}

StreamOptions streamOptions(const spherewalk_stream_options* options) {
    const auto source = takenOrDefaults(options);
    checkReserved(source.reserved);
    return {lateOf(source.late), source.prefetch_seconds, source.passage_m};
}

/// The stream or sensor for this thread alone. Errors: Busy.
template <class Handle>
std::unique_lock<std::mutex> heldAlone(Handle& handle) {
    std::unique_lock lock(handle.inUse, std::try_to_lock);
    if (!lock) {
        throw Error(ErrorKind::Busy,
                    std::is_same_v<Handle, spherewalk_stream>
                        ? "The stream is in use by another thread; make one for each thread."
                        : "The sensor is in use by another thread; make one for each thread.");
    }
    return lock;
}

void checkTime(double timeS) {
    if (!std::isfinite(timeS)) {
        throw Error(ErrorKind::InvalidInput, "The time of a view is not a number; give seconds.");
    }
}

/// Errors: InvalidInput for no poses, and for times that do not ascend.
std::vector<TimedPose> pathOf(const spherewalk_timed_pose* poses, std::uint64_t count) {
    given(poses, "poses");
    std::vector<TimedPose> path;
    for (std::uint64_t i = 0; i < count; ++i) {
        checkTime(poses[i].time_s);
        if (i > 0 && !(poses[i].time_s > poses[i - 1].time_s)) {
            throw Error(ErrorKind::InvalidInput, text("The time ", poses[i].time_s, " of pose ", i,
                                                      " is not later than the one before."));
        }
        path.push_back({poses[i].time_s, rigid3(poses[i].room_from_camera)});
    }
    if (path.empty()) {
        throw Error(ErrorKind::InvalidInput, "A frame needs at least one pose of its camera.");
    }
    return path;
}

} // namespace

extern "C" {

spherewalk_status spherewalk_renderer_options_init(spherewalk_renderer_options* options, size_t size) {
    return initialised(options, size);
}

spherewalk_status spherewalk_renderer_create(const spherewalk_dataset* dataset,
                                             const spherewalk_renderer_options* options,
                                             spherewalk_renderer** renderer) {
    return guarded([&] {
        given(renderer, "renderer") = nullptr;
        const spherewalk_dataset& source = given(dataset, "dataset");
        *renderer =
            new spherewalk_renderer{Renderer(source.dataset, rendererOptions(options, source.isVerified))};
    });
}

void spherewalk_renderer_destroy(spherewalk_renderer* renderer) {
    delete renderer;
}

spherewalk_status spherewalk_overlay_init(spherewalk_overlay* overlay, size_t size) {
    return initialised(overlay, size);
}

spherewalk_status spherewalk_view_options_init(spherewalk_view_options* options, size_t size) {
    return initialised(options, size);
}

spherewalk_status spherewalk_view_init(spherewalk_view* view, size_t size) {
    return initialised(view, size);
}

spherewalk_status spherewalk_report_init(spherewalk_report* report, size_t size) {
    return initialised(report, size);
}

spherewalk_status spherewalk_renderer_render(const spherewalk_renderer* renderer,
                                             const spherewalk_camera* camera,
                                             const spherewalk_pose* room_from_camera,
                                             const spherewalk_view_options* options,
                                             const spherewalk_view* view, spherewalk_report* report) {
    return guarded([&] {
        const spherewalk_renderer& from = given(renderer, "renderer");
        const CameraModel& model = given(camera, "camera").model;
        const Rigid3 pose = rigid3(given(room_from_camera, "room_from_camera"));
        const ViewTarget target(view, report, model.intrinsics());
        ViewMemory own;
        const std::unique_lock lock(from.inUse, std::try_to_lock);
        ViewMemory& memory = lock ? from.spare : own; // another thread makes one: then with memory of its own
        ViewOptions wanted = viewOptions(options, model.intrinsics(), memory.overlays);
        target.want(wanted);
        from.renderer.render(model, pose, wanted, memory.view);
        target.fill(memory.view);
    });
}

spherewalk_status spherewalk_probe_options_init(spherewalk_probe_options* options, size_t size) {
    return initialised(options, size);
}

spherewalk_status spherewalk_probe_init(spherewalk_probe* probe, size_t size) {
    return initialised(probe, size);
}

spherewalk_status spherewalk_light_init(spherewalk_light* light, size_t size) {
    return initialised(light, size);
}

spherewalk_status spherewalk_renderer_probe(const spherewalk_renderer* renderer, const double place_m[3],
                                            const spherewalk_probe_options* options,
                                            const spherewalk_probe* probe, spherewalk_light* light) {
    return guarded([&] {
        const spherewalk_renderer& from = given(renderer, "renderer");
        const Eigen::Vector3d place = Eigen::Map<const Eigen::Vector3d>(&given(place_m, "place_m"));
        const ProbeOptions wanted = probeOptions(options);
        const ProbeTarget target(probe, light, wanted.width);
        target.fill(lightProbe(from.renderer, place, wanted));
    });
}

spherewalk_status spherewalk_load_counters_init(spherewalk_load_counters* counters, size_t size) {
    return initialised(counters, size);
}

spherewalk_status spherewalk_renderer_get_counters(const spherewalk_renderer* renderer,
                                                   spherewalk_load_counters* counters) {
    return guarded([&] {
        const LoadCounters source = given(renderer, "renderer").renderer.counters();
        auto result = CStruct<spherewalk_load_counters>::defaults();
        result.hits = source.hits;
        result.late = source.late;
        result.waits = source.waits;
        result.decoded_tiles = source.decodedTiles;
        result.prefetched_tiles = source.prefetchedTiles;
        result.dropped_tiles = source.droppedTiles;
        result.whole_decodes = source.wholeDecodes;
        result.prefetch_errors = source.prefetchErrors;
        result.decode_ms = source.decodeMs;
        result.prefetch_ms = source.prefetchMs;
        result.resident_bytes = source.residentBytes;
        give(result, counters);
    });
}

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
        checkTime(time_s);
        const ViewTarget target(view, report, from.camera);
        ViewOptions wanted = viewOptions(options, from.camera, from.spare.overlays);
        target.want(wanted);
        from.stream.next(pose, time_s, wanted, from.spare.view);
        target.fill(from.spare.view);
    });
}

void spherewalk_sensor_destroy(spherewalk_sensor* sensor) {
    delete sensor;
}

spherewalk_status spherewalk_stream_take(spherewalk_stream* stream, spherewalk_sensor* sensor,
                                         const spherewalk_timed_pose* poses, uint64_t pose_count,
                                         double time_s, uint64_t frame,
                                         const spherewalk_view_options* options, const spherewalk_view* view,
                                         spherewalk_report* report) {
    return guarded([&] {
        spherewalk_stream& from = given(stream, "stream");
        spherewalk_sensor& by = given(sensor, "sensor");
        const auto lock = heldAlone(from);
        const auto sensorLock = heldAlone(by);
        const std::vector<TimedPose> path = pathOf(poses, pose_count);
        checkTime(time_s);
        const ViewTarget target(view, report, from.camera);
        ViewOptions wanted = viewOptions(options, from.camera, from.spare.overlays);
        target.want(wanted);
        const auto makeView = [&](const Rigid3& pose, double timeS, bool isMain, View& into) {
            ViewOptions of = wanted;
            of.wantsDepth = isMain && (wanted.wantsDepth || by.sensor.needsDepth());
            of.wantsTrust = isMain && wanted.wantsTrust;
            from.stream.next(pose, timeS, of, into);
        };
        by.sensor.take(
            makeView, [&path](double timeS) { return poseAt(path, timeS); }, time_s, frame, from.spare.view);
        by.sensor.measureDepth(frame, from.spare.view.depth);
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

} // extern "C"

} // namespace spherewalk::render
