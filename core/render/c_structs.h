// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "c_struct.h"

#include "spherewalk/render/view_stream.h"
#include "spherewalk/spherewalk.h"

#include <limits>

/// The structs of the C interface, their sizes and their defaults, which are those of the C++ interface.
namespace spherewalk::render {

namespace detail {

/// A struct that has had one size only, and of which all members are 0 by default.
template <class Struct>
struct PlainCStruct {
    static constexpr std::array kSizes{sizeof(Struct)};

    static Struct defaults() {
        Struct result{};
        result.struct_size = sizeof(Struct);
        return result;
    }
};

} // namespace detail

template <>
struct CStruct<spherewalk_dataset_info> : detail::PlainCStruct<spherewalk_dataset_info> {
    static constexpr const char* kName = "spherewalk_dataset_info";
};

template <>
struct CStruct<spherewalk_photo> : detail::PlainCStruct<spherewalk_photo> {
    static constexpr const char* kName = "spherewalk_photo";

    static spherewalk_photo defaults() {
        auto result = PlainCStruct::defaults();
        std::fill_n(result.position_sigma_m, 3, std::numeric_limits<double>::quiet_NaN());
        std::fill_n(result.rotation_sigma_rad, 3, std::numeric_limits<double>::quiet_NaN());
        return result;
    }
};

template <>
struct CStruct<spherewalk_intrinsics> : detail::PlainCStruct<spherewalk_intrinsics> {
    static constexpr const char* kName = "spherewalk_intrinsics";
};

template <>
struct CStruct<spherewalk_renderer_options> : detail::PlainCStruct<spherewalk_renderer_options> {
    static constexpr const char* kName = "spherewalk_renderer_options";

    static spherewalk_renderer_options defaults() {
        auto result = PlainCStruct::defaults();
        result.cache_bytes = RendererOptions{}.cacheBytes;
        return result;
    }
};

template <>
struct CStruct<spherewalk_overlay> : detail::PlainCStruct<spherewalk_overlay> {
    static constexpr const char* kName = "spherewalk_overlay";
};

template <>
struct CStruct<spherewalk_view_options> : detail::PlainCStruct<spherewalk_view_options> {
    static constexpr const char* kName = "spherewalk_view_options";

    static spherewalk_view_options defaults() {
        auto result = PlainCStruct::defaults();
        result.tolerance_db = ViewOptions{}.toleranceDb;
        result.overlay_tolerance_m = ComposeOptions{}.toleranceM;
        result.overlay_tolerance_share = ComposeOptions{}.toleranceShare;
        return result;
    }
};

template <>
struct CStruct<spherewalk_view> : detail::PlainCStruct<spherewalk_view> {
    static constexpr const char* kName = "spherewalk_view";
};

template <>
struct CStruct<spherewalk_report> : detail::PlainCStruct<spherewalk_report> {
    static constexpr const char* kName = "spherewalk_report";
};

template <>
struct CStruct<spherewalk_load_counters> : detail::PlainCStruct<spherewalk_load_counters> {
    static constexpr const char* kName = "spherewalk_load_counters";
};

template <>
struct CStruct<spherewalk_stream_options> : detail::PlainCStruct<spherewalk_stream_options> {
    static constexpr const char* kName = "spherewalk_stream_options";

    static spherewalk_stream_options defaults() {
        auto result = PlainCStruct::defaults();
        result.prefetch_seconds = StreamOptions{}.prefetchSeconds;
        return result;
    }
};

template <>
struct CStruct<spherewalk_stream_counters> : detail::PlainCStruct<spherewalk_stream_counters> {
    static constexpr const char* kName = "spherewalk_stream_counters";
};

} // namespace spherewalk::render
