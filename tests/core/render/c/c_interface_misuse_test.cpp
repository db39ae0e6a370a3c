// SPDX-License-Identifier: Apache-2.0
// What a caller of the C interface can get wrong is answered by a status and a sentence, and changes nothing.
#include "c/c_test.h"
#include "c/handles.h"
#include "c/interface.h"

#include <filesystem>
#include <new>
#include <stdexcept>
#include <thread>

namespace spherewalk::render {

using test::CInterface;
using test::expectStatus;
using test::kInfinity;
using test::kNan;
using test::ready;

using CMisuse = CInterface;

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
    spherewalk_sensor* madeSensor = nullptr;
    const auto sensor = this->sensor("seed: 1");
    const spherewalk_timed_pose timed{0, pose};
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
        spherewalk_sensor_read(nullptr, c, &madeSensor),
        spherewalk_sensor_read("x", nullptr, &madeSensor),
        spherewalk_sensor_read("x", c, nullptr),
        spherewalk_sensor_parse(nullptr, 0, c, &madeSensor),
        spherewalk_sensor_parse("x", 1, nullptr, &madeSensor),
        spherewalk_sensor_parse("x", 1, c, nullptr),
        spherewalk_stream_take(nullptr, sensor.get(), &timed, 1, 0, 0, nullptr, &into, nullptr),
        spherewalk_stream_take(s, nullptr, &timed, 1, 0, 0, nullptr, &into, nullptr),
        spherewalk_stream_take(s, sensor.get(), &timed, 1, 0, 0, nullptr, nullptr, nullptr),
        spherewalk_stream_take(s, sensor.get(), nullptr, 1, 0, 0, nullptr, &into, nullptr),
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
    spherewalk_sensor_destroy(nullptr);
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
