// SPDX-License-Identifier: GPL-3.0-or-later
#include "random.h"

#include "spherewalk/measure/bench_report.h"
#include "spherewalk/measure/plot_axis.h"
#include "spherewalk/measure/svg.h"
#include "spherewalk/measure/text_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace spherewalk::measure {

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
    report.lattice = {{render::LatticeSearch::Displaced, {0.004, "here", 0.2, {}, 10, true}},
                      {render::LatticeSearch::EveryLens, {0.006, "there", 0.3, {}, 10, true}}};
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

TEST(PlotAxis, TicksEncloseTheRangeAndAreFew) {
    test::Random random(5);
    SCOPED_TRACE(random.seed());
    for (int i = 0; i < 500; ++i) {
        const double least = random.uniform(-50, 50);
        const double greatest = least + std::pow(10, random.uniform(-2, 3));
        const std::vector<double> even = evenTicks(least, greatest, 8);
        ASSERT_GE(even.size(), 2U);
        EXPECT_LE(even.size(), 9U);
        EXPECT_LE(even.front(), least + 1e-6);
        EXPECT_GE(even.back(), greatest - 1e-6);
        EXPECT_TRUE(std::is_sorted(even.begin(), even.end()));
        const double small = std::pow(10, random.uniform(-3, 2));
        const std::vector<double> logarithmic = logarithmicTicks(small, small * random.uniform(1, 300));
        ASSERT_GE(logarithmic.size(), 2U);
        EXPECT_LE(logarithmic.front(), small * (1 + 1e-6));
        EXPECT_GE(logarithmic[1] * (1 + 1e-6), small);
    }
    EXPECT_EQ(evenTicks(0, 100, 6), (std::vector<double>{0, 20, 40, 60, 80, 100}));
    EXPECT_EQ(logarithmicTicks(0.3, 4), (std::vector<double>{0.2, 0.5, 1, 2, 5}));
}

TEST(TextTable, AlignsItsColumns) {
    TextTable table;
    table.add({"", "ms"});
    table.add({"long name", "1.5"});
    table.add({"a", "10.25"});
    EXPECT_EQ(table.text(), "                 ms\n  long name     1.5\n  a           10.25\n");
}

TEST(Svg, BoxesOverlapOnlyWhereTheyShareAnArea) {
    const SvgBox box{10, 10, 20, 10};
    EXPECT_TRUE(box.overlaps({29, 19, 5, 5}));
    EXPECT_FALSE(box.overlaps({30, 10, 5, 5}));
    EXPECT_FALSE(box.overlaps({10, 20, 5, 5}));
    EXPECT_TRUE(box.overlaps({0, 0, 100, 100}));
}

} // namespace spherewalk::measure
