// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli_run.h"
#include "http/scripted_server.h"
#include "temporary_folder.h"

#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/jpeg/jpeg.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace spherewalk {

namespace fs = std::filesystem;
using test::CliResult;
using test::runCli;
using testing::HasSubstr;
using testing::Not;

namespace {

const std::string kCamera =
    "image_width: 32\nimage_height: 24\ncamera_matrix: {data: [30, 0, 16, 0, 30, 12, 0, 0, 1]}\n";

/// Fails, with exit status 1, one sentence on standard error that contains the part, and the same as JSON.
void expectRefused(std::vector<std::string> arguments, const std::string& part,
                   const test::Program::Options& options = {}) {
    const CliResult result = runCli(arguments, options);
    EXPECT_EQ(result.status, 1) << result.errors;
    EXPECT_THAT(result.errors, HasSubstr(part));
    EXPECT_EQ(result.output, "");
    arguments.emplace_back("--json");
    const CliResult json = runCli(arguments, options);
    EXPECT_EQ(json.status, 1);
    EXPECT_THAT(json.json()["error"]["sentence"].get<std::string>(), HasSubstr(part));
}

/// A survey of three photos and its dataset, made through the program itself.
class BadInput : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        s_folder = std::make_unique<test::TemporaryFolder>();
        s_folder->leaveUnchecked(); // it holds damaged copies
        fs::create_directories(*s_folder / "in");
        std::string csv = "file,x_m,y_m,z_m,yaw_deg\n";
        for (int i = 0; i < 3; ++i) {
            RgbImage picture(1024, 512);
            std::fill(picture.values().begin(), picture.values().end(),
                      static_cast<std::uint8_t>(40 * i + 20));
            writeFile(*s_folder / "in" / (std::to_string(i) + ".JPG"), jpeg::encode(picture, 90));
            csv += std::to_string(i) + ".JPG," + std::to_string(i + 1) + ",1,1.2,0\n";
        }
        writeFile(*s_folder / "p.csv", bytesOf(csv));
        writeFile(*s_folder / "camera.yaml", bytesOf(kCamera));
        const std::string survey = path("s.spherewalk");
        ASSERT_EQ(
            runCli({"new", survey, "--rect", "0,0,4,3", "--ceiling", "2.5", "--step", "1", "--height", "1.2"})
                .status,
            0);
        ASSERT_EQ(runCli({"import", survey, "--photos", path("in"), "--positions", path("p.csv")}).status, 0);
        ASSERT_EQ(runCli({"export", survey, path("d"), "--scene", "sphere"}).status, 0);
    }

    static void TearDownTestSuite() { s_folder.reset(); }

    static std::string path(const std::string& name) { return (*s_folder / name).string(); }

    /// A copy of the sound dataset, to be damaged.
    static fs::path damaged() {
        fs::remove_all(path("damaged"));
        fs::copy(path("d"), path("damaged"), fs::copy_options::recursive);
        return path("damaged");
    }

    static void changeDescription(const fs::path& dataset, const std::function<void(Json&)>& change) {
        Json json = parseJson(readTextFile(dataset / "dataset.json"), "x");
        change(json);
        writeFile(dataset / "dataset.json", bytesOf(json.dump()));
    }

    static std::vector<std::string> view(const std::string& dataset) {
        return {"view",   dataset,           "--camera", path("camera.yaml"),
                "--pose", "1 1 1.2 0 0 0 1", "--out",    path("v.png")};
    }

    static std::unique_ptr<test::TemporaryFolder> s_folder;
};

std::unique_ptr<test::TemporaryFolder> BadInput::s_folder;

} // namespace

TEST_F(BadInput, TheSoundDatasetGivesAView) {
    const CliResult result = runCli(view(path("d")));
    EXPECT_EQ(result.status, 0) << result.errors;
    EXPECT_TRUE(fs::exists(path("v.png")));
}

TEST_F(BadInput, DatasetsThatAreDamagedOrHostile) {
    fs::path dataset = damaged();
    fs::remove(dataset / "photos/1.jpg");
    expectRefused(view(dataset), "photos/1.jpg is missing");

    dataset = damaged();
    fs::resize_file(dataset / "photos/1.jpg", fs::file_size(dataset / "photos/1.jpg") - 100);
    expectRefused(view(dataset), "photos/1.jpg has");

    dataset = damaged();
    changeDescription(dataset, [](Json& json) { json["photos"][2]["sha256"] = std::string(64, '0'); });
    expectRefused(view(dataset), "photos/2.jpg was changed");

    dataset = damaged();
    changeDescription(dataset, [](Json& json) { json["version"] = 99; });
    expectRefused(view(dataset), "version 99");

    dataset = damaged();
    changeDescription(dataset, [](Json& json) { json["photos"][0]["file"] = "photos/../../in/0.JPG"; });
    expectRefused(view(dataset), "\"photos/../../in/0.JPG\" is not the name");

    dataset = damaged();
    writeFile(dataset / "dataset.json", bytesOf(std::string(1'000'000, '[')));
    expectRefused(view(dataset), "nests deeper");
    expectRefused({"check", dataset}, "nests deeper");
    expectRefused(view(path("in")), "holds no dataset.json");
}

// A truncated JPEG whose size and hash are right all the same: only decoding can tell.
TEST_F(BadInput, ATruncatedJpegWithAnHonestHash) {
    fs::remove_all(path("in2"));
    fs::copy(path("in"), path("in2"), fs::copy_options::recursive);
    const Bytes whole = readFile(path("in2") + "/1.JPG");
    writeFile(path("in2") + "/1.JPG", ByteView(whole).first(whole.size() / 2));
    fs::remove_all(path("t.spherewalk"));
    ASSERT_EQ(runCli({"new", path("t.spherewalk"), "--rect", "0,0,4,3", "--ceiling", "2.5"}).status, 0);
    const CliResult imported = runCli(
        {"import", path("t.spherewalk"), "--photos", path("in2"), "--positions", path("p.csv"), "--json"});
    EXPECT_EQ(imported.status, 1);
    EXPECT_THAT(imported.errors, HasSubstr("1.JPG"));
    EXPECT_EQ(imported.json()["imported"], 2);
    ASSERT_EQ(imported.json()["refused"].size(), 1U);
    EXPECT_EQ(imported.json()["refused"][0]["line"], 3);
}

TEST_F(BadInput, RoomsAndPlansThatCannotBe) {
    writeFile(path("crossing.json"), bytesOf("[[0,0],[4,4],[4,0],[0,4]]"));
    const std::string survey = path("none.spherewalk");
    expectRefused({"new", survey, "--outline", path("crossing.json"), "--ceiling", "2.5"}, "crosses");
    expectRefused({"new", survey, "--rect", "0,0,4,3", "--ceiling", "2.5", "--step", "0"}, "step");
    expectRefused({"new", survey, "--rect", "0,0,4,3"}, "height is missing: give --ceiling");
    expectRefused({"new", survey, "--rect", "4,0,0,3", "--ceiling", "2.5"}, "x0 < x1");
    expectRefused({"new", survey, "--rect", "0,0,4,3", "--ceiling", "2.5", "--step", "0.0001"}, "step");
    expectRefused({"new", path("s.spherewalk"), "--rect", "0,0,4,3", "--ceiling", "2.5"}, "s.spherewalk");
    writeFile(path("deep.json"), bytesOf(std::string(1'000'000, '[')));
    expectRefused({"new", survey, "--outline", path("deep.json"), "--ceiling", "2.5"}, "nests deeper");
    EXPECT_FALSE(fs::exists(survey));
}

TEST_F(BadInput, PositionsFilesPathsPosesAndCameras) {
    const std::string survey = path("s.spherewalk");
    writeFile(path("q.csv"), bytesOf("file,x_m,z_m\n0.JPG,1,1\n"));
    expectRefused({"import", survey, "--photos", path("in"), "--positions", path("q.csv")},
                  "column y_m is missing");
    expectRefused({"import", survey, "--photos", path("in"), "--positions", path("absent.csv")},
                  "absent.csv");
    writeFile(path("bad.yaml"), bytesOf("image_width: 32\n"));
    expectRefused(
        {"view", path("d"), "--camera", path("bad.yaml"), "--pose", "1 1 1 0 0 0 1", "--out", path("v.png")},
        "camera_matrix");
    expectRefused(
        {"view", path("d"), "--camera", path("camera.yaml"), "--pose", "1 1 1", "--out", path("v.png")},
        "x y z qx qy qz qw");
    writeFile(path("bad.tum"), bytesOf("0 1 2 3\n"));
    expectRefused(
        {"walk", path("d"), "--camera", path("camera.yaml"), "--path", path("bad.tum"), "--out", path("w")},
        "line 1 of");
    expectRefused({"status", path("in")}, "in");
    expectRefused({"export", survey, path("d")}, "exists already");
}

TEST_F(BadInput, ACameraThatIsNoCamera) {
    const test::ScriptedServer page(
        [](const test::ServerRequest& /*request*/) { return test::answerPage(); });
    const std::string address = "127.0.0.1:" + std::to_string(page.port());
    expectRefused({"camera", "info", "--camera", address, "--time-scale", "0.01"}, "not a spherical camera");
    expectRefused(
        {"capture", path("s.spherewalk"), "--practice", "--camera", address, "--time-scale", "0.01"},
        "not a spherical camera");
    expectRefused({"camera", "info", "--camera", "127.0.0.1:1", "--time-scale", "0.01"}, "127.0.0.1:1");
}

TEST_F(BadInput, ADiskThatIsFull) {
    // No file may grow beyond 10 kB, as on a disk with so little left.
    const test::Program::Options full{"", 10'000};
    expectRefused({"export", path("s.spherewalk"), path("e"), "--scene", "sphere"}, "full", full);
    EXPECT_FALSE(fs::exists(path("e")));
    for (const auto& entry : fs::directory_iterator(s_folder->path())) {
        EXPECT_THAT(entry.path().filename().string(), Not(HasSubstr(".part")));
    }
    EXPECT_EQ(runCli({"check", path("s.spherewalk")}).status, 0);
}

TEST(Usage, IsExitStatusTwo) {
    EXPECT_EQ(runCli({}).status, 2);
    EXPECT_EQ(runCli({"fly"}).status, 2);
    EXPECT_EQ(runCli({"view"}).status, 2);
    EXPECT_EQ(runCli({"--help"}).status, 0);
}

} // namespace spherewalk
