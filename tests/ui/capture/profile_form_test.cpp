// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture_fixture.h"
#include "ui/capture/profile_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QPushButton>

namespace spherewalk::ui {
namespace {

using survey::parseProfile;

TEST(ProfileForm, GivesBackWhatItShows) {
    for (const char* spelled : {"auto", "camera", "iso=200,shutter=1/60,white-balance=4000K", "ev=0.3",
                                "iso=123,white-balance=4321K", "white-balance=shade,width=2688"}) {
        const auto profile = parseProfile(spelled);
        const auto shown = ProfileForm(profile).profile();
        EXPECT_EQ(survey::profileText(shown), spelled);
    }
}

TEST(ProfileForm, NothingIsBrightenedThatIsFixed) {
    ProfileForm form(parseProfile("iso=200,ev=0.3"));
    auto* shutter = form.findChild<QComboBox*>("shutter");
    EXPECT_TRUE(form.findChild<QComboBox*>("compensation")->isEnabled());
    shutter->setCurrentIndex(shutter->findText("1/60 s"));
    EXPECT_FALSE(form.findChild<QComboBox*>("compensation")->isEnabled());
    EXPECT_EQ(survey::profileText(form.profile()), "iso=200,shutter=1/60");
}

TEST(ProfileForm, LeavesTheCameraAsItIs) {
    ProfileForm form(parseProfile("iso=200"));
    form.findChild<QCheckBox*>("asItIs")->setChecked(true);
    EXPECT_FALSE(form.findChild<QComboBox*>("iso")->isEnabled());
    EXPECT_EQ(form.profile(), std::nullopt);
}

TEST(ProfileForm, KeepsWhatTheCameraChoseLast) {
    ProfileForm form(parseProfile("white-balance=4000K,ev=0.3"), parseProfile("iso=160,shutter=1/50"));
    auto* keep = form.findChild<QPushButton*>("keepLast");
    EXPECT_TRUE(keep->text().contains("ISO 160, 1/50 s"));
    keep->click();
    EXPECT_EQ(survey::profileText(form.profile()), "iso=160,shutter=1/50,white-balance=4000K");
    EXPECT_FALSE(ProfileForm(parseProfile("auto")).findChild<QPushButton*>("keepLast")->isEnabled());
}

TEST(ProfileWords, NameWhatIsFixed) {
    EXPECT_EQ(profileWords(parseProfile("auto")), "automatic");
    EXPECT_EQ(profileWords(parseProfile("camera")), "as the camera is set");
    EXPECT_EQ(profileWords(parseProfile("iso=64,shutter=1/8,white-balance=daylight")),
              "ISO 64, 1/8 s, daylight");
}

using CaptureProfileTest = CaptureFixture;

TEST_F(CaptureProfileTest, TheLatestPhotoSaysWhatTheCameraChose) {
    EXPECT_EQ(latestExposure(session->store()), std::nullopt);
    connectPractice();
    desk().trigger();
    waitFor(CaptureDesk::State::AtStation);
    desk().trigger();
    waitUntil([&] { return !played.empty(); });
    const auto chosen = latestExposure(session->store());
    ASSERT_TRUE(chosen);
    EXPECT_GT(*chosen->iso, 0);
    EXPECT_GT(*chosen->shutterS, 0);
}

TEST_F(CaptureProfileTest, IsKeptInTheSurveyAndSetOnTheCamera) {
    auto* button = mode.findChild<QPushButton*>("captureProfile");
    EXPECT_EQ(button->text(), "E&xposure: automatic");
    desk().setProfile(parseProfile("iso=400,shutter=1/60"));
    EXPECT_EQ(button->text(), "E&xposure: ISO 400, 1/60 s");
    EXPECT_EQ(survey::profileText(session->store().captureProfile()), "iso=400,shutter=1/60");
    connectPractice();
    desk().trigger();
    waitFor(CaptureDesk::State::AtStation);
    camera::OscClient client(desk().practice()->endpoint(), {}, systemClock());
    EXPECT_EQ(client.getOptions({"iso"}, {})["iso"], 400);
    EXPECT_FALSE(button->isEnabled()); // not while a run goes on
}

} // namespace
} // namespace spherewalk::ui
