// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "photographed_survey.h"
#include "ply_reader.h"
#include "test_dataset.h"
#include "warnings.h"

#include "spherewalk/jobs/export_foreign.h"
#include "spherewalk/jobs/export_place.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace spherewalk::jobs {
namespace {

using test::expectError;
namespace fs = std::filesystem;

class ExportPlace : public testing::Test {
  protected:
    ExportPlace() : info(test::writeEmptyRoom(dataset())) { options.fusion.voxelM = 0.04; }

    fs::path dataset() const { return folder / "room.dataset"; }

    PlaceReport write(const std::stop_token& stop = {}) {
        return exportPlace(dataset(), folder / "out", options, noProgress(), stop);
    }

    test::TemporaryFolder folder;
    render::DatasetInfo info;
    PlaceOptions options;
};

} // namespace

TEST_F(ExportPlace, WritesTheSurfaceWithTheColoursOfItsPhotos) {
    const PlaceReport report = write();
    const test::Ply ply = test::readPly(folder / "out/surface.ply");
    EXPECT_EQ(report.photos, 4U);
    EXPECT_EQ(report.vertices, ply.vertices.size());
    EXPECT_EQ(report.triangles, ply.triangles.size());
    EXPECT_NEAR(report.areaM2, 2 * (3 * 2 + 3 * 2.5 + 2 * 2.5), 3);
    EXPECT_GT(report.seenShare, 0.97);
    EXPECT_GT(report.seenTwiceShare, 0.95);
    int alike = 0;
    for (const test::PlyVertex& vertex : ply.vertices) {
        alike += std::any_of(info.photos.begin(), info.photos.end(), [&](const render::DatasetPhoto& photo) {
            const Eigen::Vector3d ray = (vertex.pInRoom - photo.roomFromPhoto.translation).normalized();
            const Eigen::Vector3d colour(vertex.colour[0], vertex.colour[1], vertex.colour[2]);
            return (test::smoothWorld(ray) - colour).cwiseAbs().maxCoeff() < 30;
        });
    }
    EXPECT_GT(alike, 0.98 * static_cast<double>(ply.vertices.size())) << "some photo shows the colour";
    const Json json = parseJson(readTextFile(folder / "out/report.json"), "report.json");
    EXPECT_EQ(json, toJson(report));
}

TEST_F(ExportPlace, WritesTheSameSurfaceForViewersAndAsText) {
    options.formats = {PlaceFormat::Gltf};
    const PlaceReport whole = write();
    EXPECT_THAT(readTextFile(folder / "out/surface.glb"), testing::StartsWith("glTF"));
    fs::remove_all(folder / "out");
    options.formats = {PlaceFormat::Obj};
    options.simplifyM = 0.01;
    const PlaceReport simple = write();
    EXPECT_LT(simple.triangles, whole.triangles / 20) << "walls are planes";
    EXPECT_NEAR(simple.areaM2, 2 * (3 * 2 + 3 * 2.5 + 2 * 2.5), 1.5);
    const std::string obj = readTextFile(folder / "out/surface.obj");
    std::size_t faces = 0;
    for (std::size_t at = obj.find("\nf "); at != std::string::npos; at = obj.find("\nf ", at + 1)) {
        ++faces;
    }
    EXPECT_EQ(faces, simple.triangles);
}

TEST_F(ExportPlace, KnowsWhatStandsInTheRoom) {
    render::RoomShape room = info.roomShape.value();
    EXPECT_TRUE(furnitureOf(dataset(), room, options, noProgress(), {}).boxes.empty()) << "nothing does";
    // The room is taken for larger than it is, so that its eastern wall stands in it.
    room.outline = {{0, 0}, {4, 0}, {4, 2}, {0, 2}};
    const Furniture things = furnitureOf(dataset(), room, options, noProgress(), {});
    const double cellM = 2 * options.fusion.voxelM;
    EXPECT_NEAR(things.mesh.areaM2(), 3 * 2 * 2.5, 0.6) << "the surface, and boxes of one voxel that hold it";
    for (const place::SurfaceVertex& vertex : things.mesh.vertices) {
        EXPECT_NEAR(vertex.pInRoom.x(), 3, 0.06);
    }
    double volumeM3 = 0;
    for (const Eigen::AlignedBox3d& box : things.boxes) {
        volumeM3 += box.volume();
        EXPECT_GT(box.min().x(), 3 - 1.5 * cellM);
        EXPECT_LT(box.max().x(), 3 + 2.5 * cellM);
    }
    EXPECT_GT(volumeM3 / cellM, 0.8 * 2 * 2.5) << "the wall is one or two cells thick";
    EXPECT_LT(volumeM3 / cellM, 2.2 * 2 * 2.5);
}

TEST_F(ExportPlace, WritesAMapOfTheFloor) {
    options.formats = {PlaceFormat::Occupancy};
    options.fusion.voxelM = 0.025;
    const PlaceReport report = write();
    EXPECT_NEAR(report.freeM2, 6, 0.6);
    EXPECT_NEAR(report.occupiedM2, 10 * 0.1, 0.4);
    EXPECT_THAT(readTextFile(folder / "out/map.yaml"), testing::HasSubstr("image: map.pgm"));
    EXPECT_THAT(readTextFile(folder / "out/map.pgm"), testing::StartsWith("P5\n"));
}

TEST_F(ExportPlace, WritesSeveralFormatsAtOnce) {
    options.formats = {PlaceFormat::Gltf, PlaceFormat::Occupancy};
    options.fusion.voxelM = 0.025;
    options.simplifyM = 0.01;
    const double freeM2 = write().freeM2;
    EXPECT_TRUE(fs::exists(folder / "out/surface.glb"));
    EXPECT_TRUE(fs::exists(folder / "out/map.pgm"));
    EXPECT_FALSE(fs::exists(folder / "out/surface.ply"));
    fs::remove_all(folder / "out");
    options.formats = {PlaceFormat::Occupancy};
    EXPECT_EQ(write().freeM2, freeM2) << "the map is of the whole surface";
}

TEST_F(ExportPlace, TellsThatLengthsAreHardlyKnown) {
    info.scaleSigma = 0.25;
    test::rewriteInfo(dataset(), info);
    test::Warnings warnings;
    exportPlace(dataset(), folder / "out", options, warnings, {});
    EXPECT_THAT(warnings.sentences, testing::ElementsAre(testing::HasSubstr("known to 25 % alone")));
    warnings.sentences.clear();
    worldRoomOf(dataset(), kObstacleHeightM, warnings);
    EXPECT_THAT(warnings.sentences, testing::ElementsAre(testing::HasSubstr("known to 25 % alone")));
}

TEST_F(ExportPlace, LeavesOutWhatTooFewPhotosShow) {
    options.leastPhotos = 5;
    expectError(ErrorKind::InvalidInput, "no surface", [&] { write(); });
    EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST_F(ExportPlace, KeepsTrianglesHoweverManyMayBeJoined) {
    options.formats = {PlaceFormat::Gltf};
    options.simplifyM = 100;
    EXPECT_GT(write().triangles, 0U);
}

TEST_F(ExportPlace, RefusesWhatItCannotDoBeforeItReads) {
    const auto refuses = [&](const std::string& words, const std::function<void(PlaceOptions&)>& change) {
        PlaceOptions wrong = options;
        change(wrong);
        expectError(ErrorKind::InvalidInput, words,
                    [&] { exportPlace(folder / "none", folder / "out", wrong, noProgress(), {}); });
    };
    refuses("voxel", [](PlaceOptions& wrong) { wrong.fusion.voxelM = 0; });
    refuses("no format", [](PlaceOptions& wrong) { wrong.formats.clear(); });
    refuses("one is the least", [](PlaceOptions& wrong) { wrong.leastPhotos = 0; });
    refuses("0 or more", [](PlaceOptions& wrong) { wrong.simplifyM = NAN; });
    refuses("heights", [](PlaceOptions& wrong) { wrong.occupancy.mostHeightM = 0; });
    refuses("two voxels", [](PlaceOptions& wrong) {
        wrong.formats = {PlaceFormat::Occupancy};
        wrong.occupancy.cellM = 0.05;
    });
}

TEST_F(ExportPlace, NeedsDepthsOfTwoPhotos) {
    EXPECT_TRUE(hasDepths(dataset()));
    EXPECT_FALSE(hasDepths(folder.path()));
    for (std::size_t i = 1; i < info.photos.size(); ++i) {
        info.photos[i].depth.clear();
    }
    test::rewriteInfo(dataset(), info);
    expectError(ErrorKind::InvalidInput, "1 photo has a depth", [&] { write(); });
    EXPECT_FALSE(hasDepths(dataset()));
    info.photos[0].depth.clear();
    test::rewriteInfo(dataset(), info);
    expectError(ErrorKind::InvalidInput, "--scene depth", [&] { write(); });
    EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST_F(ExportPlace, ReplacesNothingAndLeavesNothingWhenItIsStopped) {
    std::stop_source stop;
    stop.request_stop();
    expectError(ErrorKind::Stopped, "", [&] { write(stop.get_token()); });
    EXPECT_FALSE(fs::exists(folder / "out"));
    writeFile(folder / "out", bytesOf("mine"));
    expectError(ErrorKind::Exists, "out", [&] { write(); });
}

TEST_F(ExportPlace, NamesItsFormats) {
    for (const PlaceFormat format :
         {PlaceFormat::Ply, PlaceFormat::Gltf, PlaceFormat::Obj, PlaceFormat::Occupancy}) {
        EXPECT_EQ(placeFormat(name(format)), format);
    }
    EXPECT_EQ(placeFormat("stl"), std::nullopt);
}

TEST(ExportPlaceOfASurvey, EstimatesItsDepthsAndSaysWhenTheyAgreeOnNothing) {
    const test::PhotographedSurvey survey(1);
    expectError(ErrorKind::InvalidInput, "0 photos have a depth",
                [&] { exportPlace(survey.path(), survey / "out", {}, noProgress(), {}); });
    EXPECT_FALSE(fs::exists(survey / "out"));
    EXPECT_THROW(exportPlace(survey / "none", survey / "out", {}, noProgress(), {}), Error);
}

} // namespace spherewalk::jobs
