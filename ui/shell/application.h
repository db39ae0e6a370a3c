// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QApplication>
#include <QTranslator>

namespace spherewalk::ui {

/// The Qt application with the name, language and theme of the program. An error that reaches the event loop
/// becomes problem() and does not end the program.
class Application : public QApplication {
    Q_OBJECT

  public:
    Application(int& argc, char** argv);

    bool notify(QObject* receiver, QEvent* event) override;

  signals:
    /// An error has reached the event loop; the sentence says what failed.
    void problem(const QString& sentence);

  private:
    void translate();

    QTranslator m_own;
    QTranslator m_qt;
};

/// Loads the words of the program in this language, or in English. Returns whether it found words.
bool loadWords(QTranslator& translator, const QLocale& locale);

} // namespace spherewalk::ui
