// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QWidget>

class QAction;
class QCheckBox;
class QPushButton;

namespace spherewalk::ui {

class PanoramaView;
class ReviewPresenter;
class TaskBar;

/// Marks and removes private regions of the photo that a viewer shows, which exports blur. The viewer shows
/// them as exports do, if that is wanted.
class RegionBar : public QWidget {
    Q_OBJECT

  public:
    RegionBar(ReviewPresenter& presenter, PanoramaView& viewer, QWidget* parent = nullptr);

    /// Hides a region of the photo, or leaves the tool. It is the caller's to add, for its key.
    QAction* hideAction() { return m_hide; }

  private:
    void begin(bool isMarking);
    void showState();

    ReviewPresenter& m_presenter;
    PanoramaView& m_viewer;
    QAction* m_hide;
    QPushButton* m_remove;
    QCheckBox* m_asExported;
};

/// Starts the search for faces, and shows how far it is.
class FaceSearchBar : public QWidget {
    Q_OBJECT

  public:
    explicit FaceSearchBar(ReviewPresenter& presenter, QWidget* parent = nullptr);

  private:
    void showState();

    ReviewPresenter& m_presenter;
    QPushButton* m_search;
    TaskBar* m_progress;
};

/// Tells what became of the current photo, if that is wanted.
class StoryLabel : public QLabel {
    Q_OBJECT

  public:
    explicit StoryLabel(ReviewPresenter& presenter, QWidget* parent = nullptr);

    void setWanted(bool isWanted);

  private:
    void showState();
    QString story() const;

    ReviewPresenter& m_presenter;
    bool m_isWanted = false;
};

} // namespace spherewalk::ui
