// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tasks/background_worker.h"

#include "spherewalk/geometry/polygon.h"

#include <QImage>
#include <QListWidget>
#include <QString>

namespace spherewalk::ui {

/// What the first page tells of a survey.
struct SurveySummary {
    int photos = 0;
    int stations = 0;
    QImage picture; ///< Outline and stations of the plan; the stations with a photo are filled.
};

/// Reads the survey in this folder. Errors: those of the store. Threads: any.
SurveySummary summaryOf(const QString& folder);

/// The surveys that were opened last, each with its folder, its progress and a picture. What a survey holds
/// is read in the background.
class RecentSurveys : public QListWidget {
    Q_OBJECT

  public:
    explicit RecentSurveys(QWidget* parent = nullptr);

    /// Lists these folders, the latest first.
    void list(const QStringList& folders);

  private:
    void fill(const QString& folder, const SurveySummary& summary);

    BackgroundWorker m_worker; ///< The last member, as its results use the list.
};

} // namespace spherewalk::ui
