// SPDX-License-Identifier: Apache-2.0
#include "c_enums.h"
#include "c_handles.h"
#include "c_interface.h"

#include "spherewalk/render/camera_info.h"

#include <numbers>

namespace spherewalk::render {

namespace {

constexpr std::uint64_t kLargestYaml = 1 << 20;
constexpr int kMostDistortion = 8;

} // namespace

CameraIntrinsics intrinsicsOf(const spherewalk_intrinsics* intrinsics) {
    const spherewalk_intrinsics source = taken(intrinsics);
    if (source.distortion_count < 0 || source.distortion_count > kMostDistortion) {
        throw Error(ErrorKind::InvalidInput,
                    text("The camera model cannot be used: it has ", source.distortion_count,
                         " distortion parameters, and 0 to ", kMostDistortion, " are possible."));
    }
    CameraIntrinsics result;
    result.width = source.width;
    result.height = source.height;
    result.fx = source.fx;
    result.fy = source.fy;
    result.cx = source.cx;
    result.cy = source.cy;
    result.lens = lensOf(source.lens);
    result.distortion.assign(source.distortion, source.distortion + source.distortion_count);
    return result;
}

spherewalk_intrinsics cIntrinsics(const CameraIntrinsics& source) {
    auto result = CStruct<spherewalk_intrinsics>::defaults();
    result.width = source.width;
    result.height = source.height;
    result.fx = source.fx;
    result.fy = source.fy;
    result.cx = source.cx;
    result.cy = source.cy;
    result.lens = cLens(source.lens);
    result.distortion_count = static_cast<std::int32_t>(source.distortion.size());
    std::copy(source.distortion.begin(), source.distortion.end(), result.distortion);
    return result;
}

} // namespace spherewalk::render

using namespace spherewalk;
using namespace spherewalk::render;

spherewalk_status spherewalk_intrinsics_init(spherewalk_intrinsics* intrinsics, size_t size) {
    return initialised(intrinsics, size);
}

spherewalk_status spherewalk_intrinsics_pinhole(int32_t width, int32_t height, double horizontal_fov_rad,
                                                spherewalk_intrinsics* intrinsics) {
    return guarded([&] {
        if (!(horizontal_fov_rad > 0 && horizontal_fov_rad < std::numbers::pi)) {
            throw Error(ErrorKind::InvalidInput,
                        text("A camera without distortion cannot have a field of view of ",
                             horizontal_fov_rad, " rad; give one between 0 and pi."));
        }
        const auto camera = CameraIntrinsics::pinhole(width, height, horizontal_fov_rad);
        camera.validate();
        give(cIntrinsics(camera), intrinsics);
    });
}

spherewalk_status spherewalk_camera_create(const spherewalk_intrinsics* intrinsics,
                                           spherewalk_camera** camera) {
    return guarded([&] {
        given(camera, "camera") = nullptr;
        *camera = new spherewalk_camera{CameraModel(intrinsicsOf(intrinsics))};
    });
}

spherewalk_status spherewalk_camera_read(const char* file, spherewalk_camera** camera) {
    return guarded([&] {
        given(camera, "camera") = nullptr;
        *camera = new spherewalk_camera{CameraModel(readCameraInfo(&given(file, "file")))};
    });
}

spherewalk_status spherewalk_camera_parse(const char* yaml, uint64_t size_bytes, spherewalk_camera** camera) {
    return guarded([&] {
        given(camera, "camera") = nullptr;
        given(yaml, "yaml");
        if (size_bytes > kLargestYaml) {
            throw Error(ErrorKind::InvalidInput, text("The text of the camera has ", size_bytes,
                                                      " bytes, and at most ", kLargestYaml, " are read."));
        }
        const std::string_view content(yaml, static_cast<std::size_t>(size_bytes));
        *camera = new spherewalk_camera{CameraModel(parseCameraInfo(content, "from memory"))};
    });
}

void spherewalk_camera_destroy(spherewalk_camera* camera) {
    delete camera;
}

spherewalk_status spherewalk_camera_get_intrinsics(const spherewalk_camera* camera,
                                                   spherewalk_intrinsics* intrinsics) {
    return guarded([&] { give(cIntrinsics(given(camera, "camera").model.intrinsics()), intrinsics); });
}
