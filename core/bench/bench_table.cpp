// SPDX-License-Identifier: GPL-3.0-or-later
#include "cold_cell.h"
#include "decode_bench.h"
#include "verdict.h"
#include "view_bench.h"

#include "spherewalk/base/text.h"
#include "spherewalk/measure/text_table.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace spherewalk::measure {

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

void addPeers(const BenchReport& report, TextTable& table) {
    for (const char* peer : {kMapsAndRemap, kRemap, kRemapSameMap}) {
        table.add(acrossSettings(text(peer, ", 1 thread"), [&](const ViewSetting& setting) {
            const BenchRow* row = report.find(viewRowName(render::Sampling::Bilinear, setting), 1, peer);
            return row == nullptr ? "" : milliseconds(row->peer->medianMs);
        }));
    }
}

void addRatios(const BenchReport& report, TextTable& table) {
    const auto add = [&](render::Sampling sampling, const char* peer) {
        table.add(acrossSettings(text(name(sampling), " against ", peer), [&](const ViewSetting& setting) {
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
    TextTable table;
    table.add(acrossSettings("", settingText));
    for (const render::Sampling sampling : kRungs) {
        for (const int threads : {1, 2}) {
            table.add(acrossSettings(
                text(name(sampling), ", ", threadsText(threads)), [&](const ViewSetting& setting) {
                    const BenchRow* row = report.find(viewRowName(sampling, setting), threads);
                    return row == nullptr ? "" : withDeviation(row->own);
                }));
        }
    }
    table.add(acrossSettings("footprint, 1 thread, drawing alone", [&](const ViewSetting& setting) {
        const BenchRow* row = report.find(viewRowName(render::Sampling::Footprint, setting), 1);
        return row == nullptr ? "" : milliseconds(row->parts->drawMs);
    }));
    if (!report.machine.peerVersion.empty()) {
        addPeers(report, table);
        addRatios(report, table);
    }
    table.add(acrossSettings("bilinear, one thread to two", [&](const ViewSetting& setting) {
        const BenchRow* row = report.find(viewRowName(render::Sampling::Bilinear, setting), 2);
        return row == nullptr ? "" : text(fixed(row->ratio(), 2), " x");
    }));
    return text("\nViews of ", report.measurand.viewWidth, " x ", report.measurand.viewHeight,
                " pixels, the camera turning and moving every frame: milliseconds, median +- deviation\n",
                table.text());
}

std::string extrasText(const BenchReport& report) {
    TextTable table;
    table.add({"", "ms", "more than the view alone"});
    for (const BenchRow& row : report.rows) {
        constexpr std::string_view kStart = "view.with_";
        if (row.name.starts_with(kStart)) {
            std::string title = row.name.substr(kStart.size());
            title = title == "overlay"              ? "object"
                    : title == "overlay.other_lens" ? "object of another lens"
                                                    : title;
            table.add({title, withDeviation(row.own),
                       text(milliseconds(row.own.medianMs - row.peer->medianMs), " ms")});
        }
    }
    return text("\nA level view of 90 degrees, footprint, 1 thread, with\n", table.text());
}

std::string scenesText(const BenchReport& report) {
    TextTable table;
    table.add({"", "ms", "of the sphere's time"});
    bool hasRows = false;
    for (const BenchRow& row : report.rows) {
        constexpr std::string_view kStart = "scene.";
        if (row.name.starts_with(kStart)) {
            hasRows = true;
            table.add({row.name.substr(kStart.size()), withDeviation(row.own),
                       text(fixed(row.own.medianMs / row.peer->medianMs, 1), " x")});
        }
    }
    return hasRows ? text("\nA level view of 57 degrees from beside a photo, 1 thread, of the scene model\n",
                          table.text())
                   : "";
}

std::string decodeText(const BenchReport& report) {
    TextTable table;
    table.add({"", "ms", "pixels", "against whole by libjpeg-turbo"});
    for (const BenchRow& row : report.rows) {
        if (row.name.starts_with("decode.")) {
            const bool isCompared = row.peer.has_value();
            table.add({text(row.name.substr(row.name.find('.') + 1), ", ", threadsText(row.threads)),
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
    TextTable table;
    table.add({"", "ms", "of it decoding", "whole decode + render", ""});
    for (const BenchRow& row : report.rows) {
        if (row.name.starts_with("cold_cell")) {
            table.add({coldTitle(report, row.name), withDeviation(row.own), milliseconds(row.parts->decodeMs),
                       milliseconds(row.peer->medianMs), text(fixed(row.ratio(), 1), " x")});
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
    TextTable table;
    std::vector<std::string> heads{""};
    for (const double field : fields) {
        heads.push_back(text(field, " deg"));
    }
    table.add(heads);
    for (const render::Sampling rung : kRungs) {
        std::vector<std::string> cells{std::string(name(rung))};
        for (const RungFidelity& row : report.fidelity) {
            if (row.rung == rung) {
                cells.push_back(text(fixed(row.meanDb, 1), " / ", fixed(row.worstDb, 1)));
            }
        }
        table.add(cells);
    }
    return text("\nLikeness to the mean over each pixel's area, mean / worst dB of ", report.directions,
                " directions with pitches to +-80 degrees (more is better)\n", table.text());
}

std::string latticeText(const BenchReport& report) {
    TextTable table(3);
    for (const LatticeRow& row : report.lattice) {
        table.add({std::string(name(row.search)), text(fixed(row.error.worstPx, 4), " px"), row.error.where});
    }
    return text("\nWorst error found of the coordinates that views are made with, in pixels of the photo\n",
                table.text());
}

std::string walkText(const BenchReport& report) {
    TextTable table;
    table.add({"", "speed", "late of the first 10", "late thereafter", "99 of 100 within", "missed 1/30 s"});
    for (const bool prefetch : {true, false}) {
        for (const WalkRow& row : report.walk) {
            if (row.prefetch == prefetch) {
                table.add({text(name(row.policy), prefetch ? ", prefetch" : ", no prefetch"),
                           text(row.speedMS, " m/s"), text(row.lateAtStart),
                           text(fixed(100 * row.lateShare, 1), " %"), text(milliseconds(row.p99Ms), " ms"),
                           text(fixed(100 * row.missedShare, 1), " %")});
            }
        }
    }
    const WalkedPast& way = report.walkedPast;
    return text("\nWalks in real time, 30 views a second, past ", way.photos,
                way.copies ? " copies of the first photo" : " photos", " and back on ", fixed(way.lengthM, 1),
                " m\n", table.text());
}

} // namespace

std::string benchTable(const BenchReport& report) {
    return text(machineText(report), viewText(report), extrasText(report), scenesText(report),
                decodeText(report), coldText(report), fidelityText(report), latticeText(report),
                walkText(report), "\nMemory: ", humanBytes(report.residence.peakBytes),
                " at most, after looking all round at ", report.residence.photos,
                report.residence.photos == 1 ? " photo" : " photos", "\n\n", verdict(report));
}

} // namespace spherewalk::measure
