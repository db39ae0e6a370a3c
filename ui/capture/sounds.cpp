// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/capture/sounds.h"

#include <QApplication>
#include <QTimer>

#include <chrono>

namespace spherewalk::ui {

void BellSounds::play(Verdict verdict) {
    constexpr std::chrono::milliseconds kBetween{250};
    const int times = verdict == Verdict::Good       ? 1
                      : verdict == Verdict::Doubtful ? 2
                      : verdict == Verdict::Failed   ? 3
                                                     : 0;
    for (int i = 0; i < times; ++i) {
        QTimer::singleShot(i * kBetween, qApp, [] { QApplication::beep(); });
    }
}

void BellSounds::tick() {
    QApplication::beep();
}

} // namespace spherewalk::ui
