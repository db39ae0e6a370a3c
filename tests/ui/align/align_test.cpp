// SPDX-License-Identifier: GPL-3.0-or-later
#include "hand_held_photos.h"
#include "made_survey.h"
#include "photographed_survey.h"
#include "qt_application.h"
#include "ui/align/align_mode.h"
#include "ui/align/align_presenter.h"
#include "ui/review/coverage_view.h"

#include "spherewalk/base/json.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QTest>

namespace spherewalk::ui {

namespace {

/// A solution of which the first photo fits the second station and the other way round, and the third failed.
void addFlaggedSolution(store::SurveyStore& store) {
    jobs::AlignReport report;
    report.alignment.reason = "Because of the matches.";
    store::NewSolution solution{"align", "tilt", "{}", {}};
    const std::vector<store::StationRecord> stations = store.stations();
    for (std::size_t i = 0; i < 3; ++i) {
        jobs::AlignedPhoto photo;
        photo.photo = store.chosenPhoto(stations[i].id)->id;
        photo.quality = i == 2 ? survey::Quality::Failed : survey::Quality::Doubtful;
        photo.cure = i == 2 ? jobs::Cure::Retake : jobs::Cure::Retag;
        photo.fits = i == 2 ? "" : stations[1 - i].name;
        photo.flags = {i == 2 ? "It is too dark." : "It was taken elsewhere."};
        photo.pose.isSolved = i != 2;
        report.photos.push_back(photo);
        if (i != 2) {
            store::SolvedPhoto solved;
            solved.photo = photo.photo;
            solved.positionM = stations[1 - i].station.positionM;
            solved.sigmaYawRad = 0.001 * static_cast<double>(i + 1);
            solved.quality = photo.quality;
            solution.photos.push_back(solved);
        }
    }
    solution.report = jobs::toJson(report).dump();
    store.addSolution(solution, true);
}

class AlignTest : public testing::Test {
  protected:
    void addFlagged() {
        session->write(SurveySession::Solutions,
                       [](store::SurveyStore& store) { addFlaggedSolution(store); });
    }

    std::int64_t photoAt(std::size_t station) const {
        const store::SurveyStore& store = session->store();
        return store.chosenPhoto(store.stations().at(station).id)->id;
    }

    bool waitForTasks() {
        return QTest::qWaitFor([&] { return !tasks.hasRunning(); }, 100'000);
    }

    test::PhotographedSurvey survey{4};
    TaskList tasks;
    std::unique_ptr<SurveySession> session =
        SurveySession::open(QString::fromStdString(survey.path().string()));
};

/// Without a window.
class AlignPresenterTest : public AlignTest {
  protected:
    AlignPresenterTest() { presenter.setSession(session.get()); }

    ~AlignPresenterTest() override { presenter.setSession(nullptr); }

    AlignPresenter presenter{tasks};
};

/// Through the widgets that people use.
class AlignModeTest : public AlignTest {
  protected:
    AlignModeTest() {
        mode.resize(1100, 700);
        mode.setSession(session.get());
        mode.show();
        mode.activated();
    }

    ~AlignModeTest() override { mode.setSession(nullptr); }

    template <class Widget>
    Widget& widget(const char* name) {
        return *mode.findChild<Widget*>(name);
    }

    void click(const char* button) { QTest::mouseClick(&widget<QPushButton>(button), Qt::LeftButton); }

    AlignMode mode{tasks};
};

} // namespace

TEST_F(AlignPresenterTest, SaysWhatTheSolutionIs) {
    addFlagged();
    EXPECT_TRUE(
        presenter.summary().text.startsWith("Alignment of 4 photo(s): 0 good, 2 doubtful, 1 failed."));
    EXPECT_TRUE(presenter.summary().text.contains("Because of the matches."));
}

TEST_F(AlignPresenterTest, TellsEachPhotosNumbersAndTheirOrder) {
    addFlagged();
    AlignModel& model = presenter.model();
    EXPECT_EQ(model.index(0, AlignModel::SigmaYaw).data().toString(), "0.057");
    EXPECT_EQ(model.index(2, AlignModel::SigmaYaw).data().toString(), "-");
    EXPECT_EQ(model.index(2, AlignModel::Proposal).data().toString(), "Retake");
    EXPECT_EQ(model.index(0, AlignModel::Reason).data().toString(), "It was taken elsewhere.");
    presenter.table().sort(AlignModel::SigmaYaw, Qt::DescendingOrder);
    EXPECT_EQ(presenter.table().index(2, 0).data(AlignModel::PhotoRole).toLongLong(), photoAt(1));
    presenter.table().sort(AlignModel::Verdict);
    EXPECT_EQ(presenter.table().index(0, 0).data(AlignModel::PhotoRole).toLongLong(), photoAt(2));
}

TEST_F(AlignPresenterTest, RetagsAndTakesItBack) {
    addFlagged();
    const std::int64_t first = photoAt(0);
    const std::int64_t second = photoAt(1);
    presenter.retagAll();
    ASSERT_TRUE(waitForTasks());
    ASSERT_TRUE(QTest::qWaitFor([&] { return session->undoStack()->count() == 1; }));
    EXPECT_EQ(photoAt(0), second);
    EXPECT_EQ(photoAt(1), first);
    EXPECT_TRUE(presenter.findings()->retags().empty());
    ASSERT_TRUE(QTest::qWaitFor([&] { return presenter.canRun(); }));
    session->undoStack()->undo();
    ASSERT_TRUE(QTest::qWaitFor([&] { return presenter.canRun(); }));
    EXPECT_EQ(photoAt(0), first);
    EXPECT_EQ(presenter.findings()->retags().size(), 2U);
}

TEST_F(AlignPresenterTest, SaysThatAnotherProgramWrites) {
    const auto other = survey.open(store::Access::Write);
    presenter.run({});
    ASSERT_TRUE(waitForTasks());
    EXPECT_TRUE(tasks.tasks().first()->sentence().contains("another program"));
    EXPECT_TRUE(presenter.canRun());
}

TEST_F(AlignModeTest, AlignsAndShowsHowEachPhotoIsTurned) {
    auto& effort = widget<QComboBox>("effort");
    effort.setCurrentIndex(effort.findData(static_cast<int>(align::Effort::Draft)));
    click("run");
    EXPECT_FALSE(widget<QPushButton>("run").isEnabled());
    EXPECT_TRUE(widget<QPushButton>("stop").isEnabled());
    ASSERT_TRUE(QTest::qWaitFor([&] { return widget<QPushButton>("run").isEnabled(); }, 100'000));
    const auto solution = session->store().activeSolution();
    ASSERT_EQ(solution->source, "align");
    EXPECT_EQ(session->store().solvedPhotos(solution->id).size(), 4U);
    EXPECT_EQ(widget<QTableView>("photos").model()->rowCount(), 4);
    EXPECT_TRUE(widget<QLabel>("summary").text().startsWith("Alignment of 4 photo(s):"));
}

TEST_F(AlignModeTest, StopsWithTheSurveyAsItWas) {
    const std::size_t before = session->store().solutions().size();
    click("run");
    click("stop");
    ASSERT_TRUE(QTest::qWaitFor([&] { return widget<QPushButton>("run").isEnabled(); }, 100'000));
    EXPECT_EQ(tasks.tasks().first()->state(), Task::State::Stopped);
    EXPECT_EQ(session->store().solutions().size(), before);
}

TEST_F(AlignModeTest, ListsOnlyPhotosWithAFlag) {
    addFlagged();
    session->write(SurveySession::Solutions, [&](store::SurveyStore& store) {
        store::NewSolution solution{"imported", "", "{}", {}};
        for (std::size_t i = 0; i < 4; ++i) {
            store::SolvedPhoto solved;
            solved.photo = photoAt(i);
            solved.quality = i == 1 ? survey::Quality::Doubtful : survey::Quality::Good;
            solution.photos.push_back(solved);
        }
        store.addSolution(solution, true);
    });
    auto& table = widget<QTableView>("photos");
    EXPECT_EQ(table.model()->rowCount(), 4);
    widget<QCheckBox>("onlyFlagged").setChecked(true);
    ASSERT_EQ(table.model()->rowCount(), 1);
    EXPECT_EQ(table.model()->index(0, 0).data(AlignModel::PhotoRole).toLongLong(), photoAt(1));
}

TEST_F(AlignModeTest, OffersWhatIsProposedForTheChosenPhoto) {
    addFlagged();
    auto& table = widget<QTableView>("photos");
    table.selectRow(2);
    EXPECT_FALSE(widget<QPushButton>("retag").isEnabled());
    EXPECT_TRUE(widget<QPushButton>("retake").isEnabled());
    EXPECT_EQ(widget<QLabel>("reason").text(), "It is too dark.");
    table.selectRow(0);
    EXPECT_TRUE(widget<QPushButton>("retag").isEnabled());
    EXPECT_EQ(session->selection()->current(), session->store().stations().at(0).id);
}

TEST_F(AlignModeTest, RejectsWhatIsToBeTakenAgain) {
    addFlagged();
    const std::int64_t third = photoAt(2);
    widget<QTableView>("photos").selectRow(2);
    click("retake");
    EXPECT_EQ(session->store().review(third).decision, store::Decision::Rejected);
    session->undoStack()->undo();
    EXPECT_EQ(session->store().review(third).decision, store::Decision::Open);
}

TEST_F(AlignModeTest, MovesTheChosenPhotoToTheStationThatFits) {
    addFlagged();
    const std::int64_t first = photoAt(0);
    widget<QTableView>("photos").selectRow(0);
    click("retag");
    ASSERT_TRUE(QTest::qWaitFor([&] { return photoAt(1) == first; }, 100'000));
    ASSERT_TRUE(waitForTasks());
}

TEST_F(AlignModeTest, ShowsUncertaintyAsHeatOnThePlan) {
    addFlagged();
    const auto& marks = widget<CoverageView>("headings").stations();
    EXPECT_NEAR(marks.at(0).heat.value(), 0.5, 1e-9);
    EXPECT_NEAR(marks.at(1).heat.value(), 1, 1e-9);
    EXPECT_FALSE(marks.at(2).heat.has_value());
}

TEST_F(AlignModeTest, ShowsTheStationThatIsChosenElsewhere) {
    addFlagged();
    session->selection()->setCurrent(session->store().stations().at(2).id);
    EXPECT_EQ(widget<QTableView>("photos").currentIndex().data(AlignModel::PhotoRole).toLongLong(),
              photoAt(2));
}

TEST_F(AlignModeTest, SaysOfMovedPhotosThatTheyAreToBeAlignedAgain) {
    addFlagged();
    ASSERT_TRUE(widget<QLabel>("summary").text().contains("2 doubtful"));
    click("retagAll");
    ASSERT_TRUE(waitForTasks());
    EXPECT_TRUE(widget<QLabel>("summary").text().contains("0 doubtful"))
        << widget<QLabel>("summary").text().toStdString();
    EXPECT_TRUE(widget<QLabel>("summary").text().contains("align again"));
    auto& table = widget<QTableView>("photos");
    QStringList reasons;
    for (int row = 0; row < table.model()->rowCount(); ++row) {
        reasons << table.model()->index(row, AlignModel::Reason).data().toString();
    }
    EXPECT_EQ(reasons.filter("Moved to this station").size(), 2);
    EXPECT_EQ(reasons.filter("taken elsewhere").size(), 0); // it was said of the place before
    session->undoStack()->undo();
    ASSERT_TRUE(waitForTasks());
    EXPECT_TRUE(widget<QLabel>("summary").text().contains("2 doubtful")); // as it was
}

TEST_F(AlignModeTest, WritesNumbersAsTheLanguageDoes) {
    QLocale::setDefault(QLocale("pl"));
    addFlagged();
    auto& table = widget<QTableView>("photos");
    const QString sigma = table.model()->index(0, AlignModel::SigmaYaw).data().toString();
    QLocale::setDefault(QLocale::c());
    EXPECT_EQ(sigma, "0,057");
}

TEST_F(AlignModeTest, KnowsWhatWasSaidOfTheCamera) {
    auto& height = widget<QDoubleSpinBox>("lensHeight");
    auto& rough = widget<QDoubleSpinBox>("positionSigma");
    session->write(SurveySession::Solutions, [](store::SurveyStore& store) {
        jobs::AlignReport report;
        report.positionSigmaM = 0.5;
        store.addSolution({"align", "position", jobs::toJson(report).dump(), {}}, true);
    });
    mode.setSession(session.get());
    EXPECT_EQ(rough.value(), 500);
    EXPECT_EQ(height.value(), session->state().options.heightsM.front());
    {
        const test::TemporaryFolder folder;
        survey::PlanOptions guess;
        guess.areHeightsGuessed = true;
        const std::filesystem::path path = folder / "walk.spherewalk";
        store::SurveyStore::create(path, "walk", survey::unknownRoom(), guess, {});
        const auto walk = SurveySession::open(QString::fromStdString(path.string()));
        mode.setSession(walk.get());
        EXPECT_EQ(height.text(), "not known");
        EXPECT_EQ(rough.value(), 5);
        mode.setSession(session.get());
    }
    EXPECT_EQ(height.value(), session->state().options.heightsM.front());
}

TEST(AlignWithoutPositions, SolvesWherePhotosWereTaken) {
    const test::TemporaryFolder folder;
    test::writeHandHeldPhotos(folder / "in");
    const std::filesystem::path path = test::makeSurvey(folder / "flat.spherewalk");
    {
        auto store = store::SurveyStore::open(path, store::Access::Write);
        jobs::importPhotos(store, {folder / "in", {}}, noProgress(), {});
    }
    const auto session = SurveySession::open(QString::fromStdString(path.string()));
    ASSERT_TRUE(session->state().hasUnknownPlaces());
    TaskList tasks;
    AlignMode mode(tasks);
    mode.setSession(session.get());
    EXPECT_EQ(mode.findChild<QComboBox*>("places")->currentText(), "From the pictures alone");
    EXPECT_EQ(mode.findChild<QComboBox*>("effort")->currentText(), "Fine");
    EXPECT_TRUE(mode.findChild<QComboBox*>("model")->isHidden());
    EXPECT_TRUE(mode.findChild<QDoubleSpinBox*>("positionSigma")->isHidden());
    auto* height = mode.findChild<QDoubleSpinBox*>("lensHeight");
    EXPECT_EQ(height->value(), session->state().options.heightsM.front());
    height->setValue(2.4);
    mode.show();
    QTest::mouseClick(mode.findChild<QPushButton*>("run"), Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !tasks.hasRunning(); }, 100'000));
    EXPECT_FALSE(session->state().hasUnknownPlaces());
    EXPECT_EQ(session->state().counts.photos, 6);
    ASSERT_TRUE(session->state().findings);
    EXPECT_EQ(session->state().findings->photos.size(), 6U);
    EXPECT_TRUE(session->state().findings->isFree);
    EXPECT_NE(session->state().findings->reason.find("2.40 m"), std::string::npos);
    EXPECT_NEAR(session->state().stations.back().station.positionM.z(), 2.4, 0.1);
    EXPECT_EQ(mode.findChild<QComboBox*>("places")->currentIndex(), 1);
    mode.setSession(session.get()); // opened again
    EXPECT_EQ(mode.findChild<QComboBox*>("places")->currentIndex(), 1);
    mode.setSession(nullptr);
    EXPECT_EQ(mode.findChild<QComboBox*>("places")->currentIndex(), 0);
    EXPECT_EQ(mode.findChild<QComboBox*>("effort")->currentText(), "Normal");
    EXPECT_FALSE(mode.findChild<QComboBox*>("model")->isHidden());
    EXPECT_TRUE(height->isHidden());
}

} // namespace spherewalk::ui
