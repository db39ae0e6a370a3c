// SPDX-License-Identifier: GPL-3.0-or-later
#include "random.h"

#include "spherewalk/jobs/align_survey.h"

#include <gtest/gtest.h>

namespace spherewalk::jobs {

namespace {

/// A grid of five times five photos, tagged to some millimetres, and solved without an error.
class MovedPhotos : public testing::Test {
  protected:
    MovedPhotos() {
        for (int i = 0; i < 25; ++i) {
            align::PhotoPrior prior;
            prior.positionM = Eigen::Vector3d(0.2 * (i % 5), 0.2 * (i / 5), 1.2) + random.vector(0.003);
            align::SolvedPose pose;
            pose.isSolved = true;
            pose.roomFromPhoto.translation = Eigen::Vector3d(0.2 * (i % 5), 0.2 * (i / 5), 1.2);
            tagged.push_back(prior);
            alignment.photos.push_back(pose);
        }
    }

    /// As a wrong tag drags and turns all of a survey whose place rests on few rails.
    void drag(double turnRad, const Eigen::Vector3d& shiftM) {
        const Eigen::AngleAxisd turn(turnRad, Eigen::Vector3d::UnitZ());
        for (align::SolvedPose& pose : alignment.photos) {
            pose.roomFromPhoto.translation = turn * pose.roomFromPhoto.translation + shiftM;
        }
    }

    std::vector<std::size_t> moved() const {
        std::vector<std::size_t> photos;
        for (const PhotoMove& one : movedPhotos(tagged, alignment)) {
            photos.push_back(one.photo);
        }
        return photos;
    }

    test::Random random{20};
    std::vector<align::PhotoPrior> tagged;
    align::Alignment alignment;
};

} // namespace

TEST_F(MovedPhotos, AreNoneWhereTagsErrAsUsual) {
    EXPECT_TRUE(moved().empty());
    drag(0.02, {0.03, -0.02, 0}); // all together is no photo's own move
    EXPECT_TRUE(moved().empty());
}

TEST_F(MovedPhotos, AreFoundWhereOneWrongTagHasDraggedAll) {
    tagged[4].positionM += Eigen::Vector3d(0.072, -0.025, 0);
    drag(0.011, {0.018, -0.013, 0});
    ASSERT_EQ(moved(), std::vector<std::size_t>{4});
    EXPECT_NEAR(movedPhotos(tagged, alignment).front().byM, 0.076, 0.008);
}

TEST_F(MovedPhotos, AreFoundInEachPartByItself) {
    for (std::size_t i = 0; i < 10; ++i) {
        alignment.photos[i].component = 1;
        alignment.photos[i].roomFromPhoto.translation += Eigen::Vector3d(0.05, 0.05, 0);
    }
    tagged[3].positionM.x() += 0.1;
    tagged[20].positionM.y() -= 0.1;
    EXPECT_EQ(moved(), (std::vector<std::size_t>{3, 20}));
}

} // namespace spherewalk::jobs
