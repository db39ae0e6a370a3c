// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "expect_error.h"
#include "temporary_folder.h"

#include "spherewalk/base/digest.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"
#include "spherewalk/store/survey_store.h"

#include <gtest/gtest.h>

#include <string>
#include <unistd.h>

namespace spherewalk::store::test {

inline survey::Room smallRoom() {
    return {.outline = {{0, 0}, {1.2, 0}, {1.2, 1}, {0, 1}},
            .obstacles = {{{-0.1, -0.1}, {0.02, -0.1}, {0.02, 0.02}, {-0.1, 0.02}}},
            .ceilingM = 2.6};
}

inline survey::PlanOptions twoHeights() {
    return {.stepM = 0.2, .heightsM = {1.6, 0.9}, .railStops = 4, .clearanceM = 0.3};
}

/// A survey of a small room: 4 by 3 stops at two heights.
inline SurveyStore createSurvey(const std::filesystem::path& folder, const StoreOptions& options = {}) {
    return SurveyStore::create(folder, "Small room", smallRoom(), twoHeights(),
                               survey::plan(smallRoom(), twoHeights()), options);
}

/// A photo of these bytes, complete in the photo folder, for the station.
inline NewPhoto newPhoto(const SurveyStore& store, std::int64_t station, const std::string& bytes,
                         const std::string& fileName) {
    writeFile(store.photoFolder() / fileName, bytesOf(bytes));
    NewPhoto photo;
    photo.station = station;
    photo.fileName = fileName;
    photo.cameraFileName = "R0010001.JPG";
    photo.cameraSerial = "YN12345678";
    photo.fileUrl = "http://192.168.1.1/files/R0010001.JPG";
    photo.cameraSha256 = sha256Hex(bytesOf("camera " + bytes));
    photo.fileSha256 = sha256Hex(bytesOf(bytes));
    photo.sizeBytes = bytes.size();
    photo.width = 5376;
    photo.height = 2688;
    photo.positionM = {1, 2, 3};
    return photo;
}

/// Lets a child process have no more rights than anybody, since permissions do not hold for root. False if it
/// cannot.
inline bool giveUpRoot() {
    constexpr int kNobody = 65534;
    return ::geteuid() != 0 || (::setgid(kNobody) == 0 && ::setuid(kNobody) == 0);
}

/// A survey in a new folder for each case, open for writing.
class SurveyTest : public testing::Test {
  protected:
    spherewalk::test::TemporaryFolder m_folder;
    std::filesystem::path m_path = m_folder / "room.spherewalk";
    SurveyStore m_store = createSurvey(m_path);

    NewPhoto photoOf(std::int64_t station, const std::string& bytes) {
        return newPhoto(m_store, station, bytes, bytes + ".JPG");
    }

    std::int64_t stationAt(std::size_t index) { return m_store.stations().at(index).id; }

    static void expectRefused(ErrorKind kind, const std::string& part, const std::function<void()>& call) {
        spherewalk::test::expectError(kind, part, call);
    }
};

} // namespace spherewalk::store::test
