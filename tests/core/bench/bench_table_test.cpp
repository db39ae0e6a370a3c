// SPDX-License-Identifier: GPL-3.0-or-later
#include "made_report.h"

#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <sstream>

namespace spherewalk::bench {

using testing::HasSubstr;
using testing::Not;

namespace {

/// The cells of a line. Columns of a table are at least three blanks apart.
std::vector<std::string> cellsOf(const std::string& line) {
    std::vector<std::string> cells;
    for (std::size_t at = line.find_first_not_of(' '); at != std::string::npos;) {
        const std::size_t end = std::min(line.find("   ", at), line.size());
        cells.push_back(line.substr(at, end - at));
        at = line.find_first_not_of(' ', end);
    }
    return cells;
}

/// The lines that follow the line which begins like this, up to an empty one.
std::vector<std::string> tableBelow(const std::string& all, const std::string& start) {
    std::istringstream lines(all);
    std::vector<std::string> table;
    bool isFound = false;
    for (std::string line; std::getline(lines, line) && !(isFound && line.empty());) {
        if (isFound) {
            table.push_back(line);
        }
        isFound = isFound || line.starts_with(start);
    }
    return table;
}

/// The cells of the first line whose first cell is this one; none if there is no such line.
std::vector<std::string> rowOfTable(const std::string& all, const std::string& title) {
    std::istringstream lines(all);
    for (std::string line; std::getline(lines, line);) {
        const std::vector<std::string> cells = cellsOf(line);
        if (!cells.empty() && cells.front() == title) {
            return cells;
        }
    }
    return {};
}

class MadeTable : public testing::TestWithParam<unsigned> {
  protected:
    test::Random m_random{GetParam()};
    BenchReport m_report = test::MadeReport(m_random).fill();
    std::string m_table = benchTable(m_report);
};

} // namespace

TEST_P(MadeTable, HasARatioForEachSettingOfEachPeer) {
    for (const char* peer : {kMapsAndRemap, kRemap, kRemapSameMap}) {
        const std::vector<std::string> cells = rowOfTable(m_table, text("bilinear against ", peer));
        ASSERT_EQ(cells.size(), 5U) << peer;
        for (std::size_t i = 0; i < test::kTimedSettings.size(); ++i) {
            const BenchRow* row =
                m_report.find(viewRowName(render::Sampling::Bilinear, test::kTimedSettings[i]), 1, peer);
            const double ratio = row->peer->medianMs / row->own.medianMs;
            EXPECT_NEAR(std::stod(cells[i + 1]), ratio, 0.00501) << peer;
        }
    }
}

TEST_P(MadeTable, HasTheTimeOfEachSamplingAndNumberOfThreads) {
    for (const render::Sampling rung : kRungs) {
        for (const int threads : {1, 2}) {
            const std::vector<std::string> cells =
                rowOfTable(m_table, text(name(rung), ", ", threads, threads == 1 ? " thread" : " threads"));
            ASSERT_EQ(cells.size(), 5U);
            for (std::size_t i = 0; i < test::kTimedSettings.size(); ++i) {
                const BenchRow* row = m_report.find(viewRowName(rung, test::kTimedSettings[i]), threads);
                EXPECT_NEAR(std::stod(cells[i + 1]), row->own.medianMs, 0.002 * row->own.medianMs);
                EXPECT_THAT(cells[i + 1], HasSubstr(" +- 0.010"));
            }
        }
    }
}

TEST_P(MadeTable, ListsEachWalkOnceAndThoseWithPrefetchFirst) {
    const std::vector<std::string> lines = tableBelow(m_table, "Walks in real time");
    ASSERT_EQ(lines.size(), 1 + m_report.walk.size());
    std::size_t next = 1;
    for (const bool prefetch : {true, false}) {
        for (const WalkRow& walk : m_report.walk) {
            if (walk.prefetch == prefetch) {
                const std::vector<std::string> cells = cellsOf(lines[next++]);
                ASSERT_EQ(cells.size(), 6U);
                EXPECT_EQ(cells[0], prefetch ? "wait, prefetch" : "wait, no prefetch");
                EXPECT_EQ(cells[1], text(walk.speedMS, " m/s"));
                EXPECT_EQ(cells[2], text(walk.lateAtStart));
                EXPECT_NEAR(std::stod(cells[3]), 100 * walk.lateShare, 0.0501);
                EXPECT_NEAR(std::stod(cells[4]), walk.p99Ms, 0.0501);
                EXPECT_NEAR(std::stod(cells[5]), 100 * walk.missedShare, 0.0501);
            }
        }
    }
}

TEST_P(MadeTable, LinesUpTheTimesOfViews) {
    std::set<std::size_t> widths;
    for (const std::string& line : tableBelow(m_table, "Views of 640 x 480")) {
        widths.insert(line.size());
    }
    EXPECT_EQ(widths.size(), 1U);
}

TEST_P(MadeTable, SaysNothingThatIsNoNumber) {
    for (const char* part : {"nan", "inf ", " -0.0"}) {
        EXPECT_THAT(m_table, Not(HasSubstr(part)));
    }
}

TEST_P(MadeTable, RepeatsItsFiguresInTheConclusions) {
    const std::string conclusions = m_table.substr(m_table.find("In short: "));
    const BenchRow& view = *m_report.find("view.footprint", 1);
    EXPECT_THAT(conclusions, HasSubstr(text(" takes ", fixed(view.own.medianMs, 2), " ms on one thread")));
    const BenchRow& cold = *m_report.find("cold_cell", 2);
    EXPECT_THAT(conclusions, HasSubstr(text(" comes after ", fixed(cold.own.medianMs, 0), " ms.")));
    EXPECT_THAT(conclusions, HasSubstr("612.0 MB of memory"));
}

INSTANTIATE_TEST_SUITE_P(BenchTable, MadeTable, testing::Range(1U, 5U));

TEST(BenchTable, PutsLikenessUnderItsFieldOfView) {
    BenchReport report;
    report.fidelity = {{render::Sampling::Bilinear, 90, 42, 36},
                       {render::Sampling::Footprint, 57, 54, 49},
                       {render::Sampling::Bilinear, 57, 43, 37}};
    const std::string table = benchTable(report);
    EXPECT_EQ(cellsOf(tableBelow(table, "Likeness").front()), (std::vector<std::string>{"90 deg", "57 deg"}));
    EXPECT_THAT(table, HasSubstr("\n  bilinear    42.0 / 36.0   43.0 / 37.0\n"));
    EXPECT_THAT(table, HasSubstr("\n  footprint             -   54.0 / 49.0\n"));
}

TEST(BenchTable, HasOneColumnForAFieldOfViewThatWasAskedForTwice) {
    BenchReport report;
    report.fidelity = {{render::Sampling::Bilinear, 90, 42, 36}, {render::Sampling::Bilinear, 90, 42, 36}};
    EXPECT_THAT(benchTable(report), HasSubstr("\n  bilinear    42.0 / 36.0\n"));
}

TEST(BenchJson, HasEachRowOnceAndInItsOrder) {
    test::Random random(12);
    const BenchReport report = test::MadeReport(random).fill();
    const Json json = Json::parse(toJson(report).dump());
    EXPECT_EQ(json, toJson(report)); // nothing is lost in a file
    ASSERT_EQ(json["rows"].size(), report.rows.size());
    for (std::size_t i = 0; i < report.rows.size(); ++i) {
        const BenchRow& row = report.rows[i];
        EXPECT_EQ(json["rows"][i]["name"], row.name);
        EXPECT_EQ(json["rows"][i]["threads"], row.threads);
        EXPECT_EQ(json["rows"][i]["median_ms"], row.own.medianMs);
        if (row.peer) {
            EXPECT_DOUBLE_EQ(json["rows"][i]["ratio"].get<double>() * row.own.medianMs, row.peer->medianMs);
        }
    }
}

TEST(BenchJson, HasTheWorstOfAllSearches) {
    test::Random random(13);
    const BenchReport report = test::MadeReport(random).fill();
    const Json lattice = toJson(report)["lattice"];
    ASSERT_EQ(lattice["searches"].size(), kLatticeSearches.size());
    double worst = 0;
    for (const Json& search : lattice["searches"]) {
        worst = std::max(worst, search["worst_px"].get<double>());
    }
    EXPECT_EQ(lattice["worst_px"], worst);
    EXPECT_EQ(lattice["searches"][2]["name"], "displaced");
}

TEST(BenchJson, TellsFidelityAndWalksAsTheyWereMeasured) {
    test::Random random(14);
    const BenchReport report = test::MadeReport(random).fill();
    const Json json = toJson(report);
    ASSERT_EQ(json["fidelity"].size(), report.fidelity.size());
    for (std::size_t i = 0; i < report.fidelity.size(); ++i) {
        EXPECT_EQ(json["fidelity"][i]["rung"], name(report.fidelity[i].rung));
        EXPECT_EQ(json["fidelity"][i]["field_deg"], report.fidelity[i].fieldDeg);
        EXPECT_EQ(json["fidelity"][i]["worst_db"], report.fidelity[i].worstDb);
    }
    ASSERT_EQ(json["walk"].size(), report.walk.size());
    for (std::size_t i = 0; i < report.walk.size(); ++i) {
        EXPECT_EQ(json["walk"][i]["speed_m_s"], report.walk[i].speedMS);
        EXPECT_EQ(json["walk"][i]["prefetch"], report.walk[i].prefetch);
        EXPECT_EQ(json["walk"][i]["missed_share"], report.walk[i].missedShare);
        EXPECT_EQ(json["walk"][i]["late_at_start"], report.walk[i].lateAtStart);
    }
    EXPECT_EQ(json["walk_photos"], 404);
    EXPECT_EQ(json["walk_copies"], true);
}

} // namespace spherewalk::bench
