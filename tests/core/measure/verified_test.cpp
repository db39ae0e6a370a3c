// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "made_dataset.h"
#include "opencv_views.h"
#include "subject.h"
#include "temporary_folder.h"
#include "verified.h"

#include "spherewalk/jpeg/region.h"

namespace spherewalk::measure {

using test::expectError;

TEST(Verified, MeanDifferenceCountsEveryValue) {
    RgbImage a(4, 2);
    RgbImage b = a;
    EXPECT_EQ(meanDifference(a, b), 0);
    b.at(3, 1)[2] = 24;
    EXPECT_EQ(meanDifference(a, b), 1);
    EXPECT_EQ(meanDifference(b, a), 1);
    EXPECT_GT(meanDifference(a, RgbImage(2, 4)), 1e9);
}

TEST(Verified, RefusesAPartWithOneWrongByte) {
    const RgbImage whole = test::madePanorama(64, 1);
    const jpeg::PixelRect region{8, 4, 20, 10};
    RgbImage part(region.width, region.height);
    for (int y = 0; y < region.height; ++y) {
        std::copy_n(whole.at(region.x, region.y + y), 3 * region.width, part.at(0, y));
    }
    requirePart(part, region, whole, "the part");
    expectError(ErrorKind::Internal, "the part is not what it should be", [&] {
        requirePart(part, {9, 4, 20, 10}, whole, "the part");
    });
    part.at(19, 9)[2] ^= 1;
    expectError(ErrorKind::Internal, "the part is not what it should be",
                [&] { requirePart(part, region, whole, "the part"); });
    expectError(ErrorKind::Internal, "the whole", [&] { requireSame(part, whole, "the whole"); });
}

TEST(Verified, RefusesPlanesWithOneWrongSample) {
    const Bytes bytes = jpeg::withRestartMarkers(jpeg::encode(test::madePanorama(256, 1), 90), 4, "made");
    const jpeg::RegionDecoder decoder(std::make_shared<MemorySource>(bytes, "made"),
                                      jpeg::indexRestarts(bytes, "made"));
    const jpeg::PixelRect region{32, 16, 64, 48};
    const jpeg::Planes whole = decoder.decodePlanes({0, 0, 256, 128});
    jpeg::Planes part = decoder.decodePlanes(region);
    requirePart(part, region, whole, "the part");
    part.red.at(31, 23)[0] ^= 1;
    expectError(ErrorKind::Internal, "its samples", [&] { requirePart(part, region, whole, "the part"); });
}

// What the benchmark rests on: the check tells a right view from one that is turned by a third of a degree.
TEST(Verified, TellsAViewFromOneThatIsALittleTurned) {
    const test::TemporaryFolder folder;
    const Subject subject(test::openMadeDataset(folder.path()));
    const CameraModel camera = standardCamera(90);
    OpenCvViews openCv(subject.picture(), camera, subject.radiusM());
    const Rigid3 pose = lookingTo(40, 10, {0.1, 0.05, 0});
    render::ViewOptions bilinear;
    bilinear.sampling = render::Sampling::Bilinear;
    render::ViewOptions exact;
    exact.exact = true;
    const auto view = [&](const Rigid3& from, const render::ViewOptions& options) {
        return subject.renderer().render(camera, subject.roomFromCamera(from), options).picture;
    };
    requireAlike(view(pose, bilinear), view(pose, exact), 0.5, "the view");
    requireAlike(view(pose, bilinear), openCv.mapsAndRemap(pose), 1.5, "the view");
    openCv.keepMaps(pose);
    requireAlike(openCv.remap(0), view(pose, exact), 1.5, "the view");
    const Rigid3 turned = lookingTo(40.3, 10, {0.1, 0.05, 0});
    expectError(ErrorKind::Internal, "the view is not what it should be",
                [&] { requireAlike(view(pose, bilinear), view(turned, exact), 0.5, "the view"); });
    expectError(ErrorKind::Internal, "the view is not what it should be",
                [&] { requireAlike(view(pose, bilinear), openCv.mapsAndRemap(turned), 1.5, "the view"); });
}

} // namespace spherewalk::measure
