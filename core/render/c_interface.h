// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "c_structs.h"

#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/rigid3.h"

#include <utility>

/// What the files of the C interface share.
namespace spherewalk::render {

/// The status of the exception that is being handled; keeps its sentence for spherewalk_last_error().
spherewalk_status failure() noexcept;

/// Calls the body; what it throws becomes a status and a sentence.
template <class Body>
spherewalk_status guarded(Body&& body) noexcept {
    try {
        std::forward<Body>(body)();
        return SPHEREWALK_OK;
    } catch (...) {
        return failure();
    }
}

/// Errors: InvalidInput for NULL; name: of the argument.
void checkGiven(const void* pointer, const char* name);

/// What the pointer points to. Errors: InvalidInput for NULL; name: of the argument.
template <class Value>
Value& given(Value* pointer, const char* name) {
    checkGiven(pointer, name);
    return *pointer;
}

/// What every _init() does. Errors: InvalidInput for NULL and for a size that no version has had.
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

/// Errors: InvalidInput for an unknown version, lens or count of parameters; what CameraModel checks is left
/// to it.
CameraIntrinsics intrinsicsOf(const spherewalk_intrinsics* intrinsics);
spherewalk_intrinsics cIntrinsics(const CameraIntrinsics& intrinsics);

} // namespace spherewalk::render
