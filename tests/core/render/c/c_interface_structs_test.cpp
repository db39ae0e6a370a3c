// SPDX-License-Identifier: Apache-2.0
// Structs of the C interface as older and newer programs know them, and of sizes that none knows.
#include "c/c_test.h"
#include "c/interface.h"

#include "spherewalk/base/json.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace spherewalk::render {

using test::CInterface;
using test::expectStatus;
using test::ready;

using CStructs = CInterface;

namespace {

/// A struct that has grown twice: what old and new programs have of it.
struct Grown {
    std::size_t struct_size;
    std::int64_t first;
    std::int64_t second;
    std::int64_t third;
};

} // namespace

template <>
struct CStruct<Grown> {
    static constexpr const char* kName = "grown";
    static constexpr std::array kSizes{offsetof(Grown, second), offsetof(Grown, third), sizeof(Grown)};

    static Grown defaults() { return {sizeof(Grown), 10, 20, 30}; }
};

// Memory of exactly the old size: a sanitizer sees a byte too many.
TEST_F(CStructs, OldStructsAreTakenAndFilledAsFarAsTheyGo) {
    for (const std::size_t size : CStruct<Grown>::kSizes) {
        const auto memory = std::make_unique<char[]>(size);
        auto* callers = reinterpret_cast<Grown*>(memory.get());
        ASSERT_EQ(initialised(callers, size), SPHEREWALK_OK);
        ASSERT_EQ(callers->struct_size, size);
        ASSERT_EQ(callers->first, 10);
        callers->first = 1;
        const Grown today = taken(callers);
        EXPECT_EQ(today.struct_size, sizeof(Grown));
        EXPECT_EQ(today.first, 1);
        EXPECT_EQ(today.second, 20);
        EXPECT_EQ(today.third, 30);
        give(Grown{sizeof(Grown), 7, 8, 9}, callers);
        EXPECT_EQ(callers->struct_size, size);
        EXPECT_EQ(callers->first, 7);
    }
}

namespace {

/// All that must hold of a struct's sizes; use: a call that takes or fills the struct.
template <class Struct, class Use>
void expectSizesChecked(spherewalk_status (*init)(Struct*, std::size_t), const Use& use) {
    SCOPED_TRACE(CStruct<Struct>::kName);
    expectStatus(init(nullptr, sizeof(Struct)), SPHEREWALK_INVALID_INPUT, "is NULL");
    auto callers = ready(init);
    EXPECT_EQ(callers.struct_size, sizeof(Struct));
    for (const std::size_t size :
         {std::size_t{0}, std::size_t{1}, sizeof(std::size_t), sizeof(Struct) - 1, sizeof(Struct) - 8}) {
        expectStatus(init(&callers, size), SPHEREWALK_INVALID_INPUT, "_init()");
        callers.struct_size = size;
        expectStatus(use(&callers), SPHEREWALK_INVALID_INPUT, "which no version of it has had");
        EXPECT_EQ(callers.struct_size, size);
    }
    for (const std::size_t size : {sizeof(Struct) + 1, sizeof(Struct) + 8, SIZE_MAX}) {
        expectStatus(init(&callers, size), SPHEREWALK_INVALID_INPUT, "as new as the header");
        callers.struct_size = size;
        expectStatus(use(&callers), SPHEREWALK_INVALID_INPUT, "as new as the header");
    }
}

} // namespace

TEST_F(CStructs, ACameraOfMoreParametersThanAProgramKnowsIsRefused) {
    CameraIntrinsics tilted = CameraIntrinsics::pinhole(8, 8, 1);
    tilted.lens = LensModel::RationalPolynomial;
    tilted.distortion = {0.1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0.1, 0.2};
    info.cameras.push_back({"c", tilted});
    writeFile(folder / kDatasetFile, bytesOf(toJson(info).dump()));
    reopen();
    auto known = ready(spherewalk_intrinsics_init);
    ASSERT_EQ(spherewalk_dataset_get_camera(dataset.get(), 0, nullptr, &known), SPHEREWALK_OK);
    EXPECT_EQ(std::vector<double>(known.distortion, known.distortion + known.distortion_count),
              tilted.distortion);
    constexpr std::size_t kOldSize = offsetof(spherewalk_intrinsics, distortion) + 8 * sizeof(double);
    ASSERT_EQ(spherewalk_intrinsics_init(&known, kOldSize), SPHEREWALK_OK);
    expectStatus(spherewalk_dataset_get_camera(dataset.get(), 0, nullptr, &known), SPHEREWALK_UNSUPPORTED,
                 "compiled for 8");
    ASSERT_EQ(spherewalk_intrinsics_pinhole(8, 8, 1, &known), SPHEREWALK_OK);
    known.lens = SPHEREWALK_LENS_RATIONAL_POLYNOMIAL;
    known.distortion_count = 14; // more than the program's struct has
    spherewalk_camera* made = nullptr;
    expectStatus(spherewalk_camera_create(&known, &made), SPHEREWALK_INVALID_INPUT, "0 to 8");
}

TEST_F(CStructs, StructsOfUnknownSizesAreRefused) {
    info.cameras.push_back({"c", CameraIntrinsics::pinhole(8, 8, 1)});
    writeFile(folder / kDatasetFile, bytesOf(toJson(info).dump()));
    reopen();
    const auto stream = this->stream();
    const auto rendered = [&](const spherewalk_view_options* options, const spherewalk_view* into,
                              spherewalk_report* report) {
        return spherewalk_renderer_render(renderer.get(), camera.get(), &kHere, options, into, report);
    };
    const spherewalk_view into = view();
    expectSizesChecked(spherewalk_dataset_info_init,
                       [&](auto* s) { return spherewalk_dataset_get_info(dataset.get(), s); });
    expectSizesChecked(spherewalk_photo_init,
                       [&](auto* s) { return spherewalk_dataset_get_photo(dataset.get(), 0, s); });
    expectSizesChecked(spherewalk_intrinsics_init,
                       [&](auto* s) { return spherewalk_intrinsics_pinhole(8, 8, 1, s); });
    expectSizesChecked(spherewalk_intrinsics_init,
                       [&](auto* s) { return spherewalk_dataset_get_camera(dataset.get(), 0, nullptr, s); });
    expectSizesChecked(spherewalk_intrinsics_init,
                       [&](auto* s) { return spherewalk_camera_get_intrinsics(camera.get(), s); });
    expectSizesChecked(spherewalk_intrinsics_init, [&](auto* s) {
        spherewalk_camera* made = camera.get();
        const spherewalk_status status = spherewalk_camera_create(s, &made);
        EXPECT_EQ(made, nullptr);
        return status;
    });
    expectSizesChecked(spherewalk_renderer_options_init, [&](auto* s) {
        spherewalk_renderer* made = renderer.get();
        const spherewalk_status status = spherewalk_renderer_create(dataset.get(), s, &made);
        EXPECT_EQ(made, nullptr);
        return status;
    });
    expectSizesChecked(spherewalk_view_options_init, [&](auto* s) { return rendered(s, &into, nullptr); });
    expectSizesChecked(spherewalk_overlay_init, [&](auto* s) {
        auto options = ready(spherewalk_view_options_init);
        options.overlays = &s;
        options.overlay_count = 1;
        return rendered(&options, &into, nullptr);
    });
    expectSizesChecked(spherewalk_intrinsics_init, [&](auto* s) {
        auto overlay = ready(spherewalk_overlay_init);
        overlay.camera = s;
        const spherewalk_overlay* overlays = &overlay;
        auto options = ready(spherewalk_view_options_init);
        options.overlays = &overlays;
        options.overlay_count = 1;
        return rendered(&options, &into, nullptr);
    });
    expectSizesChecked(spherewalk_view_init, [&](auto* s) { return rendered(nullptr, s, nullptr); });
    expectSizesChecked(spherewalk_report_init, [&](auto* s) { return rendered(nullptr, &into, s); });
    expectSizesChecked(spherewalk_report_init, [&](auto* s) {
        return spherewalk_stream_next(stream.get(), &kHere, 0, nullptr, &into, s);
    });
    const double place[] = {0, 0, 0};
    expectSizesChecked(spherewalk_probe_options_init, [&](auto* s) {
        return spherewalk_renderer_probe(renderer.get(), place, s, nullptr, nullptr);
    });
    expectSizesChecked(spherewalk_probe_init, [&](auto* s) {
        return spherewalk_renderer_probe(renderer.get(), place, nullptr, s, nullptr);
    });
    expectSizesChecked(spherewalk_light_init, [&](auto* s) {
        return spherewalk_renderer_probe(renderer.get(), place, nullptr, nullptr, s);
    });
    expectSizesChecked(spherewalk_load_counters_init,
                       [&](auto* s) { return spherewalk_renderer_get_counters(renderer.get(), s); });
    expectSizesChecked(spherewalk_stream_options_init, [&](auto* s) {
        spherewalk_stream* made = stream.get();
        const spherewalk_status status = spherewalk_stream_create(renderer.get(), camera.get(), s, &made);
        EXPECT_EQ(made, nullptr);
        return status;
    });
    expectSizesChecked(spherewalk_stream_counters_init,
                       [&](auto* s) { return spherewalk_stream_get_counters(stream.get(), s); });
    EXPECT_EQ(pixels, std::vector<std::uint8_t>(pixels.size(), 7));
}

} // namespace spherewalk::render
