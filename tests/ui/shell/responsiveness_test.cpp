// SPDX-License-Identifier: GPL-3.0-or-later
#include "event_loop_gap.h"
#include "person.h"
#include "photographed_survey.h"
#include "stalled_server.h"
#include "ui/panorama/panorama_presenter.h"
#include "ui/panorama/panorama_view.h"
#include "ui/review/review_mode.h"

#include <QListView>

namespace spherewalk::ui {

namespace {

constexpr double kOpenMs = 2000; ///< Of processor time.

QString pathOf(const test::PhotographedSurvey& survey) {
    return QString::fromStdString(survey.path().string());
}

/// Goes through the list, looks around in each photo, and compares it with its neighbour.
void lookAtPhotos(Person& person, const test::EventLoopGap& gap, int photos) {
    auto& list = person.widget<QListView>("stations");
    auto& view = *person.page<ReviewMode>().findChild<PanoramaView*>();
    QTest::keyClick(&list, Qt::Key_Home);
    for (int i = 0; i < photos; ++i) {
        person.waitUntil([&] { return view.presenter().remark().isEmpty(); }); // it is decoded
        for (int turn = 0; turn < 10; ++turn) {
            QTest::keyClick(&view, Qt::Key_Left);
            person.rest(gap, 2);
        }
        QTest::keyClick(&list, Qt::Key_C);
        person.rest(gap);
        QTest::keyClick(&list, Qt::Key_J);
        person.rest(gap);
    }
}

} // namespace

TEST(Responsiveness, AStalledCameraHoldsNeitherCapturingNorReviewing) {
    const test::StalledServer server;
    const test::PhotographedSurvey survey(3, 2048);
    Person person;
    person.window().openSurvey(pathOf(survey));
    person.choose("Capture");
    CaptureDesk& desk = person.page<CaptureMode>().desk();
    desk.connectTo(server.address());
    person.rest(test::EventLoopGap(), 50);
    const double capturing = test::heldMs([&](const test::EventLoopGap& gap) { person.rest(gap, 300); });
    EXPECT_EQ(desk.state(), CaptureDesk::State::Connecting); // it does stall
    RecordProperty("capturing_longest_gap_ms", std::to_string(capturing));
    person.choose("Review");
    lookAtPhotos(person, test::EventLoopGap(), 3);
    const double reviewing =
        test::heldMs([&](const test::EventLoopGap& gap) { lookAtPhotos(person, gap, 3); });
    RecordProperty("reviewing_longest_gap_ms", std::to_string(reviewing));
    EXPECT_LT(capturing, test::kMostHeldMs);
    EXPECT_LT(reviewing, test::kMostHeldMs);
    person.window().close();
}

TEST(Responsiveness, DecidingHoldsNobody) {
    const test::PhotographedSurvey survey(8, 512);
    Person person;
    person.window().openSurvey(pathOf(survey));
    person.choose("Review");
    auto& list = person.widget<QListView>("stations");
    const auto decideOnAll = [&](const test::EventLoopGap& gap) {
        QTest::keyClick(&list, Qt::Key_Home);
        for (int i = 0; i < 8; ++i) {
            QTest::keyClick(&list, i % 2 == 0 ? Qt::Key_A : Qt::Key_R);
            person.rest(gap);
        }
    };
    decideOnAll(test::EventLoopGap());
    const double heldMs = test::heldMs(decideOnAll);
    RecordProperty("longest_gap_ms", std::to_string(heldMs));
    EXPECT_LT(heldMs, test::kMostHeldMs);
    EXPECT_EQ(survey.open().reviews().size(), 8U);
}

TEST(Responsiveness, ASurveyOf404PhotosOpensSoon) {
    constexpr int kPhotos = 404;
    const test::PhotographedSurvey survey(kPhotos, 512);
    Person person;
    const double beforeMs = test::ownProcessorMs();
    ASSERT_TRUE(person.window().openSurvey(pathOf(survey)));
    person.choose("Review");
    QCoreApplication::processEvents();
    const double openMs = test::ownProcessorMs() - beforeMs;
    RecordProperty("open_ms", std::to_string(openMs));
    EXPECT_LT(openMs, kOpenMs);
    EXPECT_GE(person.widget<QListView>("stations").model()->rowCount(), kPhotos);
}

} // namespace spherewalk::ui
