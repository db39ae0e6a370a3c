// SPDX-License-Identifier: GPL-3.0-or-later
#include "measurements.h"

#include "spherewalk/base/text.h"
#include "spherewalk/bench/bench_report.h"
#include "spherewalk/report/document.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>
#include <string_view>

namespace spherewalk::bench {

using report::Table;

namespace {

constexpr std::array<ViewSetting, 4> kSettings{{{90, 0}, {90, 80}, {57, 0}, {57, 80}}};

std::string threadsText(int threads) {
    return text(threads, threads == 1 ? " thread" : " threads");
}

std::string milliseconds(double ms) {
    return fixed(ms, ms < 10 ? 3 : ms < 100 ? 2 : 1);
}

std::string withDeviation(const Measured& own) {
    return text(milliseconds(own.medianMs), " +- ", milliseconds(own.madMs));
}

std::string settingText(const ViewSetting& setting) {
    return text(fixed(setting.fieldDeg, 0), " deg",
                setting.pitchDeg == 0 ? ", level" : text(", pitch ", fixed(setting.pitchDeg, 0)));
}

/// A row with one cell a setting; "-" where nothing was measured.
template <class Cell>
std::vector<std::string> acrossSettings(const std::string& title, Cell&& cell) {
    std::vector<std::string> cells{title};
    for (const ViewSetting& setting : kSettings) {
        const std::string value = cell(setting);
        cells.push_back(value.empty() ? "-" : value);
    }
    return cells;
}

std::string machineText(const BenchReport& report) {
    const Machine& machine = report.machine;
    const Measurand& measurand = report.measurand;
    return text("Spherewalk ", machine.version, ", ", machine.buildType, ", ", machine.compiler,
                machine.peerVersion.empty() ? "" : text("; ", machine.peerVersion, " on one thread"), "\n",
                machine.processor, ", ", machine.simd, "; runs ", threadsText(machine.threads),
                " at a time (two threads of plain arithmetic gain ", fixed(machine.twoThreadGain, 2),
                "x at this moment)\n", "Dataset ", printable(measurand.dataset), ": ", measurand.photos,
                measurand.photos == 1 ? " photo" : " photos, the first of", " ", measurand.photoWidth, " x ",
                measurand.photoHeight, " pixels and ", humanBytes(measurand.photoBytes), ", ",
                measurand.decodesParts ? "with" : "without", " restart markers\n",
                report.quick ? "A quick run: the figures are rough.\n" : "");
}

void addPeers(const BenchReport& report, Table& table) {
    for (const char* peer : {kMapsAndRemap, kRemap, kRemapSameMap}) {
        table.rows.push_back(acrossSettings(text(peer, ", 1 thread"), [&](const ViewSetting& setting) {
            const BenchRow* row = report.find(viewRowName(render::Sampling::Bilinear, setting), 1, peer);
            return row == nullptr ? "" : milliseconds(row->peer->medianMs);
        }));
    }
}

void addRatios(const BenchReport& report, Table& table) {
    const auto add = [&](render::Sampling sampling, const char* peer) {
        table.rows.push_back(
            acrossSettings(text(name(sampling), " against ", peer), [&](const ViewSetting& setting) {
                const BenchRow* row = report.find(viewRowName(sampling, setting), 1, peer);
                return row == nullptr ? "" : text(fixed(row->ratio(), 2), " x");
            }));
    };
    add(render::Sampling::Bilinear, kMapsAndRemap);
    for (const render::Sampling sampling : {render::Sampling::Bilinear, render::Sampling::Footprint}) {
        add(sampling, kRemap);
        add(sampling, kRemapSameMap);
    }
}

std::string viewText(const BenchReport& report) {
    Table table{acrossSettings("", settingText), {}};
    for (const render::Sampling sampling : kRungs) {
        for (const int threads : {1, 2}) {
            table.rows.push_back(acrossSettings(
                text(name(sampling), ", ", threadsText(threads)), [&](const ViewSetting& setting) {
                    const BenchRow* row = report.find(viewRowName(sampling, setting), threads);
                    return row == nullptr ? "" : withDeviation(row->own);
                }));
        }
    }
    table.rows.push_back(
        acrossSettings("footprint, 1 thread, drawing alone", [&](const ViewSetting& setting) {
            const BenchRow* row = report.find(viewRowName(render::Sampling::Footprint, setting), 1);
            return row == nullptr ? "" : milliseconds(row->parts->drawMs);
        }));
    if (!report.machine.peerVersion.empty()) {
        addPeers(report, table);
        addRatios(report, table);
    }
    table.rows.push_back(acrossSettings("bilinear, one thread to two", [&](const ViewSetting& setting) {
        const BenchRow* row = report.find(viewRowName(render::Sampling::Bilinear, setting), 2);
        return row == nullptr ? "" : text(fixed(row->ratio(), 2), " x");
    }));
    return text("\nViews of ", report.measurand.viewWidth, " x ", report.measurand.viewHeight,
                " pixels, the camera turning and moving every frame: milliseconds, median +- deviation\n",
                table.text());
}

std::string extrasText(const BenchReport& report) {
    Table table{{"", "ms", "more than the view alone"}, {}};
    for (const BenchRow& row : report.rows) {
        constexpr std::string_view kStart = "view.with_";
        if (row.name.starts_with(kStart)) {
            std::string title = row.name.substr(kStart.size());
            title = title == "overlay"              ? "object"
                    : title == "overlay.other_lens" ? "object of another lens"
                                                    : title;
            table.rows.push_back({title, withDeviation(row.own),
                                  text(milliseconds(row.own.medianMs - row.peer->medianMs), " ms")});
        }
    }
    return text("\nA level view of 90 degrees, footprint, 1 thread, with\n", table.text());
}

std::string scenesText(const BenchReport& report) {
    Table table{{"", "ms", "of the sphere's time"}, {}};
    bool hasRows = false;
    for (const BenchRow& row : report.rows) {
        constexpr std::string_view kStart = "scene.";
        if (row.name.starts_with(kStart)) {
            hasRows = true;
            table.rows.push_back({row.name.substr(kStart.size()), withDeviation(row.own),
                                  text(fixed(row.own.medianMs / row.peer->medianMs, 1), " x")});
        }
    }
    return hasRows ? text("\nA level view of 57 degrees from beside a photo, 1 thread, of the scene model\n",
                          table.text())
                   : "";
}

std::string decodeText(const BenchReport& report) {
    Table table{{"", "ms", "pixels", "against whole by libjpeg-turbo"}, {}};
    for (const BenchRow& row : report.rows) {
        if (row.name.starts_with("decode.")) {
            const bool isCompared = row.peer.has_value();
            table.rows.push_back(
                {text(row.name.substr(row.name.find('.') + 1), ", ", threadsText(row.threads)),
                 withDeviation(row.own), humanBytes(row.bytes),
                 isCompared ? text(fixed(row.ratio(), 2), " x") : ""});
        }
    }
    return text(
        "\nDecoding a photo; region: what a level view of 90 degrees shows; reduced: that at half its "
        "size; planes: as the JPEG stores them\n",
        table.text());
}

std::string coldTitle(const BenchReport& report, const std::string& row) {
    if (row == "cold_cell.disk") {
        return report.coldFilesDropped ? "verified, from the disk"
                                       : "verified, from the disk (but the system would not forget the file)";
    }
    return row == "cold_cell" ? "verified by its hash" : "not verified";
}

std::string coldText(const BenchReport& report) {
    Table table{{"", "ms", "of it decoding", "whole decode + render", ""}, {}};
    for (const BenchRow& row : report.rows) {
        if (row.name.starts_with("cold_cell")) {
            table.rows.push_back({coldTitle(report, row.name), withDeviation(row.own),
                                  milliseconds(row.parts->decodeMs), milliseconds(row.peer->medianMs),
                                  text(fixed(row.ratio(), 1), " x")});
        }
    }
    return text("\nFirst view of a photo that nobody decoded ahead, its file in the system's cache\n",
                table.text());
}

std::string fidelityText(const BenchReport& report) {
    std::vector<double> fields;
    for (const RungFidelity& row : report.fidelity) {
        if (std::find(fields.begin(), fields.end(), row.fieldDeg) == fields.end()) {
            fields.push_back(row.fieldDeg);
        }
    }
    Table table{{""}, {}};
    for (const double field : fields) {
        table.titles.push_back(text(field, " deg"));
    }
    for (const render::Sampling rung : kRungs) {
        std::vector<std::string> cells{std::string(name(rung))};
        for (const double field : fields) {
            const auto row =
                std::find_if(report.fidelity.begin(), report.fidelity.end(), [&](const RungFidelity& one) {
                    return one.rung == rung && one.fieldDeg == field;
                });
            cells.push_back(row == report.fidelity.end()
                                ? "-"
                                : text(fixed(row->meanDb, 1), " / ", fixed(row->worstDb, 1)));
        }
        table.rows.push_back(cells);
    }
    return text("\nLikeness to the mean over each pixel's area, mean / worst dB of ", report.directions,
                " directions with pitches to +-80 degrees (more is better)\n", table.text());
}

std::string latticeText(const BenchReport& report) {
    Table table{{}, {}, 3};
    for (const LatticeRow& row : report.lattice) {
        table.rows.push_back(
            {std::string(name(row.search)), text(fixed(row.error.worstPx, 4), " px"), row.error.where});
    }
    return text("\nWorst error found of the coordinates that views are made with, in pixels of the photo\n",
                table.text());
}

std::string walkText(const BenchReport& report) {
    Table table{{"", "speed", "late of the first 10", "late thereafter", "99 of 100 within", "missed 1/30 s"},
                {}};
    for (const bool prefetch : {true, false}) {
        for (const WalkRow& row : report.walk) {
            if (row.prefetch == prefetch) {
                table.rows.push_back({text(name(row.policy), prefetch ? ", prefetch" : ", no prefetch"),
                                      text(row.speedMS, " m/s"), text(row.lateAtStart),
                                      text(fixed(100 * row.lateShare, 1), " %"),
                                      text(milliseconds(row.p99Ms), " ms"),
                                      text(fixed(100 * row.missedShare, 1), " %")});
            }
        }
    }
    const WalkedPast& way = report.walkedPast;
    return text("\nWalks in real time, 30 views a second, past ", way.photos,
                way.copies ? " copies of the first photo" : " photos", " and back on ", fixed(way.lengthM, 1),
                " m\n", table.text());
}

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

std::string conclusions(const BenchReport& report) {
    return text("In short: ", viewSentence(report), coldSentence(report), walkSentence(report),
                "The program took ", humanBytes(report.residence.peakBytes), " of memory at most.");
}

} // namespace

std::string benchTable(const BenchReport& report) {
    return text(machineText(report), viewText(report), extrasText(report), scenesText(report),
                decodeText(report), coldText(report), fidelityText(report), latticeText(report),
                walkText(report), "\nMemory: ", humanBytes(report.residence.peakBytes),
                " at most, after looking all round at ", report.residence.photos,
                report.residence.photos == 1 ? " photo" : " photos", "\n\n", conclusions(report));
}

} // namespace spherewalk::bench
