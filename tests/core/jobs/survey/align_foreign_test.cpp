// SPDX-License-Identifier: GPL-3.0-or-later
#include "temporary_folder.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/jobs/align_survey.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/practice/practice_camera.h"
#include "spherewalk/practice/practice_room.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

namespace spherewalk::jobs {

using testing::ElementsAre;
using testing::HasSubstr;

namespace {

constexpr EquirectSize kSize{512, 256};
constexpr std::size_t kPhotos = 9;
constexpr std::size_t kWithPerson = 4; ///< The photo in the middle.

/// Nine photos of the practice room in a square of 40 cm, with solved poses. In one stands somebody.
class AlignForeign : public testing::Test {
  protected:
    AlignForeign() {
        const practice::PracticeRoom room;
        practice::PhotoErrors errors;
        errors.seed = 3;
        for (std::size_t i = 0; i < kPhotos; ++i) {
            const Eigen::Vector3d place(2.0 + 0.2 * static_cast<double>(i % 3),
                                        1.6 + 0.2 * static_cast<double>(i / 3), 1.2);
            const Rigid3 pose = errors.truePose(place, static_cast<int>(i) + 1);
            RgbImage picture = room.spherical(pose, kSize);
            if (i == kWithPerson) {
                paintPerson(pose, picture);
            }
            AlignedPhoto photo;
            photo.file = text("R", i, ".JPG");
            writeFile(folder / photo.file, jpeg::encode(picture, 92));
            align::SolvedPose solved;
            solved.isSolved = true;
            solved.roomFromPhoto = pose;
            solved.sigmaOwn = Degrees(0.02);
            solved.sigmaPositionM = 0.002;
            photo.pose = solved;
            report.photos.push_back(photo);
            report.alignment.photos.push_back(solved);
        }
    }

    /// Somebody in stripes, 1 m away towards the middle of the room, from 50 cm above the lens to 90 cm
    /// below.
    static void paintPerson(const Rigid3& pose, RgbImage& picture) {
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                const Eigen::Vector3d way = pose.rotation * direction(kSize, Eigen::Vector2d(x, y));
                const double across = std::atan2(way.y(), way.x());
                const double up = way.z() / way.head<2>().norm();
                if (std::abs(across) < 0.2 && up > -0.9 && up < 0.5) {
                    const bool isStripe = static_cast<int>(std::floor(up * 10)) % 2 == 0;
                    std::uint8_t* at = picture.at(x, y);
                    at[0] = isStripe ? 230 : 20;
                    at[1] = isStripe ? 40 : 60;
                    at[2] = isStripe ? 40 : 160;
                }
            }
        }
    }

    std::vector<std::size_t> flagged() const {
        std::vector<std::size_t> found;
        for (std::size_t i = 0; i < report.photos.size(); ++i) {
            if (!report.photos[i].flags.empty()) {
                found.push_back(i);
            }
        }
        return found;
    }

    void tell() { tellForeignThings(folder.path(), {}, report, noProgress(), {}); }

    test::TemporaryFolder folder;
    AlignReport report;
};

} // namespace

TEST_F(AlignForeign, NamesThePhotoWithSomebodyInItAndSaysWhere) {
    tell();
    EXPECT_THAT(flagged(), ElementsAre(kWithPerson));
    const AlignedPhoto& photo = report.photos[kWithPerson];
    EXPECT_THAT(photo.flags.at(0), HasSubstr("other photos look through"));
    EXPECT_THAT(photo.flags.at(0), HasSubstr("of the sphere"));
    EXPECT_EQ(photo.cure, Cure::Retake);
    EXPECT_EQ(report.notSearched, 0U);
}

TEST_F(AlignForeign, SearchesNoPhotoWhosePoseIsUnsure) {
    for (align::SolvedPose& pose : report.alignment.photos) {
        pose.sigmaOwn = Degrees(2);
    }
    tell();
    EXPECT_TRUE(flagged().empty());
    EXPECT_EQ(report.notSearched, kPhotos);
}

TEST_F(AlignForeign, SpeaksOfNoPersonsInAPhotoThatIsNotPlaced) {
    report.alignment.photos[0].isSolved = false;
    tell();
    EXPECT_THAT(flagged(), ElementsAre(kWithPerson));
    EXPECT_EQ(report.notSearched, 0U);
}

TEST_F(AlignForeign, LeavesOutAPhotoThatCannotBeRead) {
    writeFile(folder / "R0.JPG", bytesOf("no picture"));
    tell();
    EXPECT_THAT(flagged(), ElementsAre(kWithPerson));
    EXPECT_EQ(report.notSearched, 1U);
}

TEST_F(AlignForeign, SearchesNothingInAPhotoThatStandsAlone) {
    report.photos.resize(1);
    report.alignment.photos.resize(1);
    tell();
    EXPECT_TRUE(flagged().empty());
    EXPECT_EQ(report.notSearched, 1U);
}

TEST_F(AlignForeign, StopsWhenAsked) {
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(tellForeignThings(folder.path(), {}, report, noProgress(), stop.get_token()), Error);
    EXPECT_TRUE(flagged().empty());
}

} // namespace spherewalk::jobs
