// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <deque>
#include <optional>
#include <stop_token>
#include <string_view>

namespace spherewalk {

/// A long job reports its progress here. Threads: calls come from any thread of the job, one at a time.
class ProgressSink {
  public:
    virtual ~ProgressSink() = default;

    /// `fraction` is the share that is done; it lies in [0, 1] and never decreases. `activity` tells people
    /// what the job does now.
    virtual void progress(double fraction, std::string_view activity) = 0;
    /// Takes a sentence that a person should read although the job goes on.
    virtual void warning(std::string_view sentence) = 0;
};

/// A sink that ignores everything.
ProgressSink& noProgress();

/// One step of a job. Its fractions [0, 1] become the interval [begin, end] of the parent's.
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

/// Estimates how long a job will still take. The pace is that of the later half of the time so far, so that
/// work which a resumed job found done hardly counts.
class TimeLeft {
  public:
    using TimePoint = std::chrono::steady_clock::time_point;

    explicit TimeLeft(TimePoint start) : m_start(start), m_seen{{start, 0}} {}

    /// The time that the rest will take. There is no estimate before one percent or one second, or while half
    /// of the time gains less than 0.5 %. Calls must be in the order of time; many make the estimate better.
    std::optional<std::chrono::duration<double>> at(TimePoint now, double fraction);

  private:
    struct Seen {
        TimePoint at;
        double fraction;
    };

    TimePoint m_start;
    std::deque<Seen> m_seen; ///< Oldest first. The first one is the last of the earlier half of the time.
};

/// Throws Error{Stopped} if a stop was requested. Long jobs call it at every photo, tile, iteration and
/// network tick.
void throwIfStopped(const std::stop_token& stop);

} // namespace spherewalk
