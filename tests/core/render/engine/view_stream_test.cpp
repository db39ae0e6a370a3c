// SPDX-License-Identifier: Apache-2.0
#include "expect_error.h"
#include "random.h"
#include "temporary_folder.h"
#include "test_dataset.h"

#include "spherewalk/geometry/rotation.h"
#include "spherewalk/render/view_stream.h"

#include <gtest/gtest.h>

#include <cmath>

namespace spherewalk::render {
namespace {

using Eigen::Vector3d;
using test::expectError;

/// Different in every direction and full of detail: a pixel of another place does not pass for the right one.
Vector3d detailedWorld(const Vector3d& d) {
    return {128 + 100 * std::sin(40 * d.x() + 9 * d.z()), 128 + 100 * std::sin(31 * d.y() - 7 * d.x()),
            128 + 100 * std::sin(53 * d.z() + 3 * d.y())};
}

/// Photos every 20 cm along x, as export writes them; and the same without restart markers.
class Walking : public testing::Test {
  protected:
    static constexpr int kPhotos = 6;

    Walking() {
        std::vector<Rigid3> poses;
        test::Random random(81);
        for (int i = 0; i < kPhotos; ++i) {
            poses.push_back({random.rotation(), Vector3d(0.2 * i, 0, 1)});
        }
        DatasetInfo info = test::writeTestDataset(plain.path(), poses, detailedWorld, 1024, 2.0);
        std::filesystem::copy(plain.path(), marked.path(), std::filesystem::copy_options::recursive);
        for (DatasetPhoto& photo : info.photos) {
            test::mark(marked.path(), photo);
            test::addThumbnail(marked.path(), photo);
        }
        test::rewriteInfo(marked.path(), info);
    }

    static Renderer renderer(const test::TemporaryFolder& folder, const RendererOptions& options = {}) {
        return Renderer(std::make_shared<const Dataset>(Dataset::open(folder.path())), options);
    }

    static Rigid3 at(double x, double yaw = 0) {
        return {yawRotation(Radians(yaw)) * bodyFromOptical(), Vector3d(x, 0.02, 1)};
    }

    test::TemporaryFolder plain;
    test::TemporaryFolder marked;
    CameraModel camera{CameraIntrinsics::pinhole(96, 72, 1.2)};
};

CameraIntrinsics randomRobotCamera(test::Random& random) {
    CameraIntrinsics camera =
        CameraIntrinsics::pinhole(random.integer(1, 120), random.integer(1, 90), random.uniform(0.05, 3.0));
    switch (random.integer(0, 3)) {
    case 0:
        camera.lens = LensModel::Equidistant;
        camera.fx = camera.fy = random.uniform(10, 120);
        camera.distortion = {0.02, -0.01, 0, 0};
        break;
    case 1:
        camera.lens = LensModel::PlumbBob;
        camera.distortion = {-0.2, 0.05, 0.001, -0.002, 0};
        break;
    default:
        break;
    }
    return camera;
}

// Nothing of a photo is in memory before each view of the marked dataset, and memory that was not decoded is
// black: a tile that the view forgot to ask for would show.
TEST_F(Walking, ViewsOfPartsHaveTheBytesOfViewsOfWholePhotos) {
    const Renderer whole = renderer(plain);
    const Renderer parts = renderer(marked, {0});
    test::Random random(82);
    std::uint64_t tiles = 0;
    constexpr int kRounds = 120;
    for (int round = 0; round < kRounds; ++round) {
        const CameraModel lens(randomRobotCamera(random));
        const Rigid3 pose{round % 4 == 0 ? at(0, random.uniform(-4, 4)).rotation : random.rotation(),
                          Vector3d(random.uniform(0, 1), random.uniform(-1, 1), random.uniform(0, 2))};
        ViewOptions options;
        options.sampling = static_cast<Sampling>(round % 6);
        options.exact = round % 7 == 0;
        options.threads = 1 + round % 3;
        const View expected = whole.render(lens, pose, options);
        const View view = parts.render(lens, pose, options);
        ASSERT_EQ(view.picture, expected.picture) << "round " << round << " seed " << random.seed();
        EXPECT_EQ(view.report.sampling, expected.report.sampling);
        EXPECT_FALSE(view.report.isWholeDecode);
        tiles += static_cast<std::uint64_t>(view.report.decodedTiles);
    }
    EXPECT_LT(tiles, kRounds * 64U * 3 / 4); // of 8 x 8 in a photo
    EXPECT_EQ(parts.counters().residentBytes, 0U);
}

TEST_F(Walking, SaysThatAPlainJpegIsDecodedWhole) {
    const Renderer renderer = this->renderer(plain);
    const View first = renderer.render(camera, at(0));
    EXPECT_TRUE(first.report.isWholeDecode);
    EXPECT_TRUE(first.report.isLate);
    EXPECT_TRUE(first.report.isVerified);
    const View second = renderer.render(camera, at(0, 3));
    EXPECT_FALSE(second.report.isWholeDecode);
    EXPECT_FALSE(second.report.isLate);
    EXPECT_EQ(second.report.decodeMs, 0);
    EXPECT_EQ(renderer.counters().wholeDecodes, 1U);
    EXPECT_EQ(renderer.counters().hits, 1U);
}

TEST_F(Walking, AStreamGivesTheBytesOfSingleViews) {
    const Renderer renderer = this->renderer(marked);
    ViewStream stream(renderer, camera);
    View view;
    for (int frame = 0; frame < 40; ++frame) {
        const Rigid3 pose = at(0.2 * (frame / 8) + 0.01 * (frame % 8), 0.05 * frame);
        stream.next(pose, frame / 30.0, {}, view);
        ASSERT_EQ(view.picture, this->renderer(plain).render(camera, pose).picture) << frame;
        EXPECT_EQ(view.report.origin, ViewOrigin::Photo);
    }
    EXPECT_EQ(stream.counters().views, 40U);
}

TEST_F(Walking, WhatWasPredictedIsThere) {
    const Renderer renderer = this->renderer(marked);
    ViewStream stream(renderer, camera);
    for (int frame = 0; frame < 36; ++frame) {
        const View view = stream.next(at(0.03 * frame, 0.02 * frame), frame / 30.0);
        EXPECT_TRUE(frame < 2 || !view.report.isLate) << frame; // two views show the motion
        stream.waitForPrefetch();
    }
    EXPECT_LE(stream.counters().late, 2U);
    EXPECT_GT(renderer.counters().prefetchedTiles, 0U);
    EXPECT_LE(renderer.counters().waits, 2U);
}

TEST_F(Walking, WithoutPrefetchEveryNewPhotoIsLate) {
    ViewStream stream(renderer(marked), camera, {LatePolicy::Wait, 0});
    for (int frame = 0; frame < kPhotos; ++frame) {
        EXPECT_TRUE(stream.next(at(0.2 * frame), frame / 30.0).report.isLate);
        stream.waitForPrefetch();
    }
    EXPECT_EQ(stream.counters().waited, static_cast<std::uint64_t>(kPhotos));
}

TEST_F(Walking, CoarseShowsTheThumbnailAndThenThePhoto) {
    ViewStream stream(renderer(marked), camera, {LatePolicy::Coarse, 0});
    const View coarse = stream.next(at(0.2), 0);
    EXPECT_EQ(coarse.report.origin, ViewOrigin::Thumbnail);
    EXPECT_TRUE(coarse.report.isLate);
    EXPECT_GT(coarse.report.blurPx, 0);
    EXPECT_EQ(coarse.report.decodeMs, 0);
    stream.waitForPrefetch();
    const View sharp = stream.next(at(0.2), 0.03);
    EXPECT_EQ(sharp.report.origin, ViewOrigin::Photo);
    EXPECT_FALSE(sharp.report.isLate);
    EXPECT_GT(sharp.report.trust, coarse.report.trust);
    EXPECT_EQ(stream.counters().coarse, 1U);
    double difference = 0;
    for (std::size_t i = 0; i < sharp.picture.values().size(); ++i) {
        difference += std::abs(sharp.picture.values()[i] - coarse.picture.values()[i]);
    }
    EXPECT_LT(difference / static_cast<double>(sharp.picture.values().size()), 40); // the same, blurred
}

TEST_F(Walking, PreviousShowsThePhotoBeforeFromTheNewPose) {
    const Renderer renderer = this->renderer(marked);
    ViewStream stream(renderer, camera, {LatePolicy::Previous, 0});
    stream.next(at(0.0), 0); // nothing before it: its thumbnail
    stream.waitForPrefetch();
    stream.next(at(0.0), 0.03);
    const View late = stream.next(at(0.13), 0.06);
    EXPECT_EQ(late.report.origin, ViewOrigin::PreviousPhoto);
    EXPECT_EQ(late.report.photo, 0U);
    EXPECT_NEAR(late.report.offsetM, std::hypot(0.13, 0.02), 1e-12);
    stream.waitForPrefetch();
    EXPECT_EQ(stream.next(at(0.13), 0.09).report.photo, 1U);
    EXPECT_EQ(stream.counters().previous, 1U);
    EXPECT_EQ(stream.counters().coarse, 1U);
}

TEST_F(Walking, ADamagedPhotoServedUnverifiedIsRefusedOnceItIsKnown) {
    const auto file = marked / "photos/0.jpg";
    Bytes bytes = readFile(file);
    bytes[bytes.size() - 40] ^= 0x10;
    writeFile(file, bytes);
    ViewStream careful(renderer(marked), camera);
    expectError(ErrorKind::Corrupt, "photos/0.jpg", [&] { careful.next(at(0), 0); });
    ViewStream quick(renderer(marked, {512 << 20, VerifyPhotos::InBackground}), camera);
    const View view = quick.next(at(0), 0);
    EXPECT_FALSE(view.report.isVerified);
    quick.waitForPrefetch();
    expectError(ErrorKind::Corrupt, "photos/0.jpg", [&] { quick.next(at(0), 0.03); });
}

TEST_F(Walking, RefusesWhatCannotBe) {
    const Renderer renderer = this->renderer(marked);
    expectError(ErrorKind::InvalidInput, "0 to 10 s", [&] {
        ViewStream(renderer, camera, {LatePolicy::Wait, std::nan("")});
    });
    expectError(ErrorKind::InvalidInput, "wait, coarse and previous", [&] { latePolicy("never"); });
    ViewStream stream(renderer, camera);
    expectError(ErrorKind::InvalidInput, "pose", [&] { stream.next(at(std::nan("")), 0); });
    EXPECT_NO_THROW(stream.next(at(0), std::nan("")));
}

} // namespace
} // namespace spherewalk::render
