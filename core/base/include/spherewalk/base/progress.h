// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <deque>
#include <optional>
#include <stop_token>
#include <string_view>

namespace spherewalk {

/// Where a long job says how far it is. Threads: a sink may be called from any thread of the job, one at a
/// time.
class ProgressSink {
  public:
    virtual ~ProgressSink() = default;

    /// fraction: done so far, in [0, 1], never decreasing; activity: what is being done, for people.
    virtual void progress(double fraction, std::string_view activity) = 0;
    /// Something that a person should read although the job goes on.
    virtual void warning(std::string_view sentence) = 0;
};

/// A sink that ignores everything, for callers who do not watch.
ProgressSink& noProgress();

/// One step of a job: its own [0, 1] is the interval [begin, end] of the whole job's.
class ProgressStep : public ProgressSink {
  public:
    /// Owner: the parent must outlive the step.
    ProgressStep(ProgressSink& parent, double begin, double end);

    void progress(double fraction, std::string_view activity) override;
    void warning(std::string_view sentence) override;

  private:
    ProgressSink& m_parent;
    double m_begin;
    double m_end;
    double m_reached = 0;
};

/// Estimates the time left of a job from the fractions seen so far. What a job found done already, when it is
/// resumed, hardly counts: the pace is that of the later half of the time.
class TimeLeft {
  public:
    using TimePoint = std::chrono::steady_clock::time_point;

    explicit TimeLeft(TimePoint start) : m_start(start), m_seen{{start, 0}} {}

    /// The time that the rest will take; nothing before one percent or one second, or while nothing moves.
    /// Calls are in the order of time; the more of them, the sooner the pace is right.
    std::optional<std::chrono::duration<double>> at(TimePoint now, double fraction);

  private:
    struct Seen {
        TimePoint at;
        double fraction;
    };

    TimePoint m_start;
    std::deque<Seen> m_seen; ///< oldest first; the first is the last one of the earlier half of the time
};

/// Throws Error{Stopped} if a stop was asked for; call it at every photo, tile, iteration and network tick.
void throwIfStopped(const std::stop_token& stop);

} // namespace spherewalk
