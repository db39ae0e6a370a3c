// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli_run.h"
#include "made_dataset.h"
#include "temporary_folder.h"

#include "spherewalk/base/json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <set>

namespace spherewalk {

using test::CliResult;
using test::runCli;
using testing::HasSubstr;

namespace {

void expectBenchRefused(const std::vector<std::string>& arguments, const std::string& part) {
    const CliResult result = runCli(arguments);
    EXPECT_EQ(result.status, 1) << result.errors;
    EXPECT_THAT(result.errors, HasSubstr(part));
    EXPECT_EQ(result.output, "");
}

} // namespace

TEST(BenchCommand, MeasuresAllThatIsPromisedAndDrawsIt) {
    const test::TemporaryFolder folder;
    const std::string dataset = test::writeMadeDataset(folder.path());
    const std::string plot = folder / "plot.svg";
    const CliResult result =
        runCli({"bench", dataset, "--quick", "--peers", "--grid=8", "--plot", plot, "--json"});
    ASSERT_EQ(result.status, 0) << result.errors;
    const Json json = result.json();
    std::set<std::string> names;
    std::set<std::string> peers;
    for (const Json& row : json["rows"]) {
        names.insert(row["name"]);
        EXPECT_GT(row["median_ms"].get<double>(), 0);
        if (!row["peer"].is_null()) {
            peers.insert(row["peer"]);
            EXPECT_NEAR(row["ratio"].get<double>(),
                        row["peer_median_ms"].get<double>() / row["median_ms"].get<double>(), 1e-9);
        }
    }
    for (const char* rung : {"nearest", "bilinear", "reduced", "footprint", "bicubic"}) {
        for (const char* setting : {"", ".steep", ".57", ".57.steep"}) {
            EXPECT_TRUE(names.contains(std::string("view.") + rung + setting)) << rung << setting;
        }
    }
    for (const char* name : {"decode.whole", "decode.region", "decode.reduced", "decode.thumbnail",
                             "decode.whole.planes", "decode.region.planes", "cold_cell"}) {
        EXPECT_TRUE(names.contains(name)) << name;
    }
    for (const char* peer : {"OpenCV maps + remap", "OpenCV remap", "OpenCV remap, same map",
                             "libjpeg-turbo, whole photo", "whole decode + render"}) {
        EXPECT_TRUE(peers.contains(peer)) << peer;
    }
    EXPECT_EQ(json["fidelity"].size(), 10U); // five rungs, two fields of view
    EXPECT_GT(json["fidelity"][0]["mean_db"].get<double>(), 20);
    EXPECT_LE(json["lattice"]["worst_px"].get<double>(), 0.02);
    EXPECT_NE(json["lattice"]["where"], "");
    EXPECT_EQ(json["walk"].size(), 12U); // three speeds, three policies with prefetch and one without
    EXPECT_EQ(json["walk_photos"], 8);
    EXPECT_GT(json["resident_bytes"].get<double>(), 1e6);
    EXPECT_TRUE(json["machine"]["simd"].is_string());
    EXPECT_THAT(readTextFile(plot), HasSubstr("</svg>"));
}

TEST(BenchCommand, RefusesBadInputBeforeItMeasures) {
    test::TemporaryFolder folder;
    folder.leaveUnchecked();
    const std::string dataset = test::writeMadeDataset(folder.path());
    expectBenchRefused({"bench", folder / "nowhere"}, "nowhere");
    expectBenchRefused({"bench", dataset, "--plot", folder / "plot.png"}, "ends in .svg");
    expectBenchRefused({"bench", dataset, "--plot", folder / "no/plot.svg"}, "there is no folder");
    expectBenchRefused({"bench", dataset, "--fields", "0"}, "1 to 170");
    Json json = parseJson(readTextFile(folder / "dataset/dataset.json"), "dataset.json");
    json["photos"] = Json::array();
    writeFile(folder / "dataset/dataset.json", bytesOf(json.dump()));
    expectBenchRefused({"bench", dataset}, "no photos");
}

TEST(BenchCommand, CtrlCStopsItWithStatusThree) {
    const test::TemporaryFolder folder;
    const std::string dataset = test::writeMadeDataset(folder.path());
    test::Program program({SPHEREWALK_CLI, "bench", dataset});
    ASSERT_NE(program.waitForError(" %"), "");
    program.signal(SIGINT);
    EXPECT_EQ(program.wait(), 3);
    EXPECT_THAT(program.errors(), HasSubstr("Stopped"));
    EXPECT_EQ(program.output(), "");
}

} // namespace spherewalk
