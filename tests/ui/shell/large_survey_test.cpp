// SPDX-License-Identifier: GPL-3.0-or-later
#include "event_loop_gap.h"
#include "person.h"
#include "photographed_survey.h"

#include <QLabel>
#include <QListView>
#include <QMouseEvent>

#include <algorithm>

namespace spherewalk::ui {

namespace {

constexpr int kStations = 2000;

/// How many stations the plan that is being drawn has, as the panel says.
int stationsSaid(const Person& person) {
    return person.widget<QLabel>("planCounts").text().section(' ', 0, 0).toInt();
}

/// Pulls the corner at (5, 4) out and in.
void pullCorner(Person& person, const test::EventLoopGap& gap) {
    PlanEditorView& view = person.page<PlanMode>().view();
    const Eigen::Vector2d corner(5, 4);
    QTest::mousePress(&view, Qt::LeftButton, {}, Person::at(view, corner));
    constexpr int kMoves = 20;
    for (int i = 1; i <= kMoves; ++i) {
        const double byM = 0.1 * std::min(i, kMoves - i);
        const QPoint to = Person::at(view, corner - Eigen::Vector2d(byM, byM));
        QMouseEvent move(QEvent::MouseMove, to, view.mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&view, &move);
        person.rest(gap, 3);
    }
    QTest::mouseRelease(&view, Qt::LeftButton, {}, Person::at(view, corner));
    person.rest(gap);
}

} // namespace

TEST(LargeSurvey, NoPageOfManyStationsHoldsItsUser) {
    constexpr int kPhotos = 404;
    const test::PhotographedSurvey survey(kPhotos, 512, kStations);
    ASSERT_GE(survey.open().stations().size(), static_cast<std::size_t>(kStations));
    Person person;
    ASSERT_TRUE(person.window().openSurvey(QString::fromStdString(survey.path().string())));
    const QStringList pages{"Plan", "Capture", "Review", "Align", "Preview", "Export"};
    const auto look = [&](const QString& page, const test::EventLoopGap& gap) {
        person.choose(page);
        person.rest(gap);
        if (page == "Review") {
            auto& list = person.widget<QListView>("stations");
            for (const Qt::Key key : {Qt::Key_Home, Qt::Key_Down, Qt::Key_End, Qt::Key_Up}) {
                QTest::keyClick(&list, key);
                person.rest(gap);
            }
        }
    };
    for (const QString& page : pages) {
        look(page, test::EventLoopGap());
    }
    for (const QString& page : pages) {
        const test::EventLoopGap gap;
        look(page, gap);
        RecordProperty(page.toLower().toStdString() + "_longest_gap_ms", std::to_string(gap.longestMs()));
        EXPECT_LT(gap.longestBusyMs(), test::kMostHeldMs) << page.toStdString();
    }
}

TEST(LargeSurvey, ManyStationsAreDrawnWithoutAPause) {
    Person person;
    person.choose("Plan");
    person.type("step", "0.08");
    person.waitUntil([&] { return stationsSaid(person) >= kStations; });
    pullCorner(person, test::EventLoopGap());
    const test::EventLoopGap gap;
    pullCorner(person, gap);
    RecordProperty("longest_gap_ms", std::to_string(gap.longestMs()));
    EXPECT_LT(gap.longestBusyMs(), test::kMostHeldMs);
    person.waitUntil([&] { return stationsSaid(person) >= kStations; });
}

} // namespace spherewalk::ui
