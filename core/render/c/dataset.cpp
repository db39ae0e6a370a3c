// SPDX-License-Identifier: Apache-2.0
#include "c_enums.h"
#include "c_handles.h"
#include "c_interface.h"

namespace spherewalk::render {

namespace {

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

} // namespace

} // namespace spherewalk::render

using namespace spherewalk;
using namespace spherewalk::render;

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
        give(cIntrinsics(source.intrinsics), intrinsics);
        if (name != nullptr) {
            *name = source.name.c_str();
        }
    });
}
