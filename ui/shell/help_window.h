// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QString>

class QTextBrowser;
class QUrl;

namespace spherewalk::ui {

/// The guide of the program, which it carries inside, and the list of keys.
class HelpWindow : public QDialog {
    Q_OBJECT

  public:
    explicit HelpWindow(QWidget* parent = nullptr);

    /// Shows the part of the guide for the page of this name; the beginning for any other name.
    void showPage(const QString& page);
    /// Shows a text in Markdown.
    void showText(const QString& markdown);

    /// Returns the heading that stands at the top.
    QString heading() const { return m_heading; }

  private:
    bool showFile(const QString& name);
    void goTo(const QString& heading);
    void follow(const QUrl& link);

    QTextBrowser* m_text;
    QString m_file; ///< The file of the guide that is shown; empty for another text.
    QString m_heading;
};

} // namespace spherewalk::ui
