// SPDX-License-Identifier: Apache-2.0
// What a caller of the C interface can get wrong is answered by a status and a sentence, and changes nothing.
#include "c_handles.h"
#include "c_interface.h"
#include "c_test.h"

#include <cmath>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <thread>

namespace spherewalk::render {

using test::CInterface;
using test::expectStatus;
using test::ready;

using CMisuse = CInterface;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

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
TEST_F(CMisuse, OldStructsAreTakenAndFilledAsFarAsTheyGo) {
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

TEST_F(CMisuse, StructsOfUnknownSizesAreRefused) {
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

TEST_F(CMisuse, NullIsAnswered) {
    const auto stream = this->stream();
    const auto into = view();
    const auto* d = dataset.get();
    const auto* r = renderer.get();
    const auto* c = camera.get();
    auto* s = stream.get();
    spherewalk_pose pose = kHere;
    spherewalk_dataset* madeDataset = nullptr;
    spherewalk_camera* madeCamera = nullptr;
    spherewalk_renderer* madeRenderer = nullptr;
    spherewalk_stream* madeStream = nullptr;
    auto all = ready(spherewalk_dataset_info_init);
    auto photo = ready(spherewalk_photo_init);
    auto intrinsics = ready(spherewalk_intrinsics_init);
    auto load = ready(spherewalk_load_counters_init);
    auto counters = ready(spherewalk_stream_counters_init);
    const std::vector<spherewalk_status> statuses{
        spherewalk_optical_pose(nullptr, &pose),
        spherewalk_optical_pose(&pose, nullptr),
        spherewalk_dataset_open(nullptr, 0, nullptr, nullptr, &madeDataset),
        spherewalk_dataset_open(folder.path().c_str(), 0, nullptr, nullptr, nullptr),
        spherewalk_dataset_get_info(nullptr, &all),
        spherewalk_dataset_get_info(d, nullptr),
        spherewalk_dataset_get_photo(nullptr, 0, &photo),
        spherewalk_dataset_get_photo(d, 0, nullptr),
        spherewalk_dataset_get_camera(nullptr, 0, nullptr, &intrinsics),
        spherewalk_intrinsics_pinhole(1, 1, 1, nullptr),
        spherewalk_camera_create(nullptr, &madeCamera),
        spherewalk_camera_create(&intrinsics, nullptr),
        spherewalk_camera_read(nullptr, &madeCamera),
        spherewalk_camera_read("x", nullptr),
        spherewalk_camera_parse(nullptr, 0, &madeCamera),
        spherewalk_camera_parse("x", 1, nullptr),
        spherewalk_camera_get_intrinsics(nullptr, &intrinsics),
        spherewalk_camera_get_intrinsics(c, nullptr),
        spherewalk_renderer_create(nullptr, nullptr, &madeRenderer),
        spherewalk_renderer_create(d, nullptr, nullptr),
        spherewalk_renderer_render(nullptr, c, &pose, nullptr, &into, nullptr),
        spherewalk_renderer_render(r, nullptr, &pose, nullptr, &into, nullptr),
        spherewalk_renderer_render(r, c, nullptr, nullptr, &into, nullptr),
        spherewalk_renderer_render(r, c, &pose, nullptr, nullptr, nullptr),
        spherewalk_renderer_get_counters(nullptr, &load),
        spherewalk_renderer_get_counters(r, nullptr),
        spherewalk_stream_create(nullptr, c, nullptr, &madeStream),
        spherewalk_stream_create(r, nullptr, nullptr, &madeStream),
        spherewalk_stream_create(r, c, nullptr, nullptr),
        spherewalk_stream_next(nullptr, &pose, 0, nullptr, &into, nullptr),
        spherewalk_stream_next(s, nullptr, 0, nullptr, &into, nullptr),
        spherewalk_stream_next(s, &pose, 0, nullptr, nullptr, nullptr),
        spherewalk_stream_wait_for_prefetch(nullptr),
        spherewalk_stream_get_counters(nullptr, &counters),
        spherewalk_stream_get_counters(s, nullptr),
    };
    for (std::size_t i = 0; i < statuses.size(); ++i) {
        EXPECT_EQ(statuses[i], SPHEREWALK_INVALID_INPUT) << "call " << i;
    }
    EXPECT_THAT(spherewalk_last_error(), testing::HasSubstr("NULL"));
    spherewalk_dataset_destroy(nullptr);
    spherewalk_camera_destroy(nullptr);
    spherewalk_renderer_destroy(nullptr);
    spherewalk_stream_destroy(nullptr);
}

namespace {

/// Buffers into this memory that cannot hold a view for which it has just enough.
std::vector<spherewalk_buffer> unfit(std::vector<std::uint8_t>& memory) {
    const std::uint64_t size = memory.size();
    constexpr std::uint64_t kHeight = CMisuse::kHeight;
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

TEST_F(CMisuse, BuffersThatCannotHoldTheViewAreRefusedUntouched) {
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

TEST_F(CMisuse, OverlaysThatAreNoneAreRefused) {
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
                                       {&spherewalk_overlay::room_depth, "room_depth"}}) {
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

TEST_F(CMisuse, ListsOfOverlaysThatAreNoneAreRefused) {
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

TEST_F(CMisuse, NumbersThatMeanNothingAreRefused) {
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

TEST_F(CMisuse, PosesAndTimesThatAreNoneAreRefused) {
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

TEST_F(CMisuse, HugePosesAreServed) {
    const auto stream = this->stream();
    std::vector<float> depth(pixels.size() / 3);
    std::vector<float> errorPx(pixels.size() / 3);
    auto into = view();
    into.depth = {depth.data(), 4 * depth.size(), 4 * kWidth};
    into.error_px = {errorPx.data(), 4 * errorPx.size(), 4 * kWidth};
    double time = -1e300;
    for (const double huge : {1e9, -1e155, 1e300, 1.7e308, -1.7e308}) {
        const spherewalk_pose pose{huge, -huge, huge, 1, 0, 0, 0};
        EXPECT_EQ(render(pose), SPHEREWALK_OK) << huge;
        EXPECT_EQ(spherewalk_stream_next(stream.get(), &pose, time, nullptr, &into, nullptr), SPHEREWALK_OK);
        EXPECT_EQ(spherewalk_stream_wait_for_prefetch(stream.get()), SPHEREWALK_OK);
        time += 1e300;
    }
}

TEST_F(CMisuse, CamerasThatAreNoneAreRefused) {
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
    for (const std::int32_t count : {-1, 9, INT32_MIN, INT32_MAX}) {
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

TEST_F(CMisuse, TextThatIsNoCameraIsRefused) {
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

TEST_F(CMisuse, FoldersThatAreNoDatasetAreRefused) {
    const auto status = [&](const std::string& path) {
        spherewalk_dataset* made = dataset.get();
        const spherewalk_status result = spherewalk_dataset_open(path.c_str(), 0, nullptr, nullptr, &made);
        EXPECT_EQ(made, nullptr);
        return result;
    };
    EXPECT_EQ(status(""), SPHEREWALK_NOT_FOUND);
    EXPECT_EQ(status(folder / "none"), SPHEREWALK_NOT_FOUND);
    EXPECT_EQ(status(std::string(100000, 'x')), SPHEREWALK_IO);
    EXPECT_EQ(status("\xff\xfe"), SPHEREWALK_NOT_FOUND);
    writeFile(folder / kDatasetFile, bytesOf("{"));
    EXPECT_EQ(status(folder.path()), SPHEREWALK_CORRUPT);
}

TEST_F(CMisuse, IndexesBeyondTheEndAreRefused) {
    auto photo = ready(spherewalk_photo_init);
    auto intrinsics = ready(spherewalk_intrinsics_init);
    for (const std::uint64_t index : {std::uint64_t{2}, UINT64_MAX, std::uint64_t{1} << 32}) {
        expectStatus(spherewalk_dataset_get_photo(dataset.get(), index, &photo), SPHEREWALK_INVALID_INPUT,
                     "the dataset has 2");
        const char* name = "kept";
        expectStatus(spherewalk_dataset_get_camera(dataset.get(), index, &name, &intrinsics),
                     SPHEREWALK_INVALID_INPUT, "the dataset has 0");
        EXPECT_STREQ(name, "kept");
    }
    EXPECT_EQ(photo.file, nullptr);
}

TEST_F(CMisuse, PhotosDamagedMeanwhileAreCorrupt) {
    Bytes bytes = readFile(folder / info.photos[0].file);
    bytes[bytes.size() / 2] ^= 0x10;
    writeFile(folder / info.photos[0].file, bytes);
    expectStatus(render(kHere), SPHEREWALK_CORRUPT, "photos/0.jpg");
    EXPECT_EQ(pixels, std::vector<std::uint8_t>(pixels.size(), 7));
    spherewalk_pose other = kHere;
    other.x = 1;
    EXPECT_EQ(render(other), SPHEREWALK_OK);
}

TEST_F(CMisuse, StreamsThatLookTooFarAheadAreRefused) {
    for (const double seconds : {kNan, -0.1, 10.1, kInfinity}) {
        spherewalk_stream* made = nullptr;
        auto wanted = ready(spherewalk_stream_options_init);
        wanted.prefetch_seconds = seconds;
        expectStatus(spherewalk_stream_create(renderer.get(), camera.get(), &wanted, &made),
                     SPHEREWALK_INVALID_INPUT, "ahead");
        EXPECT_EQ(made, nullptr);
    }
}

TEST_F(CMisuse, TheSecondThreadOfAStreamIsToldSo) {
    const auto stream = this->stream();
    const auto into = view();
    const std::scoped_lock otherThread(stream->inUse);
    std::thread([&] {
        auto counters = ready(spherewalk_stream_counters_init);
        expectStatus(spherewalk_stream_next(stream.get(), &kHere, 0, nullptr, &into, nullptr),
                     SPHEREWALK_BUSY, "another thread");
        expectStatus(spherewalk_stream_wait_for_prefetch(stream.get()), SPHEREWALK_BUSY, "another thread");
        expectStatus(spherewalk_stream_get_counters(stream.get(), &counters), SPHEREWALK_BUSY,
                     "another thread");
    }).join();
}

TEST_F(CMisuse, TheCallersProgressMayStopOrThrow) {
    spherewalk_dataset* made = nullptr;
    double reached = 0;
    const auto watch = [](void* user, double fraction) {
        *static_cast<double*>(user) = fraction;
        return 0;
    };
    const std::string path = folder.path();
    ASSERT_EQ(spherewalk_dataset_open(path.c_str(), SPHEREWALK_VERIFY_HASHES, watch, &reached, &made),
              SPHEREWALK_OK);
    EXPECT_EQ(reached, 1);
    spherewalk_dataset_destroy(made);
    const auto stop = [](void*, double) { return 1; };
    EXPECT_EQ(spherewalk_dataset_open(path.c_str(), SPHEREWALK_VERIFY_HASHES, stop, nullptr, &made),
              SPHEREWALK_STOPPED);
    EXPECT_EQ(made, nullptr);
    const auto hurl = [](void*, double) -> std::int32_t { throw 5; };
    EXPECT_EQ(spherewalk_dataset_open(path.c_str(), SPHEREWALK_VERIFY_HASHES, hurl, nullptr, &made),
              SPHEREWALK_INTERNAL);
    EXPECT_EQ(made, nullptr);
}

TEST_F(CMisuse, EveryExceptionBecomesAStatus) {
    expectStatus(guarded([] { throw Error(ErrorKind::Busy, "held"); }), SPHEREWALK_BUSY, "held");
    expectStatus(guarded([] { throw std::bad_alloc(); }), SPHEREWALK_FULL, "memory");
    expectStatus(guarded([] { throw std::filesystem::filesystem_error("refused", std::error_code()); }),
                 SPHEREWALK_IO, "refused");
    expectStatus(guarded([] { throw std::logic_error("wrong"); }), SPHEREWALK_INTERNAL, "wrong");
    expectStatus(guarded([] { throw 5; }), SPHEREWALK_INTERNAL, "thrown");
}

TEST_F(CMisuse, TheLastErrorIsOfItsThreadAndStaysUntilTheNext) {
    std::thread([&] {
        EXPECT_STREQ(spherewalk_last_error(), "");
        EXPECT_EQ(spherewalk_stream_wait_for_prefetch(nullptr), SPHEREWALK_INVALID_INPUT);
        const std::string sentence = spherewalk_last_error();
        EXPECT_EQ(render(kHere), SPHEREWALK_OK);
        std::thread([] { EXPECT_STREQ(spherewalk_last_error(), ""); }).join();
        EXPECT_EQ(spherewalk_last_error(), sentence);
    }).join();
}

TEST_F(CMisuse, LongSentencesAreCutBetweenCharacters) {
    for (const std::size_t ascii : {3998U, 3999U, 4000U, 4001U}) {
        const std::string sentence = std::string(ascii, 'x') + "\u20ac\u20ac\u20ac"; // of three bytes each
        guarded([&] { throw Error(ErrorKind::Io, sentence); });
        const std::string kept = spherewalk_last_error();
        EXPECT_LE(kept.size(), 4000U);
        EXPECT_EQ(kept, std::string(std::min<std::size_t>(ascii, 4000), 'x'));
    }
}

} // namespace spherewalk::render
