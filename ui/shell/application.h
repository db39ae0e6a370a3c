// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QApplication>
#include <QTranslator>

namespace spherewalk::ui {

/// The program: its name, language and looks. An error that reaches the event loop becomes a sentence, not
/// the end of the program.
class Application : public QApplication {
    Q_OBJECT

  public:
    Application(int& argc, char** argv);

    bool notify(QObject* receiver, QEvent* event) override;

  signals:
    void problem(const QString& sentence);

  private:
    void translate();

    QTranslator m_own;
    QTranslator m_qt;
};

/// Loads the program's words in this language; English, with its plurals, where there is no better.
bool loadWords(QTranslator& translator, const QLocale& locale);

} // namespace spherewalk::ui
