// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/base/statistics.h"
#include "spherewalk/bench/bench_report.h"
#include "spherewalk/jpeg/region.h"

#include <chrono>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace spherewalk::bench {

/// Median and deviation. Range: at least one time.
Measured measured(const std::vector<double>& timesMs);

double millisecondsSince(std::chrono::steady_clock::time_point begin);

/// Collects the times that the reports of views give.
class PartsOfViews {
  public:
    void add(const render::ViewReport& report) {
        m_drawMs.push_back(report.renderMs);
        m_decodeMs.push_back(report.decodeMs);
    }

    /// Range: at least one view.
    ViewParts median() const { return {quantile(m_drawMs, 0.5), quantile(m_decodeMs, 0.5)}; }

  private:
    std::vector<double> m_drawMs;
    std::vector<double> m_decodeMs;
};

/// Times several actions in turns, so that other load of the machine meets all of them alike.
class Contest {
  public:
    /// action: the work that is timed; its argument counts its runs from 0.
    void add(std::string name, std::function<void(int run)> action);

    /// Times each action `rounds` times. The actions take turns after `block` runs, so that each finds the
    /// caches as its own runs left them. The first block of each action does not count. Errors: Stopped,
    /// between two runs; those of the actions.
    void run(int rounds, int block, ProgressSink& progress, std::string_view activity,
             const std::stop_token& stop);

    /// Errors: Internal if nothing has this name.
    const Measured& of(const std::string& name) const;

  private:
    struct Entry {
        std::string name;
        std::function<void(int)> action;
        std::vector<double> timesMs;
        Measured result;
    };

    static void time(Entry& entry, int begin, int end, bool counts, const std::stop_token& stop);

    std::vector<Entry> m_entries;
};

// The checks that a result must pass before it is timed, because a wrong result may take no time at all.
// Errors: Internal, with `what` as the subject of the sentence.

/// Mean absolute difference of the values, in grey levels; infinity for pictures of different sizes.
double meanDifference(const RgbImage& a, const RgbImage& b);

/// Requires that the mean difference is at most mostGreyLevels.
void requireAlike(const RgbImage& picture, const RgbImage& expected, double mostGreyLevels,
                  std::string_view what);

void requireSame(const RgbImage& picture, const RgbImage& expected, std::string_view what);

/// Requires that the part equals the region of the whole picture, byte by byte.
void requirePart(const RgbImage& part, const jpeg::PixelRect& region, const RgbImage& whole,
                 std::string_view what);

/// The same for samples as the JPEG stores them. Range: the region begins and ends between chroma samples.
void requirePart(const jpeg::Planes& part, const jpeg::PixelRect& region, const jpeg::Planes& whole,
                 std::string_view what);

} // namespace spherewalk::bench
