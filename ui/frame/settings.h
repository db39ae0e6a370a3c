// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/look/theme.h"

#include <QByteArray>
#include <QStringList>

namespace spherewalk::ui {

/// What the program remembers between runs.
class Settings {
  public:
    static constexpr int kMostRecent = 10;

    /// Folders of surveys, the latest first; those that are gone are left out.
    QStringList recentSurveys() const;
    void addRecentSurvey(const QString& folder);

    Theme theme() const;
    void setTheme(Theme theme);

    QByteArray windowGeometry() const;
    QByteArray windowState() const;
    void setWindow(const QByteArray& geometry, const QByteArray& state);

    /// report.json of the dataset of this survey that was measured last; empty if there is none any more.
    QString measuredReport(const QString& surveyId) const;
    /// Empty: forgets it.
    void setMeasuredReport(const QString& surveyId, const QString& file);

    /// Language code, "pl"; empty: the system's.
    QString language() const;
    void setLanguage(const QString& language);
};

} // namespace spherewalk::ui
