// SPDX-License-Identifier: GPL-3.0-or-later
#include "person.h"
#include "photographed_survey.h"
#include "ui/align/align_mode.h"
#include "ui/export/export_mode.h"
#include "ui/preview/preview_mode.h"
#include "ui/preview/preview_presenter.h"

#include "spherewalk/geometry/trajectory.h"
#include "spherewalk/render/dataset.h"

#include <set>

namespace spherewalk::ui {

namespace fs = std::filesystem;

namespace {

/// A window with a survey, some of whose stations have photos, and what stands beside that survey.
struct Scene {
    test::PhotographedSurvey survey{4};
    Person person;

    Scene() { person.window().openSurvey(QString::fromStdString(survey.path().string())); }
};

/// Something that the window is busy with when it is closed.
struct Work {
    const char* name;
    std::function<void(Scene&)> begin;
    /// What is on the disk once the window is closed.
    std::function<void(const Scene&)> check;
    bool isTask = true;
};

void PrintTo(const Work& work, std::ostream* out) {
    *out << work.name;
}

void beginCapture(Scene& scene) {
    Person& person = scene.person;
    person.choose("Capture");
    person.press("practiceCamera");
    person.agree();
    person.waitFor(CaptureDesk::State::Ready);
    person.press("automatic");
    const int left = person.page<CaptureMode>().desk().stationsLeft();
    person.press("shutter");
    person.waitUntil([&] { return person.page<CaptureMode>().desk().stationsLeft() < left; });
}

void checkCapture(const Scene& scene) {
    EXPECT_GT(scene.survey.open().counts().photos, 4);
}

void beginAlign(Scene& scene) {
    scene.person.choose("Align");
    scene.person.press("run");
}

void checkAlign(const Scene& scene) {
    const store::SurveyStore store = scene.survey.open();
    EXPECT_EQ(store.solvedPhotos(store.activeSolution()->id).size(), 4U); // the import's, or a whole new one
}

void beginExport(Scene& scene) {
    scene.person.choose("Export");
    scene.person.press("export");
}

void checkExport(const Scene& scene) {
    std::set<std::string> beside;
    for (const auto& entry : fs::directory_iterator(scene.survey.path().parent_path())) {
        beside.insert(entry.path().filename().string());
    }
    if (beside.erase("room.dataset") > 0) { // it was quicker
        EXPECT_EQ(render::Dataset::open(scene.survey / "room.dataset").info().photos.size(), 4U);
    }
    EXPECT_EQ(beside, (std::set<std::string>{"in", "p.csv", "room.spherewalk"}));
}

void beginRecording(Scene& scene) {
    Person& person = scene.person;
    person.choose("Preview");
    person.press("withDepth"); // not for this test
    person.press("make");
    PreviewPresenter& presenter = person.page<PreviewMode>().presenter();
    person.waitUntil([&] { return presenter.dataset() != nullptr; });
    person.waitForTasks(); // what made the dataset may still be ending
    person.press("record");
    presenter.drive({.turnLeft = 1});
    person.waitUntil([&] { return presenter.path().size() >= 8; });
    presenter.drive({});
}

void checkRecording(const Scene& /*scene*/) {
    EXPECT_GE(readTum(PreviewPresenter::keptPath()).size(), 8U);
}

void beginSaving(Scene& scene) {
    beginRecording(scene);
    Person& person = scene.person;
    person.press("record");
    fs::create_directories(scene.survey / "frames");
    person.answer(QString::fromStdString((scene.survey / "frames").string()));
    person.press("save");
}

void checkSaving(const Scene& scene) {
    EXPECT_GE(readTum(scene.survey / "frames" / "path.tum").size(), 8U); // all frames can be made from it
    for (const auto& entry : fs::directory_iterator(scene.survey / "frames")) {
        if (entry.path().extension() == ".png") {
            EXPECT_FALSE(QImage(QString::fromStdString(entry.path().string())).isNull()) << entry.path();
        }
    }
}

class ClosingTest : public testing::TestWithParam<Work> {};

} // namespace

TEST_P(ClosingTest, InTheMiddleLosesNothing) {
    Scene scene;
    GetParam().begin(scene);
    EXPECT_EQ(scene.person.window().tasks().hasRunning(), GetParam().isTask);
    scene.person.window().close();
    EXPECT_FALSE(scene.person.window().tasks().hasRunning());
    EXPECT_TRUE(
        scene.survey.open(store::Access::Write).check(noProgress(), {}).isSound()); // the lock is free
    GetParam().check(scene);
}

INSTANTIATE_TEST_SUITE_P(Window, ClosingTest,
                         testing::Values(Work{"Capture", beginCapture, checkCapture},
                                         Work{"Align", beginAlign, checkAlign},
                                         Work{"Export", beginExport, checkExport},
                                         Work{"Record", beginRecording, checkRecording, false},
                                         Work{"SaveFrames", beginSaving, checkSaving}),
                         [](const auto& work) { return work.param.name; });

} // namespace spherewalk::ui
