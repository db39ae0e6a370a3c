// SPDX-License-Identifier: GPL-3.0-or-later
#include "qt_application.h"
#include "temporary_folder.h"
#include "test_dataset.h"
#include "ui/export/place_panel.h"

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

namespace spherewalk::ui {

namespace fs = std::filesystem;

namespace {

class PlaceTest : public testing::Test {
  protected:
    PlaceTest() { panel.show(); }

    template <class Widget>
    Widget& widget(const char* name) {
        return *panel.findChild<Widget*>(name);
    }

    void click(QAbstractButton& button) {
        QTest::mouseClick(&button, Qt::LeftButton, {}, {8, button.height() / 2});
    }

    void write() {
        click(widget<QPushButton>("placeNow"));
        ASSERT_TRUE(QTest::qWaitFor([&] { return !tasks.hasRunning(); }, 100'000));
        QCoreApplication::processEvents();
    }

    QString words() { return widget<QLabel>("placeWords").text(); }

    test::TemporaryFolder folder;
    fs::path dataset = folder / "kitchen.dataset";
    TaskList tasks;
    PlacePresenter presenter{tasks};
    PlacePanel panel{presenter};
};

} // namespace

TEST_F(PlaceTest, WritesTheChosenFormatsBesideTheDataset) {
    test::writeEmptyRoom(dataset);
    presenter.setDataset(QString::fromStdString(dataset.string()));
    EXPECT_FALSE(widget<QPushButton>("openPlace").isVisible());
    click(widget<QCheckBox>("ply"));
    click(widget<QCheckBox>("occupancy"));
    write();
    const fs::path place = folder / "kitchen.place";
    for (const char* file : {"surface.glb", "surface.ply", "map.pgm", "map.yaml", "report.json"}) {
        EXPECT_TRUE(fs::exists(place / file)) << file;
    }
    EXPECT_FALSE(fs::exists(place / "surface.obj"));
    EXPECT_TRUE(words().contains("the rest are holes")) << words().toStdString();
    QSignalSpy opened(&panel, &PlacePanel::openRequested);
    click(widget<QPushButton>("openPlace"));
    EXPECT_EQ(opened.at(0).at(0).toString().toStdString(), place.string());
    write();
    EXPECT_TRUE(fs::exists(folder / "kitchen-2.place")) << "the first stays";
}

TEST_F(PlaceTest, NeedsAFormat) {
    test::writeEmptyRoom(dataset);
    presenter.setDataset(QString::fromStdString(dataset.string()));
    EXPECT_TRUE(widget<QPushButton>("placeNow").isEnabled());
    click(widget<QCheckBox>("gltf"));
    EXPECT_FALSE(widget<QPushButton>("placeNow").isEnabled());
}

TEST_F(PlaceTest, NeedsDepths) {
    EXPECT_FALSE(widget<QPushButton>("placeNow").isEnabled());
    EXPECT_TRUE(words().contains("depths of two photos"));
    render::DatasetInfo info = test::writeEmptyRoom(dataset);
    for (render::DatasetPhoto& photo : info.photos) {
        photo.depth.clear();
    }
    test::rewriteInfo(dataset, info);
    presenter.setDataset(QString::fromStdString(dataset.string()));
    EXPECT_FALSE(widget<QPushButton>("placeNow").isEnabled());
    EXPECT_TRUE(words().contains("depths of two photos"));
}

TEST_F(PlaceTest, LeavesNothingWhenItIsStopped) {
    test::writeEmptyRoom(dataset);
    presenter.setDataset(QString::fromStdString(dataset.string()));
    click(widget<QPushButton>("placeNow"));
    ASSERT_NE(presenter.task(), nullptr);
    presenter.task()->stop();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !tasks.hasRunning(); }, 100'000));
    QCoreApplication::processEvents();
    EXPECT_TRUE(words().contains("nothing was written")) << words().toStdString();
    EXPECT_FALSE(fs::exists(folder / "kitchen.place"));
}

TEST_F(PlaceTest, SaysWhatIsWrongWithADataset) {
    fs::create_directories(dataset);
    writeFile(dataset / "dataset.json", bytesOf("{"));
    presenter.setDataset(QString::fromStdString(dataset.string()));
    EXPECT_FALSE(widget<QPushButton>("placeNow").isEnabled());
    EXPECT_TRUE(words().contains("dataset.json")) << words().toStdString();
}

} // namespace spherewalk::ui
