// SPDX-License-Identifier: GPL-3.0-or-later
#include "contest.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <utility>

namespace spherewalk::bench {

using SteadyClock = std::chrono::steady_clock;

namespace {

[[noreturn]] void refuse(std::string_view what, const std::string& how) {
    throw Error(ErrorKind::Internal, text("Nothing was timed, since ", what, " is not what it should be: ",
                                          how, "; please report this, with the dataset."));
}

template <class Picture>
bool hasPart(const Picture& part, const jpeg::PixelRect& region, const Picture& whole) {
    if (part.width() != region.width || part.height() != region.height ||
        region.x + region.width > whole.width() || region.y + region.height > whole.height()) {
        return false;
    }
    for (int y = 0; y < region.height; ++y) {
        if (!std::equal(part.row(y).begin(), part.row(y).end(), whole.at(region.x, region.y + y))) {
            return false;
        }
    }
    return true;
}

} // namespace

Measured measured(const std::vector<double>& timesMs) {
    const double median = quantile(timesMs, 0.5);
    std::vector<double> deviations;
    deviations.reserve(timesMs.size());
    for (const double time : timesMs) {
        deviations.push_back(std::abs(time - median));
    }
    return {median, quantile(deviations, 0.5)};
}

double millisecondsSince(SteadyClock::time_point begin) {
    return std::chrono::duration<double, std::milli>(SteadyClock::now() - begin).count();
}

void Contest::add(std::string name, std::function<void(int)> action) {
    m_entries.push_back({std::move(name), std::move(action), {}, {}});
}

void Contest::time(Entry& entry, int begin, int end, bool counts, const std::stop_token& stop) {
    for (int run = begin; run < end; ++run) {
        throwIfStopped(stop);
        const auto start = SteadyClock::now();
        entry.action(run);
        const double passedMs = millisecondsSince(start);
        if (counts) {
            entry.timesMs.push_back(passedMs);
        }
    }
}

void Contest::run(int rounds, int block, ProgressSink& progress, std::string_view activity,
                  const std::stop_token& stop) {
    for (Entry& entry : m_entries) {
        entry.timesMs.clear();
    }
    const int end = rounds + block;
    for (int begin = 0; begin < end; begin += block) {
        for (Entry& entry : m_entries) {
            time(entry, begin, std::min(begin + block, end), begin > 0, stop);
        }
        progress.progress(static_cast<double>(std::min(begin + block, end)) / end, activity);
    }
    for (Entry& entry : m_entries) {
        entry.result = measured(entry.timesMs);
    }
}

const Measured& Contest::of(const std::string& name) const {
    const auto found = std::find_if(m_entries.begin(), m_entries.end(),
                                    [&](const Entry& entry) { return entry.name == name; });
    if (found == m_entries.end()) {
        throw Error(ErrorKind::Internal, text("Nothing was measured under the name ", name, "."));
    }
    return found->result;
}

double meanDifference(const RgbImage& a, const RgbImage& b) {
    if (a.width() != b.width() || a.height() != b.height() || a.empty()) {
        return std::numeric_limits<double>::infinity();
    }
    double sum = 0;
    for (std::size_t i = 0; i < a.values().size(); ++i) {
        sum += std::abs(a.values()[i] - b.values()[i]);
    }
    return sum / static_cast<double>(a.values().size());
}

void requireAlike(const RgbImage& picture, const RgbImage& expected, double mostGreyLevels,
                  std::string_view what) {
    const double difference = meanDifference(picture, expected);
    if (!(difference <= mostGreyLevels)) {
        refuse(what, text("it is ", fixed(difference, 2), " grey levels off on average, and ",
                          fixed(mostGreyLevels, 2), " are allowed"));
    }
}

void requireSame(const RgbImage& picture, const RgbImage& expected, std::string_view what) {
    if (!(picture == expected)) {
        refuse(what, "its bytes differ");
    }
}

void requirePart(const RgbImage& part, const jpeg::PixelRect& region, const RgbImage& whole,
                 std::string_view what) {
    if (!hasPart(part, region, whole)) {
        refuse(what, "its bytes are not those of the whole photo");
    }
}

void requirePart(const jpeg::Planes& part, const jpeg::PixelRect& region, const jpeg::Planes& whole,
                 std::string_view what) {
    const auto isRight = [&](const jpeg::Planes::Plane& own, const jpeg::Planes::Plane& all, int across,
                             int down) {
        if (all.empty()) {
            return own.empty(); // the chroma of a grey picture
        }
        return hasPart(own,
                       {region.x / across, region.y / down, (region.width + across - 1) / across,
                        (region.height + down - 1) / down},
                       all);
    };
    if (!isRight(part.luma, whole.luma, 1, 1) ||
        !isRight(part.blue, whole.blue, whole.horizontal, whole.vertical) ||
        !isRight(part.red, whole.red, whole.horizontal, whole.vertical)) {
        refuse(what, "its samples are not those of the whole photo");
    }
}

} // namespace spherewalk::bench
