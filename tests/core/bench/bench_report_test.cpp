// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/base/json.h"
#include "spherewalk/bench/bench_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace spherewalk::bench {

using testing::HasSubstr;
using testing::Not;

namespace {

BenchRow row(const std::string& name, int threads, double ms, std::optional<Peer> peer = {}) {
    BenchRow result;
    result.name = name;
    result.threads = threads;
    result.own = {ms, 0.01};
    result.peer = std::move(peer);
    if (name.starts_with("view") || name.starts_with("cold")) {
        result.view = ViewSetting{};
        result.parts = ViewParts{0.5 * ms, 0};
    }
    return result;
}

BenchReport someReport() {
    BenchReport report;
    report.machine = {"A <fast> & \"good\" processor", 2, "AVX2", "Release", "GCC", "1.2", "OpenCV 4", 1.9};
    report.measurand = {"kitchen", 404, 5376, 2688, 4'000'000, true, 640, 480};
    report.rows = {row("view.bilinear", 1, 0.5, Peer{"OpenCV maps + remap", 10}),
                   row("view.bilinear", 1, 0.5, Peer{"OpenCV remap", 1.2}),
                   row("view.bilinear", 2, 0.25, Peer{"one thread", 0.5}),
                   row("view.footprint", 1, 1),
                   row("view.nearest", 1, 0.6),
                   row("decode.region", 1, 20, Peer{"libjpeg-turbo, whole photo", 140}),
                   row("cold_cell", 2, 12, Peer{"whole decode + render", 150})};
    report.directions = 40;
    report.fidelity = {{render::Sampling::Bilinear, 90, 42, 36},
                       {render::Sampling::Footprint, 90, 54, 49},
                       {render::Sampling::Nearest, 90, 37, 30}};
    report.lattice = {{LatticeSearch::Displaced, {0.004, "here", 0.2, {}, 10, true}},
                      {LatticeSearch::EveryLens, {0.006, "there", 0.3, {}, 10, true}}};
    report.walkedPast = {404, 80.6, true};
    for (const double speed : {1.0, 10.0, 20.0}) {
        report.walk.push_back({speed, render::LatePolicy::Wait, true, 90, 0, speed > 10 ? 0.25 : 0, 4, 0});
        report.walk.push_back({speed, render::LatePolicy::Wait, false, 90, 10, 0.5, 30, 0.1});
    }
    report.residence = {612'000'000, 404};
    return report;
}

} // namespace

TEST(BenchReport, JsonHasTheMembersThatProgramsReadAndTheirTypes) {
    const Json json = toJson(someReport());
    EXPECT_TRUE(json["machine"].is_object());
    ASSERT_EQ(json["rows"].size(), 7U);
    for (const Json& one : json["rows"]) {
        EXPECT_TRUE(one["name"].is_string());
        EXPECT_TRUE(one["threads"].is_number_integer());
        EXPECT_TRUE(one["median_ms"].is_number());
        EXPECT_TRUE(one["mad_ms"].is_number());
        ASSERT_TRUE(one.contains("peer") && one.contains("peer_median_ms") && one.contains("ratio"));
        EXPECT_EQ(one["peer"].is_null(), one["ratio"].is_null());
    }
    EXPECT_EQ(json["rows"][0]["ratio"], 20);
    EXPECT_EQ(json["rows"][0]["peer_median_ms"], 10);
    EXPECT_TRUE(json["rows"][3]["peer"].is_null());
    EXPECT_EQ(json["fidelity"][1]["rung"], "footprint");
    EXPECT_EQ(json["fidelity"][1]["mean_db"], 54);
    EXPECT_EQ(json["fidelity"][1]["worst_db"], 49);
    EXPECT_EQ(json["lattice"]["worst_px"], 0.006);
    EXPECT_EQ(json["lattice"]["where"], "there");
    EXPECT_EQ(json["walk"][5]["speed_m_s"], 20);
    EXPECT_EQ(json["walk"][5]["policy"], "wait");
    EXPECT_EQ(json["walk"][5]["late_share"], 0.5);
    EXPECT_EQ(json["walk"][5]["p99_ms"], 30);
    EXPECT_EQ(json["resident_bytes"], 612'000'000);
}

TEST(BenchReport, TableSaysWhatWasMeasuredAndWhatItMeans) {
    const std::string table = benchTable(someReport());
    for (const char* part :
         {"A <fast> & \"good\" processor", "AVX2", "kitchen: 404 photos", "bilinear, 1 thread",
          "0.500 +- 0.010", "20.00 x", "decode", "7.00 x", "12.5 x", "54.0 / 49.0", "0.0060 px",
          "past 404 copies", "25.0 %", "612.0 MB", "no view was late up to 10 m/s; some were at 20 m/s",
          "takes 1.00 ms on one thread and is off by 0.5 of 255 grey levels (54 dB)"}) {
        EXPECT_THAT(table, HasSubstr(part));
    }
    EXPECT_THAT(table, Not(HasSubstr("rough")));
}

TEST(BenchReport, TableAndPlotOfNothingAreStillMade) {
    EXPECT_THAT(benchTable(BenchReport{}), HasSubstr("In short"));
    EXPECT_THAT(benchPlot(BenchReport{}), HasSubstr("not measured"));
}

TEST(BenchReport, PlotShowsEachRungPeerAndSpeed) {
    const std::string plot = benchPlot(someReport());
    EXPECT_TRUE(plot.starts_with("<svg xmlns"));
    EXPECT_TRUE(plot.ends_with("</svg>\n"));
    for (const char* part :
         {">bilinear<", ">footprint<", ">nearest<", ">OpenCV remap<", ">OpenCV maps + remap<", ">wait<",
          ">wait, no prefetch<", ">milliseconds a view<", "dB<", ">metres a second<", ">20<",
          "A &lt;fast&gt; &amp; &quot;good&quot; processor"}) {
        EXPECT_THAT(plot, HasSubstr(part));
    }
}

TEST(BenchReport, FindsTheFirstRowOfItsNameThreadsAndPeer) {
    const BenchReport report = someReport();
    EXPECT_EQ(report.find("view.bilinear", 1)->peer->name, "OpenCV maps + remap");
    EXPECT_EQ(report.find("view.bilinear", 1, "OpenCV remap")->peer->medianMs, 1.2);
    EXPECT_EQ(report.find("view.bilinear", 2)->own.medianMs, 0.25);
    EXPECT_EQ(report.find("view.bilinear", 3), nullptr);
    EXPECT_EQ(report.find("view.footprint", 1, "OpenCV remap"), nullptr); // it has no peer
    EXPECT_EQ(report.find("view", 1), nullptr);
}

TEST(BenchReport, JsonHasMembersOfViewsAndBytesOnlyWhereTheyWereMeasured) {
    BenchReport report = someReport();
    report.rows[5].bytes = 1234;
    const Json rows = toJson(report)["rows"];
    EXPECT_EQ(rows[0]["field_deg"], 90);
    EXPECT_EQ(rows[0]["pitch_deg"], 0);
    EXPECT_EQ(rows[0]["draw_ms"], 0.25);
    EXPECT_FALSE(rows[0].contains("bytes"));
    EXPECT_EQ(rows[5]["bytes"], 1234);
    EXPECT_FALSE(rows[5].contains("field_deg"));
    EXPECT_FALSE(rows[5].contains("draw_ms"));
}

TEST(BenchReport, JsonSaysNullForTheVersionOfNoPeer) {
    BenchReport report = someReport();
    EXPECT_EQ(toJson(report)["machine"]["peer_version"], "OpenCV 4");
    report.machine.peerVersion.clear();
    EXPECT_TRUE(toJson(report)["machine"]["peer_version"].is_null());
}

TEST(BenchReport, JsonOfNothingHasEveryList) {
    const Json json = toJson(BenchReport{});
    for (const char* list : {"rows", "fidelity", "walk"}) {
        EXPECT_TRUE(json[list].is_array() && json[list].empty()) << list;
    }
    EXPECT_TRUE(json["lattice"]["searches"].empty());
    EXPECT_EQ(json["lattice"]["worst_px"], 0);
}

TEST(BenchTable, NamesExtrasAndScenesOnlyWhereTheyWereMeasured) {
    BenchReport report = someReport();
    EXPECT_THAT(benchTable(report), Not(HasSubstr("of the sphere's time")));
    report.rows.push_back(row("view.with_overlay", 1, 1.5, Peer{"view alone", 1}));
    report.rows.push_back(row("view.with_overlay.other_lens", 1, 3, Peer{"view alone", 1}));
    report.rows.push_back(row("scene.room.footprint", 1, 4, Peer{"sphere", 2}));
    const std::string table = benchTable(report);
    EXPECT_THAT(table, testing::ContainsRegex("  object +1\\.500 \\+- 0\\.010 +0\\.500 ms"));
    EXPECT_THAT(table, testing::ContainsRegex("object of another lens +3\\.000 \\+- 0\\.010 +2\\.000 ms"));
    EXPECT_THAT(table, testing::ContainsRegex("room\\.footprint +4\\.000 \\+- 0\\.010 +2\\.0 x"));
}

TEST(BenchTable, SaysWhereFilesWereReadFrom) {
    BenchReport report = someReport();
    report.rows.push_back(row("cold_cell.unverified", 2, 11, Peer{"whole decode + render", 140}));
    report.rows.push_back(row("cold_cell.disk", 2, 30, Peer{"whole decode + render", 160}));
    report.coldFilesDropped = true;
    const std::string dropped = benchTable(report);
    EXPECT_THAT(dropped, HasSubstr("verified, from the disk  "));
    EXPECT_THAT(dropped, HasSubstr("not verified"));
    report.coldFilesDropped = false;
    EXPECT_THAT(benchTable(report), HasSubstr("(but the system would not forget the file)"));
}

TEST(BenchTable, LeavesOutPeersThatWereNotMeasured) {
    BenchReport report = someReport();
    EXPECT_THAT(benchTable(report), HasSubstr("bilinear against OpenCV remap"));
    report.machine.peerVersion.clear();
    EXPECT_THAT(benchTable(report), Not(HasSubstr("against OpenCV remap")));
}

TEST(BenchTable, SaysThatAQuickRunIsRough) {
    BenchReport report = someReport();
    report.quick = true;
    report.measurand.photos = 1;
    EXPECT_THAT(benchTable(report), HasSubstr("the figures are rough"));
    EXPECT_THAT(benchTable(report), HasSubstr("kitchen: 1 photo 5376 x 2688"));
}

TEST(Conclusions, TellTheSpeedUpToWhichNoViewWasLate) {
    BenchReport report;
    const auto walked = [&](double speed, double late, render::LatePolicy policy, bool prefetch) {
        report.walk.push_back({speed, policy, prefetch, 90, 0, late, 4, 0});
    };
    EXPECT_THAT(benchTable(report), Not(HasSubstr("With prefetch")));
    walked(1, 0.9, render::LatePolicy::Wait, false);  // neither without prefetch
    walked(1, 0.9, render::LatePolicy::Coarse, true); // nor with another policy
    EXPECT_THAT(benchTable(report), Not(HasSubstr("With prefetch")));
    walked(1, 0, render::LatePolicy::Wait, true);
    walked(5, 0, render::LatePolicy::Wait, true);
    EXPECT_THAT(benchTable(report), HasSubstr("With prefetch no view was late, up to 5 m/s."));
    walked(10, 0.1, render::LatePolicy::Wait, true);
    walked(20, 0, render::LatePolicy::Wait, true); // which does not mend the slower one
    EXPECT_THAT(benchTable(report), HasSubstr("no view was late up to 5 m/s; some were at 10 m/s."));
    walked(0.5, 0.1, render::LatePolicy::Wait, true);
    EXPECT_THAT(benchTable(report), HasSubstr("views were late already at 0.5 m/s."));
}

TEST(Conclusions, CompareWithThePeerOnlyWhereItWasMeasured) {
    BenchReport report = someReport();
    EXPECT_THAT(benchTable(report),
                HasSubstr("a bilinear one is made 20.0 times as fast as OpenCV maps + remap."));
    report.rows[0].peer.reset();
    EXPECT_THAT(benchTable(report), Not(HasSubstr("times as fast")));
    EXPECT_THAT(benchTable(report), HasSubstr("The first view of a photo comes after 12 ms."));
    report.rows.clear();
    EXPECT_THAT(benchTable(report), HasSubstr("In short: With prefetch"));
}

TEST(BenchPlot, DrawsABarForEachWalkAndADotForEachSampling) {
    const std::string plot = benchPlot(someReport());
    const auto count = [&](const std::string& part) {
        std::size_t found = 0;
        for (std::size_t at = 0; (at = plot.find(part, at)) != std::string::npos; ++at) {
            ++found;
        }
        return found;
    };
    EXPECT_EQ(count("<circle"), 3U);
    EXPECT_EQ(count("class=\"dashed\""), 2U); // a line for each peer
    EXPECT_EQ(count("<rect x="), 6U + 2U);    // six walks and the legend of two series
}

TEST(BenchPlot, ShowsTheFirstFieldOfViewThatWasTimed) {
    BenchReport report = someReport();
    report.fidelity.insert(report.fidelity.begin(), RungFidelity{render::Sampling::Bilinear, 57, 45, 40});
    EXPECT_THAT(benchPlot(report), HasSubstr("Samplings at 90 degrees")); // at 57, no view was timed
    BenchRow narrow = row("view.bilinear.57", 1, 0.7);
    report.rows.push_back(narrow);
    EXPECT_THAT(benchPlot(report), HasSubstr("Samplings at 57 degrees"));
}

} // namespace spherewalk::bench
