// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/base/json.h"
#include "spherewalk/jobs/walk.h"

namespace spherewalk::jobs {

Json toJson(const render::ViewReport& report) {
    return {{"photo", report.file},
            {"offset_m", report.offsetM},
            {"scene", name(report.scene)},
            {"sampling", name(report.sampling)},
            {"origin", name(report.origin)},
            {"late", report.isLate},
            {"trust", report.trust},
            {"outside", report.isOutside},
            {"sees_place", report.seesPlace},
            {"seen_share", report.seenShare},
            {"filled_share", report.filledShare},
            {"parallax_px", report.parallaxPx},
            {"blur_px", report.blurPx},
            {"decode_ms", report.decodeMs},
            {"decoded_tiles", report.decodedTiles},
            {"whole_decode", report.isWholeDecode},
            {"verified", report.isVerified},
            {"render_ms", report.renderMs}};
}

Json toJson(const render::LoadCounters& counters) {
    return {{"hits", counters.hits},
            {"late", counters.late},
            {"waits", counters.waits},
            {"decoded_tiles", counters.decodedTiles},
            {"prefetched_tiles", counters.prefetchedTiles},
            {"dropped_tiles", counters.droppedTiles},
            {"whole_decodes", counters.wholeDecodes},
            {"prefetch_errors", counters.prefetchErrors},
            {"decode_ms", counters.decodeMs},
            {"prefetch_ms", counters.prefetchMs},
            {"resident_bytes", counters.residentBytes}};
}

Json toJson(const WalkReport& report) {
    return {{"frames", report.frames},
            {"reused_frames", report.reused},
            {"complete", report.isComplete},
            {"photos_used", report.photosUsed},
            {"median_render_ms", report.medianRenderMs},
            {"median_decode_ms", report.medianDecodeMs},
            {"worst_offset_m", report.worstOffsetM},
            {"least_trust", report.leastTrust},
            {"outside", report.outside},
            {"late", report.stream.late},
            {"waited", report.stream.waited},
            {"coarse", report.stream.coarse},
            {"previous", report.stream.previous},
            {"load", toJson(report.load)}};
}

} // namespace spherewalk::jobs
