// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture/test_camera.h"
#include "expect_error.h"
#include "temporary_folder.h"

#include "spherewalk/base/digest.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"
#include "spherewalk/camera/photo_download.h"

#include <array>
#include <charconv>

namespace spherewalk::camera {
namespace {

using namespace std::chrono_literals;
using test::expectError;
using test::jpegBytes;
using test::ServerAction;

class PhotoDownloadTest : public testing::Test {
  protected:
    PhotoDownloadTest() {
        download.check = test::checkJpeg;
        camera.addFile("R0010049.JPG", jpegBytes(2048, 1024, 50'000));
        path = camera.files[0].path;
    }

    static OscOptions quick() {
        OscOptions options;
        options.http.stallTimeout = 150ms;
        return options;
    }

    DownloadedPhoto fetch() {
        return downloadPhoto(client, clock, "http://192.168.1.1" + path, target, download, {});
    }

    /// What the folder holds afterwards: nothing must be left of a failed download.
    std::size_t filesInFolder() const {
        return static_cast<std::size_t>(
            std::distance(std::filesystem::directory_iterator(folder.path()), {}));
    }

    void expectRefused(ErrorKind kind, const std::string& part) {
        expectError(kind, part, [&] { fetch(); });
        EXPECT_EQ(filesInFolder(), 0U);
    }

    /// The photo with its header, cut after so many bytes of the body.
    ServerAction cut(std::size_t bytes, ServerAction::Then then) const {
        const std::string whole = test::httpAnswer(200, "image/jpeg", camera.files[0].bytes);
        return {whole.substr(0, whole.find("\r\n\r\n") + 4 + bytes), then};
    }

    test::TestCamera::Fault cutting(std::size_t bytes, ServerAction::Then then) const {
        return [action = cut(bytes, then)](const auto&) { return action; };
    }

    test::TemporaryFolder folder;
    std::filesystem::path target = folder / "photo";
    test::ManualClock clock;
    test::EventLog log;
    test::TestCamera camera{clock, log};
    OscClient client{parseEndpoint(camera.address()), quick(), clock};
    DownloadOptions download;
    std::string path;
};

TEST_F(PhotoDownloadTest, BringsEveryByteAndItsFacts) {
    const DownloadedPhoto photo = fetch();
    const Bytes bytes = readFile(target);
    EXPECT_EQ(textOf(bytes), camera.files[0].bytes);
    EXPECT_EQ(photo.temporaryFile, target);
    EXPECT_EQ(photo.cameraFileName, "R0010049.JPG");
    EXPECT_EQ(photo.cameraSha256, sha256Hex(bytes));
    EXPECT_EQ(photo.sizeBytes, 50'000U);
    EXPECT_EQ(photo.width, 2048);
    EXPECT_EQ(photo.height, 1024);
    EXPECT_EQ(filesInFolder(), 1U);
}

TEST_F(PhotoDownloadTest, ReplacesWhatAKilledRunLeft) {
    writeFile(target, bytesOf("half a photo"));
    fetch();
    EXPECT_EQ(textOf(readFile(target)), camera.files[0].bytes);
}

TEST_F(PhotoDownloadTest, StartsAgainAfterACut) {
    for (const std::size_t bytes : {std::size_t{0}, std::size_t{1}, std::size_t{49'999}}) {
        camera.fault(path, cutting(bytes, ServerAction::Then::Close));
        fetch();
        EXPECT_EQ(textOf(readFile(target)), camera.files[0].bytes);
    }
    EXPECT_EQ(clock.passed(), 3s);
}

TEST_F(PhotoDownloadTest, StartsAgainAfterAStall) {
    camera.fault(path, cutting(20'000, ServerAction::Then::Stall));
    camera.fault(path, [](const auto&) { return test::neverAnswer(); });
    fetch();
    EXPECT_EQ(textOf(readFile(target)), camera.files[0].bytes);
}

TEST_F(PhotoDownloadTest, GivesUpAfterThreeRestarts) {
    camera.fault(path, cutting(100, ServerAction::Then::Close), 100);
    expectRefused(ErrorKind::Network, "broke");
    EXPECT_EQ(camera.count(path), 4);
}

TEST_F(PhotoDownloadTest, NoticesABodyCutShortWithoutALength) {
    const std::string half = camera.files[0].bytes.substr(0, 20'000);
    camera.fault(path, [&](const auto&) {
        return ServerAction{"HTTP/1.1 200 X\r\n\r\n" + half, ServerAction::Then::Close};
    });
    fetch();
    EXPECT_EQ(camera.count(path), 2);
    EXPECT_EQ(textOf(readFile(target)), camera.files[0].bytes);
}

TEST_F(PhotoDownloadTest, NoticesALengthThatIsTooShort) {
    const std::string bytes = camera.files[0].bytes;
    camera.fault(path, [&](const auto&) {
        return ServerAction{"HTTP/1.1 200 X\r\nContent-Length: 30000\r\n\r\n" + bytes,
                            ServerAction::Then::Close};
    });
    fetch();
    EXPECT_EQ(camera.count(path), 2);
}

TEST_F(PhotoDownloadTest, RefusesWhatTheListDoesNotAgreeWith) {
    camera.files[0].listedSize = 50'001;
    expectRefused(ErrorKind::Network, "50000 bytes instead of the 50001 of the camera's list");
}

TEST_F(PhotoDownloadTest, RefusesAPhotoWithoutItsEnd) {
    camera.files[0].bytes.back() = 'x';
    expectRefused(ErrorKind::Network, "its end is missing");
}

TEST_F(PhotoDownloadTest, RefusesAPhotoWhoseSecondHalfIsZeros) {
    camera.files[0].bytes.replace(25'000, 25'000, 25'000, '\0');
    expectRefused(ErrorKind::Network, "its end is missing");
}

TEST_F(PhotoDownloadTest, FindsTheMarkersHoweverTheBytesArePieced) {
    const std::string bytes = camera.files[0].bytes;
    const auto chunk = [](const std::string& piece) {
        std::array<char, 20> size{};
        const auto end = std::to_chars(size.data(), size.data() + size.size(), piece.size(), 16).ptr;
        return std::string(size.data(), end) + "\r\n" + piece + "\r\n";
    };
    for (const std::size_t tail : {1U, 2U, 3U}) {
        camera.fault(path, [&](const auto&) {
            return ServerAction{"HTTP/1.1 200 X\r\nTransfer-Encoding: chunked\r\n\r\n" +
                                chunk(bytes.substr(0, 1)) + chunk(bytes.substr(1, bytes.size() - 1 - tail)) +
                                chunk(bytes.substr(bytes.size() - tail)) + "0\r\n\r\n"};
        });
        fetch();
        EXPECT_EQ(textOf(readFile(target)), bytes);
    }
    EXPECT_EQ(clock.passed(), 0s); // each at its first attempt
}

TEST_F(PhotoDownloadTest, ToleratesPaddingAfterTheEnd) {
    for (const std::size_t padding : {1U, 1000U, 40'000U}) {
        camera.files[0].bytes = jpegBytes(2048, 1024, 50'000) + std::string(padding, '\0');
        camera.files[0].listedSize = 50'000 + padding;
        EXPECT_EQ(fetch().sizeBytes, 50'000 + padding);
    }
}

TEST_F(PhotoDownloadTest, RefusesWhatIsNoJpegWithoutTryingAgain) {
    camera.files[0].bytes[0] = 'P';
    expectRefused(ErrorKind::Corrupt, "not a JPEG");
    EXPECT_EQ(camera.count(path), 1);
}

TEST_F(PhotoDownloadTest, TellsAWebPageFromAPhoto) {
    camera.fault(path, [](const auto&) { return test::answerPage(200); });
    expectRefused(ErrorKind::Unsupported, "web page instead of a photo");
}

TEST_F(PhotoDownloadTest, RefusesEmptyFiles) {
    camera.files[0].bytes.clear();
    camera.files[0].listedSize = 0;
    expectRefused(ErrorKind::Corrupt, "not a JPEG");
}

TEST_F(PhotoDownloadTest, RefusesPicturesThatAreNotSpherical) {
    camera.files[0].bytes = jpegBytes(2048, 1025, 50'000);
    expectRefused(ErrorKind::Corrupt, "2048 x 1025");
    camera.files[0].bytes = jpegBytes(640, 320, 50'000);
    expectRefused(ErrorKind::Corrupt, "at least 1024");
}

TEST_F(PhotoDownloadTest, RefusesWhatTheCheckRefuses) {
    download.check = [](const auto&) -> PhotoFacts { throw Error(ErrorKind::Corrupt, "does not decode"); };
    expectRefused(ErrorKind::Corrupt, "does not decode");
}

TEST_F(PhotoDownloadTest, NamesThePhotoAndNoFileOfThisComputer) {
    download.check = [](const std::filesystem::path& file) -> PhotoFacts {
        throw Error(ErrorKind::Corrupt, text("The photo ", file.string(), " does not decode."));
    };
    expectRefused(ErrorKind::Corrupt, "The photo R0010049.JPG does not decode.");
}

TEST_F(PhotoDownloadTest, WaitsForAFileThatIsAnnouncedButNotYetWritten) {
    camera.fault(
        path, [](const auto&) { return test::answerOsc("notFound", 404); }, 2);
    fetch();
    EXPECT_EQ(camera.count(path), 3);
}

TEST_F(PhotoDownloadTest, NamesAPhotoThatTheCameraDoesNotHave) {
    camera.files.clear();
    expectRefused(ErrorKind::NotFound, "refused to send R0010049.JPG");
}

TEST_F(PhotoDownloadTest, BringsAPhotoThatTheCameraDoesNotListYet) {
    camera.fault(
        "camera.listFiles",
        [](const auto&) {
            return test::answerJson(R"({"state":"done","results":{"entries":[],"totalEntries":0}})");
        },
        2);
    EXPECT_EQ(fetch().sizeBytes, camera.files[0].bytes.size());
    EXPECT_EQ(clock.passed(), 0s);
}

TEST_F(PhotoDownloadTest, PassesOnThatItCannotWrite) {
    target = folder / "missing" / "photo";
    expectError(ErrorKind::Io, "missing", [&] { fetch(); });
    EXPECT_EQ(clock.passed(), 0s);
}

TEST_F(PhotoDownloadTest, LeavesNothingWhenStopped) {
    std::stop_source stop;
    camera.fault(path, [&](const auto&) {
        stop.request_stop();
        return cut(30'000, ServerAction::Then::Stall);
    });
    expectError(ErrorKind::Stopped, "Stopped",
                [&] { downloadPhoto(client, clock, path, target, download, stop.get_token()); });
    EXPECT_EQ(filesInFolder(), 0U);
}

TEST(DownloadOptions, NeedsACheck) {
    expectError(ErrorKind::InvalidInput, "check", [] { DownloadOptions().validate(); });
}

} // namespace
} // namespace spherewalk::camera
