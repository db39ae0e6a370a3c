// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/frame/settings.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>

namespace spherewalk::ui {

namespace {

constexpr auto kRecent = "recentSurveys";
constexpr auto kTheme = "window/theme";
constexpr auto kGeometry = "window/geometry";
constexpr auto kState = "window/state";
constexpr auto kLanguage = "language";
constexpr auto kMeasured = "measuredReports/";

} // namespace

QStringList Settings::recentSurveys() const {
    QStringList folders = QSettings().value(kRecent).toStringList();
    folders.removeIf([](const QString& folder) { return !QFileInfo::exists(folder + "/survey.sqlite"); });
    return folders;
}

void Settings::addRecentSurvey(const QString& folder) {
    const QString path = QDir(folder).absolutePath();
    QStringList folders = recentSurveys();
    folders.removeAll(path);
    folders.prepend(path);
    QSettings().setValue(kRecent, QStringList(folders.mid(0, kMostRecent)));
}

Theme Settings::theme() const {
    const QString name = QSettings().value(kTheme).toString();
    return name == "light" ? Theme::Light : name == "dark" ? Theme::Dark : Theme::System;
}

void Settings::setTheme(Theme theme) {
    QSettings().setValue(kTheme, theme == Theme::Light ? "light" : theme == Theme::Dark ? "dark" : "system");
}

QByteArray Settings::windowGeometry() const {
    return QSettings().value(kGeometry).toByteArray();
}

QByteArray Settings::windowState() const {
    return QSettings().value(kState).toByteArray();
}

void Settings::setWindow(const QByteArray& geometry, const QByteArray& state) {
    QSettings().setValue(kGeometry, geometry);
    QSettings().setValue(kState, state);
}

QString Settings::measuredReport(const QString& surveyId) const {
    const QString file = QSettings().value(kMeasured + surveyId).toString();
    return QFileInfo::exists(file) ? file : QString();
}

void Settings::setMeasuredReport(const QString& surveyId, const QString& file) {
    if (file.isEmpty()) {
        return QSettings().remove(kMeasured + surveyId);
    }
    QSettings().setValue(kMeasured + surveyId, QFileInfo(file).absoluteFilePath());
}

QString Settings::language() const {
    return QSettings().value(kLanguage).toString();
}

void Settings::setLanguage(const QString& language) {
    QSettings().setValue(kLanguage, language);
}

} // namespace spherewalk::ui
