// SPDX-License-Identifier: Apache-2.0
#include "c/enums.h"
#include "c/handles.h"
#include "c/interface.h"

#include "spherewalk/render/camera_info.h"

#include <filesystem>
#include <numbers>

namespace spherewalk::render {

namespace {

constexpr std::uint64_t kLargestYaml = 1 << 20;
static_assert(sizeof(spherewalk_intrinsics::distortion) ==
              CameraIntrinsics::kMostDistortion * sizeof(double));

/// The number of distortion parameters for which the caller's struct has room.
std::size_t roomOf(const spherewalk_intrinsics* callers) {
    return (checkedSize(callers) - offsetof(spherewalk_intrinsics, distortion)) / sizeof(double);
}

/// Copies a camera to the caller. Errors: Unsupported if the caller's struct has too little room.
void giveCamera(const CameraIntrinsics& source, spherewalk_intrinsics* callers) {
    const std::size_t room = roomOf(callers);
    if (source.distortion.size() > room) {
        throw Error(ErrorKind::Unsupported, text("The camera has ", source.distortion.size(),
                                                 " distortion parameters, and the program was compiled for ",
                                                 room, "; compile it with this library's header."));
    }
    give(cIntrinsics(source), callers);
}

/// Tells the caller's function, and asks for a stop when it does.
class CallerProgress : public ProgressSink {
  public:
    CallerProgress(spherewalk_progress function, void* user) : m_function(function), m_user(user) {}

    void progress(double fraction, std::string_view /*activity*/) override {
        if (m_function != nullptr && m_function(m_user, fraction) != 0) {
            m_stop.request_stop();
        }
    }

    void warning(std::string_view /*sentence*/) override {}

    std::stop_token stop() const { return m_stop.get_token(); }

  private:
    spherewalk_progress m_function;
    void* m_user;
    std::stop_source m_stop;
};

template <class Element>
const Element& elementAt(const std::vector<Element>& list, std::uint64_t index, const char* what) {
    if (index >= list.size()) {
        throw Error(ErrorKind::InvalidInput,
                    text("There is no ", what, " ", index, "; the dataset has ", list.size(), "."));
    }
    return list[static_cast<std::size_t>(index)];
}

void fillSigmas(const DatasetPhoto& photo, spherewalk_photo& result) {
    if (photo.positionSigmaM) {
        std::copy_n(photo.positionSigmaM->data(), 3, result.position_sigma_m);
    }
    if (photo.rotationSigma) {
        const auto& [yaw, pitch, roll] = *photo.rotationSigma;
        result.rotation_sigma_rad[0] = yaw.value();
        result.rotation_sigma_rad[1] = pitch.value();
        result.rotation_sigma_rad[2] = roll.value();
    }
}

/// what: that the text describes, for sentences. Errors: InvalidInput.
std::string_view yamlOf(const char* yaml, std::uint64_t sizeBytes, const char* what) {
    given(yaml, "yaml");
    if (sizeBytes > kLargestYaml) {
        throw Error(ErrorKind::InvalidInput, text("The text of the ", what, " has ", sizeBytes,
                                                  " bytes, and at most ", kLargestYaml, " are read."));
    }
    return {yaml, static_cast<std::size_t>(sizeBytes)};
}

} // namespace

CameraIntrinsics intrinsicsOf(const spherewalk_intrinsics* intrinsics) {
    const spherewalk_intrinsics source = taken(intrinsics);
    const auto most = static_cast<std::int32_t>(roomOf(intrinsics));
    if (source.distortion_count < 0 || source.distortion_count > most) {
        throw Error(ErrorKind::InvalidInput,
                    text("The camera model cannot be used: it has ", source.distortion_count,
                         " distortion parameters, and 0 to ", most, " are possible."));
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

extern "C" {

spherewalk_status spherewalk_dataset_open(const char* folder, int32_t verify, spherewalk_progress progress,
                                          void* user, spherewalk_dataset** dataset) {
    return guarded([&] {
        given(dataset, "dataset") = nullptr;
        const std::filesystem::path path = &given(folder, "folder");
        const Verify much = verifyOf(verify);
        CallerProgress sink(progress, user);
        auto opened = std::make_shared<const Dataset>(Dataset::open(path, much, sink, sink.stop()));
        throwIfStopped(sink.stop());
        *dataset = new spherewalk_dataset{std::move(opened), much == Verify::Hashes};
    });
}

void spherewalk_dataset_destroy(spherewalk_dataset* dataset) {
    delete dataset;
}

spherewalk_status spherewalk_dataset_info_init(spherewalk_dataset_info* info, size_t size) {
    return initialised(info, size);
}

spherewalk_status spherewalk_dataset_get_info(const spherewalk_dataset* dataset,
                                              spherewalk_dataset_info* info) {
    return guarded([&] {
        const DatasetInfo& source = given(dataset, "dataset").dataset->info();
        auto result = CStruct<spherewalk_dataset_info>::defaults();
        result.id = source.id.c_str();
        result.name = source.name.c_str();
        result.photo_count = source.photos.size();
        result.camera_count = source.cameras.size();
        result.sphere_radius_m = source.sphereRadiusM.value_or(0);
        result.ceiling_m = source.ceilingM;
        result.step_m = source.stepM;
        give(result, info);
    });
}

spherewalk_status spherewalk_photo_init(spherewalk_photo* photo, size_t size) {
    return initialised(photo, size);
}

spherewalk_status spherewalk_dataset_get_photo(const spherewalk_dataset* dataset, uint64_t index,
                                               spherewalk_photo* photo) {
    return guarded([&] {
        const DatasetPhoto& source =
            elementAt(given(dataset, "dataset").dataset->info().photos, index, "photo");
        auto result = CStruct<spherewalk_photo>::defaults();
        result.file = source.file.c_str();
        result.station = source.station.c_str();
        result.rotation_source = source.rotationSource.c_str();
        result.width = source.width;
        result.height = source.height;
        result.room_from_photo = cPose(source.roomFromPhoto);
        fillSigmas(source, result);
        give(result, photo);
    });
}

spherewalk_status spherewalk_dataset_get_camera(const spherewalk_dataset* dataset, uint64_t index,
                                                const char** name, spherewalk_intrinsics* intrinsics) {
    return guarded([&] {
        const SuggestedCamera& source =
            elementAt(given(dataset, "dataset").dataset->info().cameras, index, "suggested camera");
        giveCamera(source.intrinsics, intrinsics);
        if (name != nullptr) {
            *name = source.name.c_str();
        }
    });
}

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
        const std::string_view content = yamlOf(yaml, size_bytes, "camera");
        *camera = new spherewalk_camera{CameraModel(parseCameraInfo(content, "from memory"))};
    });
}

spherewalk_status spherewalk_sensor_read(const char* file, const spherewalk_camera* camera,
                                         spherewalk_sensor** sensor) {
    return guarded([&] {
        given(sensor, "sensor") = nullptr;
        const CameraModel& model = given(camera, "camera").model;
        *sensor = new spherewalk_sensor{Sensor(readSensor(&given(file, "file")), model)};
    });
}

spherewalk_status spherewalk_sensor_parse(const char* yaml, uint64_t size_bytes,
                                          const spherewalk_camera* camera, spherewalk_sensor** sensor) {
    return guarded([&] {
        given(sensor, "sensor") = nullptr;
        const CameraModel& model = given(camera, "camera").model;
        const std::string_view content = yamlOf(yaml, size_bytes, "sensor");
        *sensor = new spherewalk_sensor{Sensor(parseSensor(content, "from memory"), model)};
    });
}

void spherewalk_camera_destroy(spherewalk_camera* camera) {
    delete camera;
}

spherewalk_status spherewalk_camera_get_intrinsics(const spherewalk_camera* camera,
                                                   spherewalk_intrinsics* intrinsics) {
    return guarded([&] { giveCamera(given(camera, "camera").model.intrinsics(), intrinsics); });
}

} // extern "C"

} // namespace spherewalk::render
