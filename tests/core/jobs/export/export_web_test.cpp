// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "made_survey.h"
#include "photographed_survey.h"
#include "test_dataset.h"

#include "spherewalk/base/statistics.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jobs/export_place.h"
#include "spherewalk/jobs/measure_dataset.h"
#include "spherewalk/render/renderer.h"
#include "spherewalk/report/chart.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace spherewalk::jobs {
namespace {

using test::expectError;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

/// What data/place.js assigns.
Json placeOf(const fs::path& page) {
    std::string script = readTextFile(page / "data/place.js");
    const std::string begin = "spherewalk.place = ";
    EXPECT_THAT(script, testing::StartsWith(begin));
    EXPECT_THAT(script, testing::EndsWith(";\n"));
    script = script.substr(begin.size(), script.size() - begin.size() - 2);
    return parseJson(script, "place.js");
}

/// The text files of a page, but for the library.
std::vector<fs::path> filesOf(const fs::path& page) {
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(page)) {
        if (entry.is_regular_file() && entry.path().filename() != "three.min.js" &&
            entry.path().filename() != "three-licence.txt") {
            files.push_back(entry.path());
        }
    }
    return files;
}

std::string fromBase64(std::string_view text) {
    constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    std::uint32_t group = 0;
    int bits = 0;
    for (const char letter : text.substr(0, text.find('='))) {
        group = group << 6U | static_cast<std::uint32_t>(kLetters.find(letter));
        bits += 6;
        if (bits >= 8) {
            bits -= 8;
            bytes += static_cast<char>(group >> static_cast<unsigned>(bits) & 0xFFU);
        }
    }
    return bytes;
}

/// What the script of a photo hands over.
Json photoOf(const fs::path& page, std::size_t number) {
    const std::string script = readTextFile(page / text("photos/000", number + 1, ".js"));
    const std::string begin = text("spherewalk.arrived(", number, ", ");
    EXPECT_THAT(script.substr(0, begin.size()), begin);
    return parseJson(script.substr(begin.size(), script.size() - begin.size() - 3), "a photo");
}

class ExportWeb : public testing::Test {
  protected:
    ExportWeb() : info(test::writeEmptyRoom(dataset())) {}

    fs::path dataset() const { return folder / "room.dataset"; }

    fs::path page() const { return folder / "page"; }

    WebReport write(const std::stop_token& stop = {}) {
        return exportWeb(dataset(), page(), options, noProgress(), stop);
    }

    test::TemporaryFolder folder;
    render::DatasetInfo info;
    WebOptions options;
};

} // namespace

TEST_F(ExportWeb, HasThePhotosTheirDepthsAndWhoSeesWhom) {
    const WebReport report = write();
    EXPECT_EQ(report.photos, 4U);
    EXPECT_EQ(report.withDepth, 4U);
    const Json place = placeOf(page());
    ASSERT_EQ(place["photos"].size(), 4U);
    const Json& first = place["photos"][0];
    EXPECT_EQ(first["position"], Json({1.0, 0.8, 1.2}));
    EXPECT_EQ(first["script"], "photos/0001.js");
    EXPECT_EQ(first["neighbours"].size(), 3U) << "an empty room hides nothing";
    EXPECT_EQ(first["neighbours"][0], 2) << "the nearest first";
    EXPECT_GT(first["depth"]["sigma_m"].get<double>(), 0);
    EXPECT_GT(first["depth"]["sigma_per_m"].get<double>(), 0);
    EXPECT_EQ(place["maps"].size(), 2U) << "coverage, and what the photos foretell";
    EXPECT_FALSE(place["has_review"].get<bool>());
    const std::string depth = fromBase64(photoOf(page(), 0)["depth"].get<std::string>());
    ASSERT_EQ(depth.size(), 2U * 256 * 128);
    const auto map = render::DepthMap::read(dataset() / info.photos[0].depth);
    const std::size_t at = 70 * 256 + 40;
    const int value = static_cast<std::uint8_t>(depth[2 * at]) | static_cast<std::uint8_t>(depth[2 * at + 1])
                                                                     << 8;
    EXPECT_EQ(value & 1, 1) << "it was measured";
    EXPECT_NEAR((value >> 1) * render::DepthMap::kStepPerM, *map.inverseM().at(40, 70), 1e-6);
}

/// Views of the whole camera, all around, from cells near and far from the photos.
TEST_F(ExportWeb, ForetellsWhatViewsFromAllOverTheFloorAreOff) {
    info.outline = {{0, 0}, {3, 0}, {3, 2}, {0, 2}};
    test::rewriteInfo(dataset(), info);
    write();
    const Json map = placeOf(page())["maps"][1];
    EXPECT_EQ(map["name"], "Foretold error of views");
    EXPECT_EQ(map["floor"]["cell_m"], 0.2);
    ASSERT_EQ(map["floor"]["runs"].size(), 15U * 10U);
    const render::Renderer renderer(
        std::make_shared<const render::Dataset>(render::Dataset::open(dataset())));
    const CameraModel camera(CameraIntrinsics::pinhole(640, 480, Radians(Degrees(57)).value()));
    for (const int cell : {0, 4 * 15 + 5, 6 * 15 + 14}) {
        const Json run = map["floor"]["runs"][static_cast<std::size_t>(cell)];
        EXPECT_EQ(run, Json({cell / 15, cell % 15, cell % 15 + 1, cell}));
        std::vector<double> errors;
        for (int i = 0; i < 6; ++i) {
            const Rigid3 pose{yawRotation(Radians(Degrees(60 * i))) * bodyFromOptical(),
                              {0.2 * (cell % 15 + 0.5), 0.2 * (cell / 15 + 0.5), 1.2}};
            errors.push_back(renderer.render(camera, pose).report.parallaxPx);
        }
        const std::string wanted = report::errorColour(median(errors), MeasureOptions().tolerancePx);
        const std::string found = map["colours"][static_cast<std::size_t>(cell)];
        for (const std::size_t channel : {1U, 3U, 5U}) {
            EXPECT_NEAR(std::stoi(found.substr(channel, 2), nullptr, 16),
                        std::stoi(wanted.substr(channel, 2), nullptr, 16), 12)
                << found << " in place of " << wanted << " in cell " << cell << ", " << median(errors);
        }
    }
}

TEST_F(ExportWeb, ForetellsNothingFromPhotosOfUnknownHeading) {
    for (render::DatasetPhoto& photo : info.photos) {
        photo.rotationSource = "unknown";
    }
    test::rewriteInfo(dataset(), info);
    write();
    EXPECT_EQ(placeOf(page())["maps"].size(), 1U) << "coverage";
}

TEST_F(ExportWeb, KeepsThePixelsAndDropsWhatElseAPhotoSays) {
    Bytes told = readFile(dataset() / info.photos[0].file);
    const std::string secret = "Serial 0815, 52.2 N, /home/anna";
    Bytes segment = {0xFF, 0xE1, 0, static_cast<std::uint8_t>(secret.size() + 2)};
    segment.insert(segment.end(), secret.begin(), secret.end());
    told.insert(told.begin() + 2, segment.begin(), segment.end());
    const RgbImage before = jpeg::decode(told, "told");
    writeFile(dataset() / info.photos[0].file, told);
    info.photos[0].sizeBytes = told.size();
    info.photos[0].sha256 = sha256Hex(told);
    test::rewriteInfo(dataset(), info);
    write();
    const std::string picture = fromBase64(photoOf(page(), 0)["picture"].get<std::string>());
    EXPECT_THAT(picture, Not(HasSubstr("0815")));
    const RgbImage after = jpeg::decode(bytesOf(picture), "shown");
    EXPECT_TRUE(std::ranges::equal(before.values(), after.values()));
}

TEST_F(ExportWeb, TakesNothingFromANetworkAndNamesNoFolder) {
    write();
    for (const fs::path& file : filesOf(page())) {
        const std::string content = readTextFile(file);
        EXPECT_THAT(content, Not(HasSubstr("https:"))) << file;
        EXPECT_THAT(content, Not(HasSubstr(folder.path().string()))) << file;
        if (file.filename() != "plan.js") { // which names SVG's name space
            EXPECT_THAT(content, Not(HasSubstr("http:"))) << file;
        }
    }
    EXPECT_THAT(readTextFile(page() / "index.html"), HasSubstr("default-src 'none'"));
    EXPECT_THAT(readTextFile(page() / "page/three-licence.txt"), HasSubstr("three.js authors"));
    EXPECT_GT(fs::file_size(page() / "page/three.min.js"), 100'000U);
}

TEST_F(ExportWeb, ShowsHostileNamesAsText) {
    const std::string name = "</title><script>alert('1')</script> \"{{noScript}}\" \xE2\x80\xA8 \xC5\xBC";
    info.name = name;
    info.photos[0].station = "</script><!-- " + name;
    test::rewriteInfo(dataset(), info);
    write();
    const std::string html = readTextFile(page() / "index.html");
    EXPECT_THAT(html, HasSubstr("&lt;/title&gt;&lt;script&gt;"));
    EXPECT_THAT(html, Not(HasSubstr("<script>alert")));
    EXPECT_THAT(html, HasSubstr("&quot;{{noScript}}&quot;")) << "a name is no placeholder";
    const std::string script = readTextFile(page() / "data/place.js");
    EXPECT_TRUE(std::ranges::all_of(
        script, [](char letter) { return letter == '\n' || (letter >= ' ' && letter < 127); }));
    EXPECT_EQ(placeOf(page())["photos"][0]["station"], info.photos[0].station);
}

TEST_F(ExportWeb, SaysWhatLacksInPlaceOfABrokenPage) {
    info.photos.resize(2);
    info.photos[0].depth.clear();
    info.photos[1].rotationSource = "unknown";
    test::rewriteInfo(dataset(), info);
    EXPECT_EQ(write().withDepth, 0U) << "the depth of an unknown heading is wrong";
    const Json photos = placeOf(page())["photos"];
    EXPECT_TRUE(photos[0]["depth"].is_null());
    EXPECT_TRUE(photos[1]["depth"].is_null());
    EXPECT_FALSE(photos[1]["heading_known"].get<bool>());
    EXPECT_FALSE(photoOf(page(), 1).contains("depth"));
    fs::remove_all(page());
    info.photos.resize(1);
    test::rewriteInfo(dataset(), info);
    EXPECT_EQ(write().photos, 1U);
    EXPECT_TRUE(placeOf(page())["photos"][0]["neighbours"].empty());
}

TEST_F(ExportWeb, ReplacesNothingAndLeavesNothing) {
    std::stop_source stop;
    stop.request_stop();
    expectError(ErrorKind::Stopped, "", [&] { write(stop.get_token()); });
    EXPECT_FALSE(fs::exists(page()));
    fs::remove(dataset() / info.photos[2].file);
    EXPECT_THROW(write(), Error);
    EXPECT_FALSE(fs::exists(page()));
    writeFile(page(), bytesOf("mine"));
    expectError(ErrorKind::Exists, "page", [&] { write(); });
}

TEST(ExportWebOfASurvey, ShowsWhatPeopleAndChecksSaid) {
    const test::PhotographedSurvey survey(4, 512, 6);
    std::vector<store::PhotoRecord> photos;
    {
        auto store = survey.open(store::Access::Write);
        photos = store.keptPhotos();
        store.setReview({photos[0].id, store::Decision::Accepted, "moved </script> chair"});
        store.setReview({photos[1].id, store::Decision::Rejected, "a person"});
        store.setVerdict({photos[0].id, survey::Quality::Doubtful,
                          R"([{"flaw":"dark","quality":"doubtful","sentence":"It is too dark."}])"});
    }
    WebOptions options;
    options.language = "xx";
    options.translated = [](const std::string& english) { return "~" + english; };
    const WebReport report = exportWeb(survey.path(), survey / "page", options, noProgress(), {});
    EXPECT_EQ(report.photos, 3U) << "the rejected one is left out";
    const Json place = placeOf(survey / "page");
    EXPECT_TRUE(place["has_review"].get<bool>());
    const Json& first = place["photos"][0];
    EXPECT_EQ(first["state"], "doubtful");
    EXPECT_EQ(first["decision"], "accepted");
    EXPECT_EQ(first["note"], "moved </script> chair");
    EXPECT_EQ(first["findings"][0], "~It is too dark.") << "in the person's language";
    EXPECT_EQ(place["words"]["plan"], "~Plan");
    EXPECT_THAT(readTextFile(survey / "page/index.html"), HasSubstr("<html lang=\"xx\">"));
    std::multiset<std::string> whys;
    for (const Json& one : place["without_photo"]) {
        whys.insert(one["why"].get<std::string>());
    }
    EXPECT_EQ(whys.count("rejected"), 1U);
    EXPECT_EQ(whys.count("missing"), report.leftOut - 1);
    for (const fs::path& file : filesOf(survey / "page")) {
        EXPECT_THAT(readTextFile(file), Not(HasSubstr(survey.path().parent_path().string()))) << file;
    }
}

TEST(ExportWebOfASurvey, RefusesOneWithoutPhotosAndAReportOfAnother) {
    const test::TemporaryFolder folder;
    const fs::path empty = test::makeSurvey(folder / "s.spherewalk");
    expectError(ErrorKind::InvalidInput, "no station has a photo",
                [&] { exportWeb(empty, folder / "page", {}, noProgress(), {}); });
    EXPECT_FALSE(fs::exists(folder / "page"));
    const test::PhotographedSurvey survey(1);
    WebOptions options;
    options.measured = survey / "none.json";
    expectError(ErrorKind::NotFound, "none.json",
                [&] { exportWeb(survey.path(), survey / "page", options, noProgress(), {}); });
    EXPECT_FALSE(fs::exists(survey / "page"));
}

} // namespace spherewalk::jobs
