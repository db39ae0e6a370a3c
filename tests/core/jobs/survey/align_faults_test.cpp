// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "random.h"
#include "survey/room_photos.h"


#include <algorithm>

// Surveys in which a person or a robot has made a mistake that no single photo shows.
namespace spherewalk::jobs {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;

namespace {

class AlignFaults : public RoomPhotos {
  protected:
    /// As a second exposure of one scene differs from the first.
    static RgbImage withNoise(const RgbImage& picture, unsigned seed) {
        test::Random random(seed);
        RgbImage noisy = picture;
        for (std::uint8_t& value : noisy.values()) {
            value = static_cast<std::uint8_t>(std::clamp(value + random.normal(2), 0.0, 255.0));
        }
        return noisy;
    }
};

} // namespace

TEST_F(AlignFaults, NamesTwoPhotosOfACameraThatWasNotMoved) {
    photograph();
    pictures[1] = withNoise(pictures[0], 2);
    truth[1] = truth[0];
    folder.leaveUnchecked(); // one station has the picture of another
    auto store = newSurvey();
    const AlignReport report = alignSurvey(store, {}, noProgress(), {});
    const auto names = [&](const char* file, const char* other) {
        const AlignedPhoto& photo = photoOf(report, file);
        EXPECT_NE(photo.quality, survey::Quality::Good) << file;
        EXPECT_THAT(photo.flags, Contains(AllOf(HasSubstr("the camera was not moved between them"),
                                                HasSubstr(other), HasSubstr("0.20 m apart"))))
            << file;
    };
    names("R0.JPG", "R1.JPG");
    names("R1.JPG", "R0.JPG");
    for (const char* file : {"R2.JPG", "R3.JPG", "R4.JPG", "R5.JPG"}) {
        EXPECT_THAT(photoOf(report, file).flags, testing::IsEmpty()) << file;
    }
}

} // namespace spherewalk::jobs
