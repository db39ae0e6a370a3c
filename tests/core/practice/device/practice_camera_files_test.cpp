// SPDX-License-Identifier: GPL-3.0-or-later
#include "server/practice_camera_fixture.h"
#include "temporary_folder.h"

#include "spherewalk/base/json.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/practice/truth.h"

namespace spherewalk::practice {
namespace {

TEST_F(PracticeCameraHttp, ListsPageAndSort) {
    run();
    for (int i = 0; i < 5; ++i) {
        shoot();
    }
    const Json all = list({{"fileType", "all"}, {"entryCount", 100}, {"maxThumbSize", 0}});
    EXPECT_EQ(all["totalEntries"], 5);
    ASSERT_EQ(all["entries"].size(), 5U);
    EXPECT_EQ(all["entries"][0]["name"], "R0010005.JPG");
    const Json page = list({{"fileType", "image"},
                            {"entryCount", 2},
                            {"maxThumbSize", 0},
                            {"startPosition", 1},
                            {"_sort", "oldest"},
                            {"_detail", false}});
    ASSERT_EQ(page["entries"].size(), 2U);
    EXPECT_EQ(page["entries"][0]["name"], "R0010002.JPG");
    EXPECT_TRUE(page["entries"][0].contains("dateTime"));
    EXPECT_FALSE(page["entries"][0].contains("width"));
    EXPECT_EQ(list({{"fileType", "video"}, {"entryCount", 9}, {"maxThumbSize", 0}})["totalEntries"], 0);
    EXPECT_TRUE(
        list({{"fileType", "all"}, {"entryCount", 9}, {"maxThumbSize", 0}, {"startPosition", 5}})["entries"]
            .empty());
    EXPECT_EQ(list({{"fileType", "all"},
                    {"entryCount", 9},
                    {"maxThumbSize", 0},
                    {"_startFileUrl", all["entries"][3]["fileUrl"]}})["entries"]
                  .size(),
              2U);
    expectRefusal(execute("camera.listFiles", {{"fileType", "all"}, {"entryCount", 9}}, 400),
                  "missingParameter");
    expectRefusal(
        execute("camera.listFiles", {{"fileType", "all"}, {"entryCount", -1}, {"maxThumbSize", 0}}, 400),
        "invalidParameterValue");
    expectRefusal(
        execute("camera.listFiles",
                {{"fileType", "all"}, {"entryCount", 1}, {"maxThumbSize", 0}, {"noSuchParameter", 1}}, 400),
        "invalidParameterName");
}

TEST_F(PracticeCameraHttp, DeletesAllOrNothing) {
    run();
    const std::string first = camera().url() + shoot();
    const std::string second = camera().url() + shoot();
    shoot();
    expectRefusal(execute("camera.delete", {{"fileUrls", {first, first + "x"}}}, 400),
                  "invalidParameterValue");
    EXPECT_EQ(list(kNewest)["totalEntries"], 3);
    execute("camera.delete", {{"fileUrls", {first, second}}});
    EXPECT_EQ(list(kNewest)["totalEntries"], 1);
    get(first.substr(camera().url().size()), 404);
    execute("camera.delete", {{"fileUrls", {"all"}}});
    EXPECT_EQ(list(kNewest)["totalEntries"], 0);
    expectRefusal(execute("camera.delete", {{"fileUrls", std::vector<std::string>(129, first)}}, 403),
                  "tooManyParameters");
    EXPECT_THAT(shoot(), testing::HasSubstr("R0010004.JPG")) << "numbers are not given again";
}

TEST_F(PracticeCameraHttp, FilesComeWholeAndAsThumbnails) {
    run();
    const std::string path = shoot();
    const httplib::Headers range = {{"Range", "bytes=10-19"}};
    const auto whole = client().Get(path.c_str(), range);
    ASSERT_TRUE(whole);
    EXPECT_EQ(whole->status, 200) << "the camera knows no ranges";
    EXPECT_EQ(whole->get_header_value("Content-Length"), std::to_string(whole->body.size()));
    EXPECT_EQ(whole->get_header_value("Content-Type"), "image/jpeg");
    const jpeg::Info thumb = jpeg::readInfo(download(path + "?type=thumb"), "thumbnail");
    EXPECT_EQ(thumb.width, 64);
    get("/files/none/100RICOH/R0010001.JPG", 404);
    get("/files/../../etc/passwd", 404);
}

TEST_F(PracticeCameraHttp, FileUrlsFollowTheHostOfTheRequestOrTheRealCamera) {
    run();
    shoot();
    const httplib::Headers host = {{"Host", "theta.example:8080"}};
    const auto answer = client().Post("/osc/state", host, "", "application/json");
    ASSERT_TRUE(answer);
    EXPECT_THAT(Json::parse(answer->body)["state"]["_latestFileUrl"].get<std::string>(),
                testing::StartsWith("http://theta.example:8080/files/"));
    TearDown();
    PracticeCameraOptions options = small();
    options.urlsOfAccessPoint = true;
    run(options);
    shoot();
    EXPECT_THAT(state()["_latestFileUrl"].get<std::string>(),
                testing::StartsWith("http://192.168.1.1/files/"));
}

TEST_F(PracticeCameraHttp, FilesSurviveARestart) {
    const test::TemporaryFolder folder;
    PracticeCameraOptions options = small();
    options.storageFolder = folder / "storage";
    options.truthFile = folder / "truth.jsonl";
    run(options);
    const std::string path = shoot();
    const Bytes bytes = download(path);
    TearDown();
    run(options);
    EXPECT_EQ(download(path), bytes);
    EXPECT_THAT(shoot(), testing::HasSubstr("R0010002.JPG"));
    EXPECT_EQ(readTruth(folder / "truth.jsonl").size(), 2U);
}

} // namespace
} // namespace spherewalk::practice
