// SPDX-License-Identifier: Apache-2.0
// Values that mean nothing to the C interface are answered by a status and a sentence, and change nothing.
#include "c/c_test.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace spherewalk::render {

using test::CInterface;
using test::expectStatus;
using test::kInfinity;
using test::kNan;
using test::ready;

using CValues = CInterface;

namespace {

/// Buffers into this memory that cannot hold a view for which it has just enough.
std::vector<spherewalk_buffer> unfit(std::vector<std::uint8_t>& memory) {
    const std::uint64_t size = memory.size();
    constexpr std::uint64_t kHeight = CValues::kHeight;
    const std::uint64_t row = size / kHeight;
    std::vector<spherewalk_buffer> result;
    for (const auto& [bytes, stride] : std::initializer_list<std::pair<std::uint64_t, std::uint64_t>>{
             {size - 1, row},
             {0, row},
             {row - 1, row},
             {size, 0},
             {size, row - 1},
             {size, row + 1},
             {size, UINT64_MAX},
             {size, UINT64_MAX / kHeight + 1}, // times the height: more than 64 bits
             {UINT64_MAX, row},
             {UINT64_MAX, UINT64_MAX / kHeight}}) {
        result.push_back({memory.data(), bytes, stride});
    }
    return result;
}

} // namespace

TEST_F(CValues, BuffersThatCannotHoldTheViewAreRefusedUntouched) {
    const auto status = [&](const spherewalk_view& into) {
        return spherewalk_renderer_render(renderer.get(), camera.get(), &kHere, nullptr, &into, nullptr);
    };
    for (const auto& [member, name, pixelBytes] : {std::tuple{&spherewalk_view::rgb, "rgb", 3},
                                                   {&spherewalk_view::depth, "depth", 4},
                                                   {&spherewalk_view::error_px, "error_px", 4},
                                                   {&spherewalk_view::flags, "flags", 1},
                                                   {&spherewalk_view::overlaid, "overlaid", 1}}) {
        std::vector<std::uint8_t> memory(static_cast<std::size_t>(pixelBytes * kWidth) * kHeight, 7);
        for (const spherewalk_buffer& buffer : unfit(memory)) {
            auto into = view();
            into.*member = buffer;
            EXPECT_EQ(status(into), SPHEREWALK_INVALID_INPUT)
                << buffer.size_bytes << ' ' << buffer.row_stride_bytes;
            EXPECT_THAT(spherewalk_last_error(), testing::HasSubstr(name));
        }
        EXPECT_EQ(memory, std::vector<std::uint8_t>(memory.size(), 7));
        auto into = view();
        into.*member = {memory.data(), memory.size(), memory.size() / kHeight};
        EXPECT_EQ(status(into), SPHEREWALK_OK);
    }
    auto into = view();
    into.rgb.data = nullptr;
    expectStatus(status(into), SPHEREWALK_INVALID_INPUT, "rgb");
}

TEST_F(CValues, OverlaysThatAreNoneAreRefused) {
    std::vector<std::uint8_t> memory(static_cast<std::size_t>(4 * kWidth) * kHeight, 7);
    const spherewalk_source fit{memory.data(), memory.size(), std::uint64_t{4} * kWidth};
    const auto whole = [&] {
        auto overlay = ready(spherewalk_overlay_init);
        overlay.rgba = overlay.depth = overlay.room_depth = fit;
        return overlay;
    };
    const auto status = [&](const spherewalk_overlay& overlay) {
        const std::vector<const spherewalk_overlay*> overlays{&overlay};
        auto options = ready(spherewalk_view_options_init);
        options.overlays = overlays.data();
        options.overlay_count = 1;
        return render(kHere, &options);
    };
    EXPECT_EQ(status(whole()), SPHEREWALK_OK) << spherewalk_last_error();
    pixels.assign(pixels.size(), 7);
    for (const auto& [member, name] : {std::pair{&spherewalk_overlay::rgba, "rgba"},
                                       {&spherewalk_overlay::depth, "depth"},
                                       {&spherewalk_overlay::room_depth, "room_depth"},
                                       {&spherewalk_overlay::shadow, "shadow"}}) {
        for (const auto& [data, size, stride] : unfit(memory)) {
            auto overlay = whole();
            overlay.*member = {data, size, stride};
            expectStatus(status(overlay), SPHEREWALK_INVALID_INPUT, name);
        }
    }
    auto overlay = whole();
    overlay.rgba.data = nullptr;
    expectStatus(status(overlay), SPHEREWALK_INVALID_INPUT, "NULL");
    overlay = whole();
    overlay.depth.data = nullptr;
    expectStatus(status(overlay), SPHEREWALK_INVALID_INPUT, "NULL");
    overlay = whole();
    std::vector<float> shares(static_cast<std::size_t>(kWidth) * kHeight, 0.5F);
    shares.back() = kNan;
    overlay.shadow = {shares.data(), 4 * shares.size(), std::uint64_t{4} * kWidth};
    expectStatus(status(overlay), SPHEREWALK_INVALID_INPUT, "its shadow is nan in the pixel");
    overlay = whole();
    overlay.alpha = 2;
    expectStatus(status(overlay), SPHEREWALK_INVALID_INPUT, "alpha");
    overlay = whole();
    overlay.reserved = 1;
    expectStatus(status(overlay), SPHEREWALK_INVALID_INPUT, "reserved");
    auto intrinsics = ready(spherewalk_intrinsics_init); // of 0 x 0 pixels
    overlay = whole();
    overlay.camera = &intrinsics;
    expectStatus(status(overlay), SPHEREWALK_INVALID_INPUT, "pixels");
    ASSERT_EQ(spherewalk_intrinsics_pinhole(kWidth, kHeight + 1, 1, &intrinsics), SPHEREWALK_OK);
    expectStatus(status(overlay), SPHEREWALK_INVALID_INPUT, "rgba"); // too small for that camera
    EXPECT_EQ(pixels, std::vector<std::uint8_t>(pixels.size(), 7));
}

TEST_F(CValues, ListsOfOverlaysThatAreNoneAreRefused) {
    const spherewalk_overlay* missing = nullptr;
    auto options = ready(spherewalk_view_options_init);
    options.overlay_count = 1;
    expectStatus(render(kHere, &options), SPHEREWALK_INVALID_INPUT, "overlays is NULL");
    options.overlays = &missing;
    expectStatus(render(kHere, &options), SPHEREWALK_INVALID_INPUT, "spherewalk_overlay is NULL");
    for (const std::uint64_t count : {std::uint64_t{1001}, UINT64_MAX}) {
        options.overlay_count = count;
        expectStatus(render(kHere, &options), SPHEREWALK_INVALID_INPUT, "overlays");
    }
    options.overlay_count = 0;
    EXPECT_EQ(render(kHere, &options), SPHEREWALK_OK);
    options.overlay_edges = 2;
    expectStatus(render(kHere, &options), SPHEREWALK_INVALID_INPUT, "edges");
    options = ready(spherewalk_view_options_init);
    options.photo_colours = 2;
    expectStatus(render(kHere, &options), SPHEREWALK_INVALID_INPUT, "photo_colours");
}

TEST_F(CValues, NumbersThatMeanNothingAreRefused) {
    for (const std::int32_t none : {-1, 99, INT32_MIN, INT32_MAX}) {
        SCOPED_TRACE(none);
        auto wanted = ready(spherewalk_view_options_init);
        wanted.scene = none;
        expectStatus(render(kHere, &wanted), SPHEREWALK_INVALID_INPUT, "scene model");
        wanted = ready(spherewalk_view_options_init);
        wanted.sampling = none;
        expectStatus(render(kHere, &wanted), SPHEREWALK_INVALID_INPUT, "sampling");

        spherewalk_dataset* dataset2 = dataset.get();
        expectStatus(spherewalk_dataset_open(folder.path().c_str(), none, nullptr, nullptr, &dataset2),
                     SPHEREWALK_INVALID_INPUT, "check of a dataset");
        EXPECT_EQ(dataset2, nullptr);

        spherewalk_renderer* renderer2 = nullptr;
        auto rendererOptions = options();
        rendererOptions.verify_photos = none;
        expectStatus(spherewalk_renderer_create(dataset.get(), &rendererOptions, &renderer2),
                     SPHEREWALK_INVALID_INPUT, "check of photos");
        rendererOptions = options();
        rendererOptions.reserved = none;
        expectStatus(spherewalk_renderer_create(dataset.get(), &rendererOptions, &renderer2),
                     SPHEREWALK_INVALID_INPUT, "reserved");

        spherewalk_stream* stream = nullptr;
        auto streamOptions = ready(spherewalk_stream_options_init);
        streamOptions.late = none;
        expectStatus(spherewalk_stream_create(renderer.get(), camera.get(), &streamOptions, &stream),
                     SPHEREWALK_INVALID_INPUT, "late");
        streamOptions = ready(spherewalk_stream_options_init);
        streamOptions.reserved = none;
        expectStatus(spherewalk_stream_create(renderer.get(), camera.get(), &streamOptions, &stream),
                     SPHEREWALK_INVALID_INPUT, "reserved");
    }
    auto wanted = ready(spherewalk_view_options_init);
    for (const std::int32_t threads : {-1, INT32_MIN, 4097, INT32_MAX}) {
        wanted.threads = threads;
        expectStatus(render(kHere, &wanted), SPHEREWALK_INVALID_INPUT, "threads");
    }
    wanted = ready(spherewalk_view_options_init);
    for (const double tolerance : {kNan, kInfinity}) {
        wanted.tolerance_db = tolerance;
        expectStatus(render(kHere, &wanted), SPHEREWALK_INVALID_INPUT, "tolerance_db");
    }
}

TEST_F(CValues, PosesAndTimesThatAreNoneAreRefused) {
    const auto stream = this->stream();
    const auto into = view();
    for (const double none : {kNan, kInfinity, -kInfinity}) {
        for (double spherewalk_pose::*member :
             {&spherewalk_pose::x, &spherewalk_pose::z, &spherewalk_pose::qw, &spherewalk_pose::qz}) {
            spherewalk_pose pose = kHere;
            pose.*member = none;
            expectStatus(render(pose), SPHEREWALK_INVALID_INPUT, "pose");
            expectStatus(spherewalk_stream_next(stream.get(), &pose, 0, nullptr, &into, nullptr),
                         SPHEREWALK_INVALID_INPUT, "pose");
        }
        expectStatus(spherewalk_stream_next(stream.get(), &kHere, none, nullptr, &into, nullptr),
                     SPHEREWALK_INVALID_INPUT, "time");
    }
    for (const double length : {0.0, 0.5, 1.1, 1e200}) {
        spherewalk_pose pose = kHere;
        pose.qw = length;
        expectStatus(render(pose), SPHEREWALK_INVALID_INPUT, "pose");
        const spherewalk_pose before = pose;
        expectStatus(spherewalk_optical_pose(&pose, &pose), SPHEREWALK_INVALID_INPUT, "quaternion");
        EXPECT_EQ(pose.qw, before.qw);
    }
    EXPECT_EQ(pixels, std::vector<std::uint8_t>(pixels.size(), 7));
}

TEST_F(CValues, FarPosesAreServedAndEndlessOnesRefused) {
    const auto stream = this->stream();
    std::vector<float> depth(pixels.size() / 3);
    std::vector<float> errorPx(pixels.size() / 3);
    auto into = view();
    into.depth = {depth.data(), 4 * depth.size(), 4 * kWidth};
    into.error_px = {errorPx.data(), 4 * errorPx.size(), 4 * kWidth};
    double time = -1e300;
    for (const double huge : {1e5, 5e8, 1e10, -1e155, 1e300, 1.7e308, -1.7e308}) {
        const spherewalk_status expected =
            huge == 1e5 || huge == 5e8 ? SPHEREWALK_OK : SPHEREWALK_INVALID_INPUT;
        const spherewalk_pose pose{huge, -huge, huge, 1, 0, 0, 0};
        EXPECT_EQ(render(pose), expected) << huge;
        EXPECT_EQ(spherewalk_stream_next(stream.get(), &pose, time, nullptr, &into, nullptr), expected);
        EXPECT_EQ(spherewalk_stream_wait_for_prefetch(stream.get()), SPHEREWALK_OK);
        EXPECT_TRUE(std::ranges::none_of(depth, [](float z) { return std::isnan(z); })) << huge;
        EXPECT_TRUE(std::ranges::none_of(errorPx, [](float px) { return std::isnan(px); })) << huge;
        time += 1e300;
    }
}

TEST_F(CValues, CamerasThatAreNoneAreRefused) {
    spherewalk_camera* made = camera.get();
    const auto refused = [&](const auto& change, const std::string& part) {
        auto intrinsics = ready(spherewalk_intrinsics_init);
        ASSERT_EQ(spherewalk_intrinsics_pinhole(8, 8, 1, &intrinsics), SPHEREWALK_OK);
        change(intrinsics);
        made = camera.get();
        expectStatus(spherewalk_camera_create(&intrinsics, &made), SPHEREWALK_INVALID_INPUT, part);
        EXPECT_EQ(made, nullptr);
    };
    for (const std::int32_t size : {0, -1, INT32_MIN, 32769, INT32_MAX}) {
        refused([&](auto& k) { k.width = size; }, "pixels");
        refused([&](auto& k) { k.height = size; }, "pixels");
        auto into = ready(spherewalk_intrinsics_init);
        expectStatus(spherewalk_intrinsics_pinhole(size, 8, 1, &into), SPHEREWALK_INVALID_INPUT, "pixels");
        EXPECT_EQ(into.fx, 0);
    }
    for (const double none : {kNan, kInfinity, 0.0, -1.0}) {
        refused([&](auto& k) { k.fx = none; }, "focal");
        auto into = ready(spherewalk_intrinsics_init);
        expectStatus(spherewalk_intrinsics_pinhole(8, 8, none, &into), SPHEREWALK_INVALID_INPUT,
                     "field of view");
    }
    auto into = ready(spherewalk_intrinsics_init);
    expectStatus(spherewalk_intrinsics_pinhole(8, 8, std::numbers::pi, &into), SPHEREWALK_INVALID_INPUT,
                 "field of view");
    refused([](auto& k) { k.cy = kNan; }, "principal point");
    for (const std::int32_t count : {-1, 9, 15, INT32_MIN, INT32_MAX}) {
        refused([&](auto& k) { k.distortion_count = count; }, "distortion parameters");
    }
    refused([](auto& k) { k.lens = SPHEREWALK_LENS_PLUMB_BOB; }, "has 5 distortion parameters");
    refused([](auto& k) { k.lens = 4; }, "lens model");
    refused(
        [](auto& k) {
            k.lens = SPHEREWALK_LENS_EQUIDISTANT;
            k.distortion_count = 4;
            k.distortion[3] = kInfinity;
        },
        "distortion parameter");
}

TEST_F(CValues, TextThatIsNoCameraIsRefused) {
    const std::string tooLong((1 << 20) + 1, ' ');
    const std::vector<std::string> texts{"",
                                         "image_width: 3",
                                         "[",
                                         std::string(100000, '['),
                                         std::string(100000, '{'),
                                         std::string("\0\0\0", 3),
                                         "\xff\xfe\xfd",
                                         "&a [*a]",
                                         tooLong};
    for (const std::string& text : texts) {
        spherewalk_camera* made = camera.get();
        EXPECT_EQ(spherewalk_camera_parse(text.data(), text.size(), &made), SPHEREWALK_INVALID_INPUT)
            << text.substr(0, 20);
        EXPECT_EQ(made, nullptr);
    }
    spherewalk_camera* made = nullptr;
    EXPECT_EQ(spherewalk_camera_parse("x", UINT64_MAX, &made), SPHEREWALK_INVALID_INPUT);
    EXPECT_EQ(spherewalk_camera_read((folder / "none.yaml").c_str(), &made), SPHEREWALK_NOT_FOUND);
    EXPECT_EQ(spherewalk_camera_read(folder.path().c_str(), &made), SPHEREWALK_INVALID_INPUT);
    EXPECT_EQ(made, nullptr);
}

} // namespace spherewalk::render
