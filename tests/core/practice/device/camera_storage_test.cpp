// SPDX-License-Identifier: GPL-3.0-or-later
// The camera's memory and the commands about files, on a folder of its own.
#include "device/camera_storage.h"
#include "expect_error.h"
#include "random.h"
#include "temporary_folder.h"

#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/jpeg/jpeg.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <set>

namespace spherewalk::practice {
namespace {

using test::expectError;

const Bytes& smallPicture() {
    static const Bytes bytes = jpeg::encode(RgbImage(64, 32), 80);
    return bytes;
}

class PracticeStorage : public testing::Test {
  protected:
    /// Stores photos as the camera does; the names.
    std::vector<std::string> take(CameraStorage& storage, int count) {
        std::vector<std::string> names;
        for (int i = 0; i < count; ++i) {
            names.push_back(storage.fileName(storage.takeShotNumber()));
            storage.add(names.back(), smallPicture(),
                        {std::chrono::sys_days(std::chrono::year(2026) / 1 / 2), {}});
        }
        return names;
    }

    static std::vector<std::string> namesIn(const Json& results) {
        std::vector<std::string> names;
        for (const Json& entry : results["entries"]) {
            names.push_back(entry["name"]);
        }
        return names;
    }

    static std::optional<OscCode> refusedWith(const std::function<void()>& call) {
        try {
            call();
            return std::nullopt;
        } catch (const OscError& error) {
            return error.code();
        }
    }

    test::TemporaryFolder m_folder;
};

TEST_F(PracticeStorage, NamesFollowTheShots) {
    CameraStorage storage(m_folder.path(), 1);
    EXPECT_THAT(take(storage, 3), testing::ElementsAre("R0010001.JPG", "R0010002.JPG", "R0010003.JPG"));
    EXPECT_EQ(storage.fileName(1'234'567), "R1244567.JPG");
    EXPECT_EQ(storage.nextShotNumber(), 4);
}

TEST_F(PracticeStorage, IsTheSameAfterTheCameraWasOff) {
    std::vector<std::string> names;
    std::string urlFolder;
    {
        CameraStorage storage(m_folder.path(), 1);
        names = take(storage, 3);
        storage.remove(names[1]);
        urlFolder = storage.urlFolder();
    }
    CameraStorage storage(m_folder.path(), 2);
    EXPECT_EQ(storage.urlFolder(), urlFolder) << "another seed changes nothing";
    ASSERT_EQ(storage.files().size(), 2U);
    EXPECT_EQ(storage.files()[0].name, names[0]);
    EXPECT_EQ(storage.files()[1].name, names[2]);
    EXPECT_EQ(storage.files()[1].width, 64);
    EXPECT_EQ(storage.files()[1].height, 32);
    EXPECT_EQ(storage.files()[1].sizeBytes, smallPicture().size());
    EXPECT_EQ(storage.takeShotNumber(), 4) << "a number is never given again";
}

TEST_F(PracticeStorage, SeedsGiveFoldersOfTheirOwn) {
    test::TemporaryFolder other;
    const CameraStorage one(m_folder.path(), 1);
    const CameraStorage two(other.path(), 2);
    EXPECT_THAT(one.urlFolder(), testing::MatchesRegex("/files/[0-9a-f]{30}/"));
    EXPECT_NE(one.urlFolder(), two.urlFolder());
}

TEST(PracticeStorageWithoutAFolder, LeavesNothingBehind) {
    std::filesystem::path folder;
    {
        const CameraStorage storage({}, 1);
        folder = storage.folder();
        EXPECT_TRUE(std::filesystem::is_directory(folder / "100RICOH"));
    }
    EXPECT_FALSE(std::filesystem::exists(folder));
}

TEST_F(PracticeStorage, AFileIsFoundByItsUrlAtAnyHost) {
    CameraStorage storage(m_folder.path(), 1);
    const std::string name = take(storage, 2)[1];
    const std::string path = storage.urlPath(name);
    EXPECT_EQ(storage.find(path)->name, name);
    EXPECT_EQ(storage.find("http://192.168.1.1" + path)->name, name);
    EXPECT_FALSE(storage.find("http://192.168.1.1/files/0000/100RICOH/" + name));
    EXPECT_FALSE(storage.find(path + "x"));
    EXPECT_FALSE(storage.find("/files/../camera.json"));
    EXPECT_FALSE(storage.find(name));
    EXPECT_EQ(CameraStorage::uri(name), "100RICOH/" + name);
    EXPECT_EQ(storage.path(name), m_folder / "100RICOH" / name);
}

TEST_F(PracticeStorage, UsedBytesAreThoseOfTheFiles) {
    CameraStorage storage(m_folder.path(), 1);
    EXPECT_EQ(storage.usedBytes(), 0U);
    const std::vector<std::string> names = take(storage, 4);
    EXPECT_EQ(storage.usedBytes(), 4 * smallPicture().size());
    storage.remove(names[0]);
    EXPECT_EQ(storage.usedBytes(), 3 * smallPicture().size());
    EXPECT_FALSE(std::filesystem::exists(storage.path(names[0])));
}

TEST_F(PracticeStorage, DamagedPhotosAreStoredWithoutASize) {
    CameraStorage storage(m_folder.path(), 1);
    storage.add("R0010001.JPG", Bytes{1, 2, 3}, {});
    EXPECT_EQ(storage.files().front().sizeBytes, 3U);
    EXPECT_EQ(storage.files().front().width, 0);
}

TEST_F(PracticeStorage, OtherFilesInTheFolderAreNoPhotos) {
    { const CameraStorage storage(m_folder.path(), 1); }
    writeFile(m_folder / "100RICOH" / "notes.txt", bytesOf("x"));
    writeFile(m_folder / "100RICOH" / "R001.JPG", bytesOf("x"));
    EXPECT_TRUE(CameraStorage(m_folder.path(), 1).files().empty());
}

TEST_F(PracticeStorage, ARestartedCounterGivesTheNamesOfOtherPictures) {
    CameraStorage storage(m_folder.path(), 1);
    const std::vector<std::string> before = take(storage, 3);
    storage.restartNames();
    EXPECT_TRUE(storage.files().empty());
    EXPECT_EQ(storage.nextShotNumber(), 4) << "the truth counts on";
    EXPECT_EQ(take(storage, 2), (std::vector<std::string>{before[0], before[1]}));
    const CameraStorage again(m_folder.path(), 1);
    EXPECT_EQ(again.fileName(6), before[2]) << "the record remembers the restart";
}

TEST_F(PracticeStorage, ADamagedRecordIsNotGuessed) {
    { const CameraStorage storage(m_folder.path(), 1); }
    const auto refuses = [&](const std::string& record) {
        writeFile(m_folder / "camera.json", bytesOf(record));
        expectError(ErrorKind::Corrupt, "camera.json", [&] { CameraStorage(m_folder.path(), 1); });
    };
    refuses("{");
    refuses(R"({"storage_id": "0a", "next_shot": 0})");
    refuses(R"({"storage_id": "0a", "next_shot": "1"})");
    refuses(R"({"storage_id": "../x", "next_shot": 1})");
    refuses(R"({"storage_id": "0a", "next_shot": 2, "named_from": 3})");
}

TEST_F(PracticeStorage, PagesOfFilesCoverEachOnce) {
    CameraStorage storage(m_folder.path(), 1);
    std::vector<std::string> names = take(storage, 7);
    test::Random random(23);
    SCOPED_TRACE(random.seed());
    for (const bool isNewest : {true, false}) {
        std::reverse(names.begin(), names.end()); // newest first, then oldest first
        std::vector<std::string> listed;
        while (listed.size() < names.size()) {
            const int count = random.integer(1, 3);
            const Json page = listedFiles(storage,
                                          {{"fileType", "image"},
                                           {"entryCount", count},
                                           {"maxThumbSize", 0},
                                           {"startPosition", listed.size()},
                                           {"_sort", isNewest ? "newest" : "oldest"}},
                                          "http://h");
            EXPECT_EQ(page["totalEntries"], names.size());
            const std::vector<std::string> part = namesIn(page);
            ASSERT_FALSE(part.empty());
            ASSERT_LE(part.size(), static_cast<std::size_t>(count));
            listed.insert(listed.end(), part.begin(), part.end());
        }
        EXPECT_EQ(listed, names) << isNewest;
    }
}

TEST_F(PracticeStorage, AListMayBeginAtAFile) {
    CameraStorage storage(m_folder.path(), 1);
    const std::vector<std::string> names = take(storage, 4);
    const auto listed = [&](const Json& url) {
        return namesIn(listedFiles(
            storage, {{"fileType", "all"}, {"entryCount", 10}, {"maxThumbSize", 640}, {"_startFileUrl", url}},
            ""));
    };
    EXPECT_THAT(listed("http://x" + storage.urlPath(names[1])), testing::ElementsAre(names[1], names[0]));
    EXPECT_EQ(refusedWith([&] { listed("/files/none"); }), OscCode::InvalidParameterValue);
    EXPECT_EQ(refusedWith([&] { listed(3); }), OscCode::InvalidParameterValue);
}

TEST_F(PracticeStorage, AListSaysMoreIfAsked) {
    CameraStorage storage(m_folder.path(), 1);
    take(storage, 1);
    Json parameters = {{"fileType", "image"}, {"entryCount", 1}, {"maxThumbSize", 0}};
    const Json whole = listedFiles(storage, parameters, "http://h")["entries"][0];
    EXPECT_EQ(whole["dateTimeZone"], "2026:01:02 00:00:00+00:00");
    EXPECT_EQ(whole["width"], 64);
    EXPECT_EQ(whole["fileUrl"], "http://h" + storage.urlPath("R0010001.JPG"));
    parameters["_detail"] = false;
    const Json brief = listedFiles(storage, parameters, "http://h")["entries"][0];
    EXPECT_EQ(brief["dateTime"], "2026:01:02 00:00:00");
    EXPECT_FALSE(brief.contains("width"));
    parameters["fileType"] = "video";
    EXPECT_EQ(listedFiles(storage, parameters, "")["totalEntries"], 0) << "it has taken no films";
}

TEST_F(PracticeStorage, ListsRefuseParametersThatNoCameraKnows) {
    const CameraStorage storage(m_folder.path(), 1);
    const Json good = {{"fileType", "image"}, {"entryCount", 1}, {"maxThumbSize", 0}};
    const auto refused = [&](const char* name, const Json& value) {
        Json parameters = good;
        parameters[name] = value;
        return refusedWith([&] { listedFiles(storage, parameters, ""); });
    };
    EXPECT_EQ(refused("fileType", "pictures"), OscCode::InvalidParameterValue);
    EXPECT_EQ(refused("entryCount", -1), OscCode::InvalidParameterValue);
    EXPECT_EQ(refused("maxThumbSize", 320), OscCode::InvalidParameterValue);
    EXPECT_EQ(refused("startPosition", 0.5), OscCode::InvalidParameterValue);
    EXPECT_EQ(refused("_sort", "largest"), OscCode::InvalidParameterValue);
    EXPECT_EQ(refused("_detail", 1), OscCode::InvalidParameterValue);
    EXPECT_EQ(refused("colour", "red"), OscCode::InvalidParameterName);
    for (const auto& [name, value] : good.items()) {
        Json parameters = good;
        parameters.erase(name);
        EXPECT_EQ(refusedWith([&] { listedFiles(storage, parameters, ""); }), OscCode::MissingParameter)
            << name;
    }
}

TEST_F(PracticeStorage, ImagesOfLevelOneGoOnWhereTheTokenSays) {
    CameraStorage storage(m_folder.path(), 1);
    std::vector<std::string> names = take(storage, 5);
    std::reverse(names.begin(), names.end());
    std::vector<std::string> listed;
    Json parameters = {{"entryCount", 2}};
    for (int page = 0; page < 3; ++page) {
        const Json results = listedImages(storage, parameters);
        for (const std::string& name : namesIn(results)) {
            listed.push_back(name);
        }
        EXPECT_EQ(results.contains("continuationToken"), page < 2);
        parameters["continuationToken"] = results.value("continuationToken", "");
    }
    EXPECT_EQ(listed, names);
    for (const Json& token : {Json(""), Json("-1"), Json("x"), Json(2), Json("1234567890")}) {
        parameters["continuationToken"] = token;
        EXPECT_EQ(refusedWith([&] { listedImages(storage, parameters); }), OscCode::InvalidParameterValue)
            << token;
    }
}

TEST_F(PracticeStorage, FilesAreDeletedAllOrNone) {
    CameraStorage storage(m_folder.path(), 1);
    const std::vector<std::string> names = take(storage, 4);
    const auto urls = [&](std::initializer_list<int> which) {
        Json list = Json::array();
        for (const int i : which) {
            list.push_back(storage.urlPath(names[std::size_t(i)]));
        }
        return list;
    };
    Json wrong = urls({0, 1});
    wrong.push_back("/files/none");
    EXPECT_EQ(refusedWith([&] {
                  deleteFiles(storage, {{"fileUrls", wrong}});
              }),
              OscCode::InvalidParameterValue);
    EXPECT_EQ(storage.files().size(), 4U);
    deleteFiles(storage, {{"fileUrls", urls({0, 2})}});
    ASSERT_EQ(storage.files().size(), 2U);
    EXPECT_EQ(storage.files()[0].name, names[1]);
    deleteFiles(storage, {{"fileUrls", Json::array({"video"})}});
    EXPECT_EQ(storage.files().size(), 2U);
    deleteFiles(storage, {{"fileUrls", Json::array({"all"})}});
    EXPECT_TRUE(storage.files().empty());
    const Json many = std::vector<std::string>(129, "x");
    EXPECT_EQ(refusedWith([&] { deleteFiles(storage, {{"fileUrls", many}}); }), OscCode::TooManyParameters);
    EXPECT_EQ(refusedWith([&] {
                  deleteFiles(storage, {{"fileUrls", Json::array()}});
              }),
              OscCode::InvalidParameterValue);
}

} // namespace
} // namespace spherewalk::practice
