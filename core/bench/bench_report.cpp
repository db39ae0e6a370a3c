// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/bench/bench_report.h"

#include "spherewalk/base/json.h"

#include <algorithm>

namespace spherewalk::bench {

namespace {

Json toJson(const Machine& machine) {
    Json json{{"processor", machine.processor}, {"threads", machine.threads},
              {"simd", machine.simd},           {"build_type", machine.buildType},
              {"compiler", machine.compiler},   {"version", machine.version},
              {"peer_version", Json()},         {"two_thread_gain", machine.twoThreadGain}};
    if (!machine.peerVersion.empty()) {
        json["peer_version"] = machine.peerVersion;
    }
    return json;
}

Json toJson(const Measurand& measurand) {
    return {{"name", measurand.dataset},           {"photos", measurand.photos},
            {"photo_width", measurand.photoWidth}, {"photo_height", measurand.photoHeight},
            {"photo_bytes", measurand.photoBytes}, {"decodes_parts", measurand.decodesParts},
            {"view_width", measurand.viewWidth},   {"view_height", measurand.viewHeight}};
}

Json toJson(const BenchRow& row) {
    Json json{{"name", row.name},        {"threads", row.threads}, {"median_ms", row.own.medianMs},
              {"mad_ms", row.own.madMs}, {"peer", Json()},         {"peer_median_ms", Json()},
              {"ratio", Json()}};
    if (row.peer) {
        json["peer"] = row.peer->name;
        json["peer_median_ms"] = row.peer->medianMs;
        json["ratio"] = row.ratio();
    }
    if (row.view) {
        json["field_deg"] = row.view->fieldDeg;
        json["pitch_deg"] = row.view->pitchDeg;
    }
    if (row.parts) {
        json["draw_ms"] = row.parts->drawMs;
        json["decode_ms"] = row.parts->decodeMs;
    }
    if (row.bytes > 0) {
        json["bytes"] = row.bytes;
    }
    return json;
}

Json toJson(const RungFidelity& fidelity) {
    return {{"rung", name(fidelity.rung)},
            {"mean_db", fidelity.meanDb},
            {"worst_db", fidelity.worstDb},
            {"field_deg", fidelity.fieldDeg}};
}

Json toJson(const std::vector<LatticeRow>& lattice) {
    LatticeError worst;
    Json searches = Json::array();
    for (const LatticeRow& row : lattice) {
        worst.add(row.error);
        searches.push_back({{"name", name(row.search)},
                            {"worst_px", row.error.worstPx},
                            {"where", row.error.where},
                            {"error_to_bound", row.error.worstToBound},
                            {"samples", row.error.samples}});
    }
    return {{"worst_px", worst.worstPx}, {"where", worst.where}, {"searches", searches}};
}

Json toJson(const WalkRow& walk) {
    return {{"speed_m_s", walk.speedMS},    {"policy", name(walk.policy)},
            {"late_share", walk.lateShare}, {"p99_ms", walk.p99Ms},
            {"prefetch", walk.prefetch},    {"missed_share", walk.missedShare},
            {"views", walk.views},          {"late_at_start", walk.lateAtStart}};
}

template <class Row>
Json listOf(const std::vector<Row>& rows) {
    Json list = Json::array();
    for (const Row& row : rows) {
        list.push_back(toJson(row));
    }
    return list;
}

} // namespace

const BenchRow* BenchReport::find(const std::string& name, int threads, const std::string& peer) const {
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const BenchRow& row) {
        return row.name == name && row.threads == threads &&
               (peer.empty() || (row.peer && row.peer->name == peer));
    });
    return found == rows.end() ? nullptr : &*found;
}

Json toJson(const BenchReport& report) {
    return {{"machine", toJson(report.machine)},
            {"dataset", toJson(report.measurand)},
            {"quick", report.quick},
            {"rows", listOf(report.rows)},
            {"cold_files_dropped", report.coldFilesDropped},
            {"fidelity", listOf(report.fidelity)},
            {"fidelity_directions", report.directions},
            {"lattice", toJson(report.lattice)},
            {"walk", listOf(report.walk)},
            {"walk_photos", report.walkedPast.photos},
            {"walk_length_m", report.walkedPast.lengthM},
            {"walk_copies", report.walkedPast.copies},
            {"resident_bytes", report.residence.peakBytes},
            {"resident_photos", report.residence.photos}};
}

} // namespace spherewalk::bench
