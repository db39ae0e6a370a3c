// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/frame/mode.h"

#include <functional>

class QCheckBox;
class QComboBox;
class QLineEdit;
class QPushButton;
class QUrl;

namespace spherewalk::ui {

class CameraBox;
class ExportPresenter;
class MeasurePresenter;
class PagePresenter;
class PlacePresenter;
class TaskBar;
class TaskList;
class ToldLabel;
class ToleranceBox;

/// The page that exports the survey as a dataset and measures it.
class ExportMode : public Mode {
    Q_OBJECT

  public:
    explicit ExportMode(TaskList& tasks, QWidget* parent = nullptr);

    void setSession(SurveySession* session) override;
    void activated() override;
    /// Puts the focus on the dataset's folder ("folder") or on the choice of the scene model ("scene").
    void showPart(const QString& part) override;

    bool wantsPlan() const override { return true; }

    /// Replaces the desktop's file manager, for tests.
    void setOpener(std::function<bool(const QUrl&)> opener) { m_open = std::move(opener); }

  private:
    QWidget* makeWhere();
    QWidget* makeTolerance(QWidget* parent);
    QWidget* makeBefore();
    QWidget* makeAfter();
    void chooseFolder();
    void proposeScene();
    void applyOptions();
    void showTolerance(bool isWanted);
    void open(const QString& path);
    void showAll();
    void showFound();
    void showTask();

    ExportPresenter* m_presenter;
    MeasurePresenter* m_measure;
    PlacePresenter* m_place;
    PagePresenter* m_page;
    std::function<bool(const QUrl&)> m_open;
    QLineEdit* m_folder = nullptr;
    QComboBox* m_scene = nullptr;
    QWidget* m_wanted = nullptr;
    CameraBox* m_camera = nullptr;
    ToleranceBox* m_tolerance = nullptr;
    QComboBox* m_markers = nullptr;
    QCheckBox* m_opens = nullptr;
    ToldLabel* m_amount = nullptr;
    ToldLabel* m_findings = nullptr;
    bool m_isSceneChosen = false; ///< Somebody has chosen the scene model.
    QPushButton* m_review = nullptr;
    QPushButton* m_check = nullptr;
    QPushButton* m_export = nullptr;
    TaskBar* m_progress = nullptr;
    ToldLabel* m_result = nullptr;
    QPushButton* m_openButton = nullptr;
    QString m_opened; ///< Folder that has been opened after its export.
};

} // namespace spherewalk::ui
