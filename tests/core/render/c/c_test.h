// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "random.h"
#include "temporary_folder.h"
#include "test_dataset.h"

#include "spherewalk/geometry/rotation.h"
#include "spherewalk/light.h"
#include "spherewalk/sensor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace spherewalk::test {

inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Handles of the C interface that are given back at the end of the scope.
template <class Handle, void (*destroy)(Handle*)>
struct Destroy {
    void operator()(Handle* handle) const { destroy(handle); }
};

template <class Handle, void (*destroy)(Handle*)>
using Owned = std::unique_ptr<Handle, Destroy<Handle, destroy>>;

using DatasetHandle = Owned<spherewalk_dataset, spherewalk_dataset_destroy>;
using CameraHandle = Owned<spherewalk_camera, spherewalk_camera_destroy>;
using RendererHandle = Owned<spherewalk_renderer, spherewalk_renderer_destroy>;
using SensorHandle = Owned<spherewalk_sensor, spherewalk_sensor_destroy>;
using StreamHandle = Owned<spherewalk_stream, spherewalk_stream_destroy>;

/// A struct of the C interface, made ready.
template <class Struct>
Struct ready(spherewalk_status (*init)(Struct*, std::size_t)) {
    Struct result;
    EXPECT_EQ(init(&result, sizeof result), SPHEREWALK_OK);
    return result;
}

/// Expects that a call ended with this status and a sentence that contains the part.
inline void expectStatus(spherewalk_status status, spherewalk_status expected, const std::string& part) {
    EXPECT_STREQ(spherewalk_status_name(status), spherewalk_status_name(expected));
    if (status != SPHEREWALK_OK) {
        EXPECT_THAT(spherewalk_last_error(), testing::HasSubstr(part));
    }
}

inline spherewalk_pose cPose(const Rigid3& pose) {
    const Eigen::Quaterniond& q = pose.rotation;
    const Eigen::Vector3d& p = pose.translation;
    return {p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z()};
}

/// Two photos one metre apart, opened by the C interface, and a small camera.
class CInterface : public testing::Test {
  public:
    CInterface() {
        info = writeTestDataset(folder.path(), poses, smoothWorld, 256, 2.0);
        reopen();
        renderer = make(options());
        spherewalk_intrinsics intrinsics = ready(spherewalk_intrinsics_init);
        EXPECT_EQ(spherewalk_intrinsics_pinhole(kWidth, kHeight, 1.2, &intrinsics), SPHEREWALK_OK);
        camera = make(intrinsics);
        pixels.assign(static_cast<std::size_t>(3 * kWidth) * kHeight, 7);
    }

    SensorHandle sensor(const std::string& yaml) {
        spherewalk_sensor* made = nullptr;
        EXPECT_EQ(spherewalk_sensor_parse(yaml.data(), yaml.size(), camera.get(), &made), SPHEREWALK_OK)
            << spherewalk_last_error();
        return SensorHandle(made);
    }

    void reopen() {
        spherewalk_dataset* made = nullptr;
        EXPECT_EQ(
            spherewalk_dataset_open(folder.path().c_str(), SPHEREWALK_VERIFY_SIZES, nullptr, nullptr, &made),
            SPHEREWALK_OK)
            << spherewalk_last_error();
        dataset.reset(made);
    }

    static spherewalk_renderer_options options() { return ready(spherewalk_renderer_options_init); }

    RendererHandle make(const spherewalk_renderer_options& wanted) const {
        spherewalk_renderer* made = nullptr;
        EXPECT_EQ(spherewalk_renderer_create(dataset.get(), &wanted, &made), SPHEREWALK_OK);
        return RendererHandle(made);
    }

    static CameraHandle make(const spherewalk_intrinsics& intrinsics) {
        spherewalk_camera* made = nullptr;
        EXPECT_EQ(spherewalk_camera_create(&intrinsics, &made), SPHEREWALK_OK) << spherewalk_last_error();
        return CameraHandle(made);
    }

    StreamHandle stream() const {
        spherewalk_stream* made = nullptr;
        EXPECT_EQ(spherewalk_stream_create(renderer.get(), camera.get(), nullptr, &made), SPHEREWALK_OK);
        return StreamHandle(made);
    }

    /// Into `pixels`.
    spherewalk_view view() {
        auto result = ready(spherewalk_view_init);
        result.rgb = {pixels.data(), pixels.size(), std::uint64_t{3} * kWidth};
        return result;
    }

    spherewalk_status render(const spherewalk_pose& pose, const spherewalk_view_options* wanted = nullptr) {
        const spherewalk_view into = view();
        return spherewalk_renderer_render(renderer.get(), camera.get(), &pose, wanted, &into, nullptr);
    }

    static constexpr int kWidth = 61;
    static constexpr int kHeight = 43;
    static constexpr spherewalk_pose kHere{0.1, 0, 0, 1, 0, 0, 0};

    TemporaryFolder folder;
    std::vector<Rigid3> poses{Rigid3{}, {Eigen::Quaterniond::Identity(), {1, 0, 0}}};
    render::DatasetInfo info;
    DatasetHandle dataset;
    RendererHandle renderer;
    CameraHandle camera;
    std::vector<std::uint8_t> pixels;
};

} // namespace spherewalk::test
