// SPDX-License-Identifier: GPL-3.0-or-later
#include "verdict.h"

#include "spherewalk/base/text.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

namespace spherewalk::measure {

namespace {

std::string viewSentence(const BenchReport& report) {
    const BenchRow* view = report.find("view.footprint", 1);
    if (view == nullptr) {
        return "";
    }
    std::string sentence =
        text("a view of the default quality takes ", fixed(view->own.medianMs, 2), " ms on one thread");
    const auto fidelity =
        std::find_if(report.fidelity.begin(), report.fidelity.end(),
                     [](const RungFidelity& row) { return row.rung == render::Sampling::Footprint; });
    if (fidelity != report.fidelity.end()) {
        const double levels = 255 / std::pow(10, fidelity->meanDb / 20);
        sentence += text(" and is off by ", fixed(levels, 1), " of 255 grey levels (",
                         fixed(fidelity->meanDb, 0), " dB)");
    }
    const BenchRow* bilinear = report.find("view.bilinear", 1);
    if (bilinear != nullptr && bilinear->peer) {
        sentence += text("; a bilinear one is made ", fixed(bilinear->ratio(), 1), " times as fast as ",
                         bilinear->peer->name);
    }
    return sentence + ". ";
}

std::string coldSentence(const BenchReport& report) {
    const auto row = std::find_if(report.rows.begin(), report.rows.end(),
                                  [](const BenchRow& one) { return one.name == "cold_cell"; });
    return row == report.rows.end()
               ? ""
               : text("The first view of a photo comes after ", fixed(row->own.medianMs, 0), " ms. ");
}

/// The fastest of the walks' speeds up to which no view was late.
std::string walkSentence(const BenchReport& report) {
    std::set<double> speeds;
    std::set<double> lateAt;
    for (const WalkRow& row : report.walk) {
        if (row.prefetch && row.policy == render::LatePolicy::Wait) {
            speeds.insert(row.speedMS);
            if (row.lateShare > 0) {
                lateAt.insert(row.speedMS);
            }
        }
    }
    if (speeds.empty()) {
        return "";
    }
    if (lateAt.empty()) {
        return text("With prefetch no view was late, up to ", *speeds.rbegin(), " m/s. ");
    }
    const auto firstLate = speeds.find(*lateAt.begin());
    return firstLate == speeds.begin()
               ? text("With prefetch, views were late already at ", *firstLate, " m/s. ")
               : text("With prefetch no view was late up to ", *std::prev(firstLate), " m/s; some were at ",
                      *firstLate, " m/s. ");
}

} // namespace

std::string verdict(const BenchReport& report) {
    return text("In short: ", viewSentence(report), coldSentence(report), walkSentence(report),
                "The program took ", humanBytes(report.residence.peakBytes), " of memory at most.");
}

} // namespace spherewalk::measure
