// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "made_survey.h"
#include "photographed_survey.h"
#include "warnings.h"

#include "spherewalk/base/json.h"
#include "spherewalk/dataset/world_file.h"
#include "spherewalk/jobs/export_dataset.h"
#include "spherewalk/jobs/export_foreign.h"
#include "spherewalk/jobs/import_photos.h"
#include "spherewalk/photo/picture_file.h"
#include "spherewalk/render/camera_info.h"
#include "spherewalk/render/dataset.h"

#include <map>
#include <set>

namespace spherewalk::jobs {

using test::expectError;
using testing::HasSubstr;

namespace {

std::set<std::string> picturesIn(const std::filesystem::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder / "images")) {
        names.insert(entry.path().filename());
    }
    return names;
}

class ExportForeign : public testing::Test {
  protected:
    ForeignReport write(const ForeignOptions& options, const std::string& name = "out",
                        const std::stop_token& stop = {}) {
        return exportForeign(m_survey.open(), m_survey / name, options, noProgress(), stop);
    }

    test::PhotographedSurvey m_survey{2};
};

} // namespace

TEST_F(ExportForeign, KeepsWholePhotosForFormatsThatKnowSpheres) {
    for (const auto format : {dataset::PoseFormat::Nerfstudio, dataset::PoseFormat::Tum}) {
        const std::string out(name(format));
        SCOPED_TRACE(out);
        const ForeignReport report = write({format, false}, out);
        EXPECT_EQ(report.photos, 2U);
        EXPECT_EQ(report.pictures, 2U);
        ASSERT_EQ(picturesIn(m_survey / out).size(), 2U);
        for (const std::string& picture : picturesIn(m_survey / out)) {
            EXPECT_EQ(photo::readPicture(m_survey / out / "images" / picture).width(), 512);
        }
    }
    EXPECT_TRUE(std::filesystem::exists(m_survey / "nerfstudio/transforms.json"));
    EXPECT_TRUE(std::filesystem::exists(m_survey / "tum/groundtruth.txt"));
}

TEST_F(ExportForeign, CutsEachPhotoIntoTheSixFacesOfACube) {
    const ForeignReport report = write({dataset::PoseFormat::Nerfstudio, true});
    EXPECT_EQ(report.photos, 2U);
    EXPECT_EQ(report.pictures, 12U);
    std::set<std::string> kinds;
    for (const std::string& picture : picturesIn(m_survey / "out")) {
        const RgbImage face = photo::readPicture(m_survey / "out/images" / picture);
        EXPECT_EQ(face.width(), 128) << "a quarter of the photo";
        EXPECT_EQ(face.height(), 128);
        kinds.insert(picture.substr(picture.rfind('_') + 1));
    }
    EXPECT_EQ(kinds, (std::set<std::string>{"front.jpg", "left.jpg", "back.jpg", "right.jpg", "up.jpg",
                                            "down.jpg"}));
}

TEST_F(ExportForeign, LooksWhereItsFacesAreCalledAfter) {
    write({dataset::PoseFormat::Nerfstudio, true});
    std::map<std::string, std::array<int, 3>> middle;
    for (const std::string& picture : picturesIn(m_survey / "out")) {
        const RgbImage face = photo::readPicture(m_survey / "out/images" / picture);
        std::array<int, 3> sum{};
        for (int y = 32; y < 96; ++y) {
            for (int x = 32; x < 96; ++x) {
                for (std::size_t c = 0; c < 3; ++c) {
                    sum[c] += face.at(x, y)[c];
                }
            }
        }
        const std::size_t begin = picture.rfind('_') + 1;
        middle[picture.substr(begin, picture.size() - begin - 4)] = sum;
    }
    // Red grows along the room's x, green along y, blue upwards.
    EXPECT_GT(middle.at("front")[0], middle.at("back")[0]);
    EXPECT_GT(middle.at("left")[1], middle.at("right")[1]);
    EXPECT_GT(middle.at("up")[2], middle.at("down")[2]);
}

TEST_F(ExportForeign, GivesColmapFacesInAnyCase) {
    const ForeignReport report = write({dataset::PoseFormat::Colmap, false});
    EXPECT_EQ(report.pictures, 12U);
    const std::string images = readTextFile(m_survey / "out/sparse/0/images.txt");
    for (const std::string& picture : picturesIn(m_survey / "out")) {
        EXPECT_THAT(images, HasSubstr(picture));
    }
}

TEST_F(ExportForeign, NamesEveryPictureThatItWrites) {
    write({dataset::PoseFormat::Nerfstudio, true});
    const Json json = parseJson(readTextFile(m_survey / "out/transforms.json"), "transforms.json");
    std::set<std::string> named;
    for (const Json& frame : json.at("frames")) {
        named.insert(std::filesystem::path(frame.at("file_path").get<std::string>()).filename());
    }
    EXPECT_EQ(named, picturesIn(m_survey / "out"));
}

TEST_F(ExportForeign, LeavesRejectedPhotosOut) {
    {
        auto store = m_survey.open(store::Access::Write);
        store.setReview({store.photos().at(0).id, store::Decision::Rejected, ""});
    }
    EXPECT_EQ(write({}).photos, 1U);
    EXPECT_EQ(picturesIn(m_survey / "out").size(), 1U);
}

TEST_F(ExportForeign, ReplacesNothing) {
    write({});
    const std::string before = readTextFile(m_survey / "out/transforms.json");
    expectError(ErrorKind::Exists, "out", [&] { write({}); });
    EXPECT_EQ(readTextFile(m_survey / "out/transforms.json"), before);
}

TEST_F(ExportForeign, LeavesNothingWhenItIsStopped) {
    std::stop_source stop;
    stop.request_stop();
    expectError(ErrorKind::Stopped, "Stopped", [&] { write({}, "out", stop.get_token()); });
    EXPECT_FALSE(std::filesystem::exists(m_survey / "out"));
}

TEST(ExportForeignOfAnEmptySurvey, LeavesNothing) {
    const test::TemporaryFolder folder;
    const auto store =
        store::SurveyStore::open(test::makeSurvey(folder / "s.spherewalk"), store::Access::Read);
    EXPECT_THROW(exportForeign(store, folder / "out", {}, noProgress(), {}), Error);
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

TEST(WorldRoom, OfASurveyHasItsRoomAndBeginsAtThePhotoInTheMiddle) {
    const test::PhotographedSurvey survey{4};
    const dataset::WorldRoom room = worldRoomOf(survey.path());
    const auto store = survey.open();
    EXPECT_EQ(room.name, store.info().name);
    EXPECT_EQ(room.outline, store.room().outline);
    EXPECT_EQ(room.floorM, 0);
    EXPECT_EQ(room.ceilingM, 2.5);
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const store::PhotoRecord& photo : store.photos()) {
        middle += photo.positionM / 4;
    }
    double own = HUGE_VAL;
    double least = HUGE_VAL;
    for (const store::PhotoRecord& photo : store.photos()) {
        const double distance = (photo.positionM - middle).norm();
        least = std::min(least, distance);
        own = photo.positionM == room.cameraAt ? distance : own;
    }
    EXPECT_DOUBLE_EQ(own, least);
}

TEST(WorldRoom, OfASurveyWithoutPhotosBeginsAtAStation) {
    const test::TemporaryFolder folder;
    const std::filesystem::path survey = test::makeSurvey(folder / "s.spherewalk");
    const dataset::WorldRoom room = worldRoomOf(survey);
    const auto store = store::SurveyStore::open(survey, store::Access::Read);
    const auto stations = store.stations();
    EXPECT_TRUE(std::any_of(stations.begin(), stations.end(), [&](const store::StationRecord& station) {
        return station.station.positionM == room.cameraAt;
    }));
}

TEST(WorldRoom, DoesNotBeginAtAPhotoThatNobodyKnowsThePlaceOf) {
    const test::PhotographedSurvey survey{2};
    const Eigen::Vector3d before = worldRoomOf(survey.path()).cameraAt;
    std::filesystem::create_directories(survey / "more");
    for (int i = 0; i < 4; ++i) {
        RgbImage picture(512, 256);
        std::ranges::fill(picture.values(), static_cast<std::uint8_t>(60 + 30 * i));
        writeFile(survey / "more" / text("M", i, ".JPG"), jpeg::encode(picture, 90));
    }
    auto store = survey.open(store::Access::Write);
    EXPECT_EQ(importPhotos(store, {survey / "more", {}}, noProgress(), {}).unknownPlaces, 4);
    test::Warnings warnings;
    EXPECT_EQ(worldRoomOf(survey.path(), kObstacleHeightM, warnings).cameraAt, before);
    EXPECT_TRUE(warnings.sentences.empty()) << "the room was drawn";
}

TEST(WorldRoom, SaysThatNobodyHasDrawnItsWalls) {
    const test::TemporaryFolder folder;
    {
        auto store = store::SurveyStore::create(folder / "h.spherewalk", "h", survey::unknownRoom(), {}, {});
        survey::Room room;
        room.outline = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
        room.ceilingM = 2.5;
        store.replaceRoom(room, store::RoomOrigin::Solved);
        store.addStation({1, 1, 1.2});
    }
    test::Warnings warnings;
    EXPECT_EQ(worldRoomOf(folder / "h.spherewalk", kObstacleHeightM, warnings).outline.size(), 4U);
    EXPECT_THAT(warnings.sentences, testing::ElementsAre(HasSubstr("Nobody has drawn the room")));
}

TEST(WorldRoom, OfADatasetIsThatOfTheSurveyThatItWasMadeOf) {
    const test::PhotographedSurvey survey{4};
    exportDataset(survey.open(), survey / "d", {}, noProgress(), {});
    const dataset::WorldRoom ofSurvey = worldRoomOf(survey.path());
    const dataset::WorldRoom ofDataset = worldRoomOf(survey / "d");
    EXPECT_EQ(ofDataset.name, ofSurvey.name);
    EXPECT_LT((ofDataset.cameraAt - ofSurvey.cameraAt).norm(), 1e-9);
    if (!render::Dataset::open(survey / "d").info().roomShape) {
        EXPECT_EQ(ofDataset.outline, ofSurvey.outline);
        EXPECT_EQ(ofDataset.ceilingM, ofSurvey.ceilingM);
    }
}

TEST(WorldRoom, HasTheObstaclesOfThePlanAndBeginsBesideThem) {
    const test::TemporaryFolder folder;
    const std::filesystem::path survey = test::makeSurvey(folder / "s.spherewalk");
    const dataset::WorldRoom room = worldRoomOf(survey, 0.6);
    ASSERT_EQ(room.obstacles.size(), 1U);
    EXPECT_EQ(room.obstacles[0].heightM, 0.6);
    EXPECT_EQ(room.obstacles[0].outline,
              store::SurveyStore::open(survey, store::Access::Read).room().obstacles[0]);
    EXPECT_GE(distanceToEdge(room.obstacles[0].outline, room.cameraAt.head<2>()), 0.2);
    EXPECT_EQ(worldRoomOf(survey, 5).obstacles[0].heightM, 2.5); // no higher than the ceiling
}

TEST(WorldRoom, NeedsASurveyOrADataset) {
    const test::TemporaryFolder folder;
    EXPECT_THROW(worldRoomOf(folder.path()), Error);
    EXPECT_THROW(worldRoomOf(folder / "none"), Error);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path())) << "looking makes nothing";
}

namespace {

dataset::WorldRoom smallRoom() {
    return {"room", {{0, 0}, {4, 0}, {4, 3}, {0, 3}}, 0, 2.5, {1, 1, 1}, {}};
}

} // namespace

TEST(ExportWorld, WritesTheWorldAndTheCameraThatItIsFor) {
    const test::TemporaryFolder folder;
    const CameraIntrinsics camera = CameraIntrinsics::pinhole(320, 240, 1.1);
    const std::map<WorldFormat, std::string> worlds = {
        {WorldFormat::Sdf, dataset::sdfWorld(smallRoom(), camera)},
        {WorldFormat::Mjcf, dataset::mjcfWorld(smallRoom(), camera)},
        {WorldFormat::Urdf, dataset::urdfRoom(smallRoom())}};
    for (const auto& [format, world] : worlds) {
        const std::filesystem::path out = folder / std::string(name(format));
        EXPECT_EQ(readTextFile(out / exportWorld(smallRoom(), camera, format, out)), world);
        EXPECT_EQ(render::readCameraInfo(out / "camera.yaml"), camera);
        EXPECT_EQ(worldFormat(name(format)), format);
    }
    EXPECT_EQ(worldFormat("ply"), std::nullopt);
}

TEST(ExportWorld, WritesItsFurnitureBesideIt) {
    const test::TemporaryFolder folder;
    dataset::WorldRoom room = smallRoom();
    room.furnitureMesh = "v 0 0 0\n";
    exportWorld(room, CameraIntrinsics::pinhole(320, 240, 1.1), WorldFormat::Sdf, folder / "world");
    EXPECT_EQ(readTextFile(folder / "world/furniture.obj"), room.furnitureMesh);
    EXPECT_THAT(readTextFile(folder / "world/world.sdf"), HasSubstr("<uri>furniture.obj</uri>"));
    exportWorld(room, CameraIntrinsics::pinhole(320, 240, 1.1), WorldFormat::Mjcf, folder / "boxes");
    EXPECT_FALSE(std::filesystem::exists(folder / "boxes/furniture.obj"));
}

TEST(ExportWorld, ReplacesNothing) {
    const test::TemporaryFolder folder;
    writeFile(folder / "world", bytesOf("mine"));
    expectError(ErrorKind::Exists, "world", [&] {
        exportWorld(smallRoom(), CameraIntrinsics::pinhole(320, 240, 1.1), WorldFormat::Sdf,
                    folder / "world");
    });
    EXPECT_EQ(readTextFile(folder / "world"), "mine");
}

TEST(ExportWorld, LeavesNothingOfARoomThatIsNone) {
    const test::TemporaryFolder folder;
    dataset::WorldRoom low = smallRoom();
    low.ceilingM = -1;
    expectError(ErrorKind::InvalidInput, "", [&] {
        exportWorld(low, CameraIntrinsics::pinhole(320, 240, 1.1), WorldFormat::Sdf, folder / "world");
    });
    CameraIntrinsics bent = CameraIntrinsics::pinhole(320, 240, 1.1);
    bent.lens = LensModel::PlumbBob;
    bent.distortion = {0.1, 0, 0, 0, 0};
    expectError(ErrorKind::Unsupported, "",
                [&] { exportWorld(smallRoom(), bent, WorldFormat::Sdf, folder / "world"); });
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

} // namespace spherewalk::jobs
