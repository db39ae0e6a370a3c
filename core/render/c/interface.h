// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/light.h"
#include "spherewalk/render/view_stream.h"
#include "spherewalk/spherewalk.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <limits>
#include <utility>

/// The code that all files of the C interface share: structs of several versions, errors, arguments and
/// poses.
namespace spherewalk::render {

/// A struct of the C interface that begins with struct_size. kName is its name. kSizes has all its sizes, the
/// oldest first and today's last. defaults() is a struct of today's size. Members are only added, at the end,
/// and there is no padding at the end.
///
/// The caller's struct may be smaller than today's, so it is always passed as a pointer. A reference would
/// tell the compiler that the struct is whole.
template <class Struct>
struct CStruct;

/// Errors: InvalidInput for a size that no version of the struct has had.
template <class Struct>
void checkStructSize(std::size_t size) {
    static_assert(CStruct<Struct>::kSizes.back() == sizeof(Struct));
    const auto& sizes = CStruct<Struct>::kSizes;
    if (std::find(sizes.begin(), sizes.end(), size) != sizes.end()) {
        return;
    }
    const char* name = CStruct<Struct>::kName;
    throw Error(ErrorKind::InvalidInput,
                size > sizeof(Struct)
                    ? text("A ", name, " has the struct_size ", size, ", and this library knows it up to ",
                           sizeof(Struct),
                           "; use a library as new as the header that the program was compiled with.")
                    : text("A ", name, " has the struct_size ", size, ", which no version of it has had; ",
                           "make it ready with ", name, "_init()."));
}

/// The size of the caller's struct. Errors: InvalidInput for NULL and for an unknown size.
template <class Struct>
std::size_t checkedSize(const Struct* callers) {
    if (callers == nullptr) {
        throw Error(ErrorKind::InvalidInput,
                    text("The ", CStruct<Struct>::kName, " is NULL, which it must not be."));
    }
    std::size_t size = 0;
    std::memcpy(&size, callers, sizeof size);
    checkStructSize<Struct>(size);
    return size;
}

/// The caller's struct as today's, with defaults for the members that its version lacks. Errors: as
/// checkedSize().
template <class Struct>
Struct taken(const Struct* callers) {
    const std::size_t size = checkedSize(callers);
    Struct result = CStruct<Struct>::defaults();
    std::memcpy(&result, callers, size);
    result.struct_size = sizeof(Struct);
    return result;
}

/// The same, but with the defaults for NULL.
template <class Struct>
Struct takenOrDefaults(const Struct* callers) {
    return callers == nullptr ? CStruct<Struct>::defaults() : taken(callers);
}

/// Copies to the caller the members that its version of the struct has. Errors: as checkedSize().
template <class Struct>
void give(Struct today, Struct* callers) {
    const std::size_t size = checkedSize(callers);
    today.struct_size = size;
    std::memcpy(callers, &today, size);
}

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
    static constexpr std::array kSizes{offsetof(spherewalk_intrinsics, distortion) + 8 * sizeof(double),
                                       sizeof(spherewalk_intrinsics)};
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
    static constexpr std::array kSizes{offsetof(spherewalk_overlay, shadow), sizeof(spherewalk_overlay)};
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
    static constexpr std::array kSizes{offsetof(spherewalk_report, is_outside), sizeof(spherewalk_report)};
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
        result.passage_m = StreamOptions{}.passageM;
        return result;
    }
};

template <>
struct CStruct<spherewalk_stream_counters> : detail::PlainCStruct<spherewalk_stream_counters> {
    static constexpr const char* kName = "spherewalk_stream_counters";
};

template <>
struct CStruct<spherewalk_probe_options> : detail::PlainCStruct<spherewalk_probe_options> {
    static constexpr const char* kName = "spherewalk_probe_options";

    static spherewalk_probe_options defaults() {
        auto result = PlainCStruct::defaults();
        result.width = 512;
        return result;
    }
};

template <>
struct CStruct<spherewalk_probe> : detail::PlainCStruct<spherewalk_probe> {
    static constexpr const char* kName = "spherewalk_probe";
};

template <>
struct CStruct<spherewalk_light> : detail::PlainCStruct<spherewalk_light> {
    static constexpr const char* kName = "spherewalk_light";
};

/// The status of the exception that is being handled. Its sentence is kept for spherewalk_last_error().
spherewalk_status failure() noexcept;

/// Calls the body. An exception becomes a status and a sentence.
template <class Body>
spherewalk_status guarded(Body&& body) noexcept {
    try {
        std::forward<Body>(body)();
        return SPHEREWALK_OK;
    } catch (...) {
        return failure();
    }
}

/// name: the argument's name for the sentence. Errors: InvalidInput for NULL.
void checkGiven(const void* pointer, const char* name);

/// The object that the pointer points to. name: the argument's name for the sentence. Errors: InvalidInput
/// for NULL.
template <class Value>
Value& given(Value* pointer, const char* name) {
    checkGiven(pointer, name);
    return *pointer;
}

/// Gives the caller's struct its defaults, as every _init() does. Errors: InvalidInput for NULL and for a
/// size that no version has had.
template <class Struct>
spherewalk_status initialised(Struct* callers, std::size_t size) noexcept {
    return guarded([&] {
        checkGiven(callers, CStruct<Struct>::kName);
        checkStructSize<Struct>(size);
        Struct defaults = CStruct<Struct>::defaults();
        defaults.struct_size = size;
        std::memcpy(callers, &defaults, size);
    });
}

/// Errors: InvalidInput for anything but 0.
void checkReserved(std::int32_t reserved);

Rigid3 rigid3(const spherewalk_pose& pose);
spherewalk_pose cPose(const Rigid3& pose);

/// The C++ form of a camera. Errors: InvalidInput for an unknown version, lens or count of parameters.
/// CameraModel checks the rest.
CameraIntrinsics intrinsicsOf(const spherewalk_intrinsics* intrinsics);
spherewalk_intrinsics cIntrinsics(const CameraIntrinsics& intrinsics);

} // namespace spherewalk::render
