// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/look/theme.h"

#include <QByteArray>
#include <QStringList>

namespace spherewalk::ui {

/// What the program remembers between runs. Each call reads or writes QSettings.
class Settings {
  public:
    static constexpr int kMostRecent = 10;

    /// Returns the folders of the surveys that were opened last, the latest first. Folders without a survey
    /// are left out.
    QStringList recentSurveys() const;
    /// Puts a folder in front; the list keeps kMostRecent.
    void addRecentSurvey(const QString& folder);

    Theme theme() const;
    void setTheme(Theme theme);

    QByteArray windowGeometry() const;
    QByteArray windowState() const;
    void setWindow(const QByteArray& geometry, const QByteArray& state);

    /// Returns the report.json that was measured last for this survey; empty if there is no such file.
    QString measuredReport(const QString& surveyId) const;
    /// An empty file name forgets the report.
    void setMeasuredReport(const QString& surveyId, const QString& file);

    /// Returns a language code as "pl"; empty: the language of the system.
    QString language() const;
    void setLanguage(const QString& language);
};

} // namespace spherewalk::ui
