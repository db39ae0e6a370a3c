// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <fstream>

namespace spherewalk::test {

/// The longest gap that a test lets pass: twice what is wanted on a quiet machine. What is done for the first
/// time loads fonts and pictures, so that it is done once before it is measured.
inline constexpr double kMostHeldMs = 100;

/// This thread's own processor time, which a busy machine hardly adds to.
inline double ownProcessorMs() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

/// Measures how long the event loop of this thread is not served: the longest time between two beats of a
/// timer that asks for one at every chance. The time for which the thread was ready and the processor gave it
/// no turn is left out, as that is the machine's load and not the program's doing.
class EventLoopGap {
  public:
    EventLoopGap() {
        m_timer.setTimerType(Qt::PreciseTimer);
        start();
        QObject::connect(&m_timer, &QTimer::timeout, &m_timer, [this] {
            const double waitedMs = static_cast<double>(waitedNs() - m_waitedNs) / 1e6;
            m_longestMs = std::max(m_longestMs, static_cast<double>(m_clock.nsecsElapsed()) / 1e6 - waitedMs);
            m_longestBusyMs = std::max(m_longestBusyMs, ownProcessorMs() - m_ranMs);
            ++m_beats;
            start();
        });
        m_timer.start(1);
    }

    double longestMs() const { return m_longestMs; }

    /// The same in ownProcessorMs(), which does not see waits.
    double longestBusyMs() const { return m_longestBusyMs; }

    int beats() const { return m_beats; }

  private:
    void start() {
        m_waitedNs = waitedNs();
        m_ranMs = ownProcessorMs();
        m_clock.start();
    }

    /// By this thread for a processor, as Linux counts it; 0 where it does not.
    static std::int64_t waitedNs() {
        std::ifstream counts("/proc/thread-self/schedstat");
        std::int64_t ran = 0;
        std::int64_t waited = 0;
        return counts >> ran >> waited ? waited : 0;
    }

    QTimer m_timer;
    QElapsedTimer m_clock;
    std::int64_t m_waitedNs = 0;
    double m_ranMs = 0;
    double m_longestMs = 0;
    double m_longestBusyMs = 0;
    int m_beats = 0;
};

/// By how much work(gap) holds this thread's event loop. Of up to three goes the shortest counts: a disk that
/// others use holds a program up now and then, what the program does itself holds it up each time.
template <class Work>
double heldMs(const Work& work) {
    double least = HUGE_VAL;
    for (int go = 0; go < 3 && least >= kMostHeldMs; ++go) {
        const EventLoopGap gap;
        work(gap);
        least = std::min(least, gap.longestMs());
    }
    return least;
}

} // namespace spherewalk::test
