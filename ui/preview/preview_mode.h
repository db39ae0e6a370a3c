// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/frame/mode.h"

#include <vector>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QPushButton;

namespace spherewalk::render {
class Dataset;
}

namespace spherewalk::ui {

class CameraBox;
class DriveView;
class PreviewPresenter;
class RobotMap;
class TaskList;
class ToldLabel;
struct ViewSide;

/// The page where a person drives a robot through a dataset, as a simulator would.
class PreviewMode : public Mode {
    Q_OBJECT

  public:
    explicit PreviewMode(TaskList& tasks, QWidget* parent = nullptr);

    void setSession(SurveySession* session) override;
    void activated() override;

    bool worksWithoutSurvey() const override { return true; }

    Subject subject() const override;
    QList<Key> keys() const override;

    /// Opens the dataset in the folder of this name.
    void showPart(const QString& part) override;

    PreviewPresenter& presenter() { return *m_presenter; }

  private:
    /// The boxes that choose how one of the compared views is made.
    struct SideChoice {
        QComboBox* scene = nullptr;
        QComboBox* sampling = nullptr;
    };

    QWidget* makeBar();
    QWidget* makeControls();
    SideChoice makeSide(const QString& name, QGridLayout& grid, int row);
    void makeOtherCamera(QGridLayout& grid, int row);
    void makeOverlays(QGridLayout& grid, int row);
    void chooseDataset();
    void chooseFolder();
    void chooseRobotPictures();
    void showDataset();
    void showViews();
    void showRecording();
    void showRungs();
    void takeMeasured();
    void applyMount();
    void applySides();
    void placeRobot(const QPointF& pInRoom, Qt::KeyboardModifiers modifiers);
    void aimRobot(const QPointF& pInRoom, Qt::KeyboardModifiers modifiers);

    PreviewPresenter* m_presenter;
    DriveView* m_view = nullptr;
    RobotMap* m_map = nullptr;
    QPushButton* m_make = nullptr;
    const render::Dataset* m_shownDataset = nullptr; ///< The one whose measured choice was taken.
    QCheckBox* m_depth = nullptr;
    ToldLabel* m_what = nullptr;
    QLabel* m_rate = nullptr;
    CameraBox* m_camera = nullptr;
    QDoubleSpinBox* m_height = nullptr;
    QDoubleSpinBox* m_pitch = nullptr;
    QCheckBox* m_split = nullptr;
    QCheckBox* m_otherCamera = nullptr;
    CameraBox* m_cameraB = nullptr;
    std::vector<SideChoice> m_sides;
    QPushButton* m_record = nullptr;
    QPushButton* m_save = nullptr;
    QPushButton* m_own = nullptr;
};

} // namespace spherewalk::ui
