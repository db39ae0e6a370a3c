// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "kept_progress.h"
#include "made_dataset.h"
#include "markup.h"
#include "measurements.h"
#include "sensor_rows.h"
#include "temporary_folder.h"

#include "spherewalk/base/json.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/base/text.h"
#include "spherewalk/bench/bench.h"

#include <algorithm>
#include <limits>
#include <set>

namespace spherewalk::bench {

using test::expectError;

namespace {

/// Asks to stop at the first progress, and counts what is reported thereafter.
class StopAtOnce : public ProgressSink {
  public:
    void progress(double /*fraction*/, std::string_view /*activity*/) override {
        ++reports;
        source.request_stop();
    }

    void warning(std::string_view /*sentence*/) override {}

    std::stop_source source;
    int reports = 0;
};

BenchOptions withFields(const std::vector<double>& fieldsDeg) {
    BenchOptions options;
    options.fieldsDeg = fieldsDeg;
    return options;
}

BenchOptions withCopies(int gridPhotos) {
    BenchOptions options;
    options.gridPhotos = gridPhotos;
    return options;
}

std::set<std::string> namesOfAllRows() {
    std::set<std::string> names{"view.with_depth",
                                "view.with_trust",
                                "view.with_overlay",
                                "view.with_overlay.shadow",
                                "view.with_overlay.other_lens",
                                "decode.whole",
                                "decode.region",
                                "decode.reduced",
                                "decode.thumbnail",
                                "decode.whole.planes",
                                "decode.region.planes",
                                "cold_cell",
                                "cold_cell.unverified",
                                "cold_cell.disk"};
    names.merge(test::sensorRows());
    for (const render::Sampling rung : kRungs) {
        for (const ViewSetting& setting :
             {ViewSetting{90, 0}, ViewSetting{90, 80}, ViewSetting{57, 0}, ViewSetting{57, 80}}) {
            names.insert(viewRowName(rung, setting));
        }
    }
    return names;
}

void expectAllRows(const BenchReport& report) {
    std::set<std::string> names;
    for (const BenchRow& row : report.rows) {
        names.insert(row.name);
        EXPECT_GT(row.own.medianMs, 0) << row.name;
        EXPECT_TRUE(std::isfinite(row.own.madMs)) << row.name;
        EXPECT_LE(row.threads, std::max(2, hardwareThreads())) << row.name;
        EXPECT_EQ(row.bytes > 0, row.name.starts_with("decode.")) << row.name;
        EXPECT_EQ(row.view.has_value(), !row.name.starts_with("decode.")) << row.name;
        EXPECT_TRUE(!row.peer || row.peer->medianMs > 0) << row.name;
    }
    EXPECT_EQ(names, namesOfAllRows());
}

void expectFiguresOfTheDataset(const BenchReport& report, const render::DatasetInfo& info) {
    EXPECT_EQ(report.measurand.dataset, info.name);
    EXPECT_EQ(report.measurand.photos, info.photos.size());
    EXPECT_EQ(report.measurand.photoWidth, info.photos.front().width);
    EXPECT_EQ(report.measurand.photoBytes, info.photos.front().sizeBytes);
    EXPECT_TRUE(report.measurand.decodesParts);
    EXPECT_EQ(report.walkedPast.photos, info.photos.size());
    EXPECT_NEAR(report.walkedPast.lengthM, 1, 1e-9);
    EXPECT_FALSE(report.walkedPast.copies);
    EXPECT_EQ(report.residence.photos, info.photos.size());
    EXPECT_GT(report.residence.peakBytes, std::uint64_t{1} << 20);
}

void expectWalksAndErrors(const BenchReport& report) {
    EXPECT_EQ(report.walk.size(), 12U); // three speeds, three policies and one without prefetch
    for (const WalkRow& row : report.walk) {
        EXPECT_EQ(row.views, 20);
        EXPECT_GE(row.lateAtStart, 1); // it begins with nothing in memory
        EXPECT_LE(row.lateAtStart, 10);
    }
    EXPECT_EQ(report.fidelity.size(), kRungs.size());
    EXPECT_EQ(report.fidelity.front().fieldDeg, 57);
    ASSERT_EQ(report.lattice.size(), kLatticeSearches.size());
    for (const LatticeRow& row : report.lattice) {
        EXPECT_LE(row.error.worstPx, 0.018 + 0.0015) << row.error.where;
    }
}

void expectThatAllShowTheSame(const BenchReport& report) {
    const Json json = toJson(report);
    EXPECT_EQ(json["rows"].size(), report.rows.size());
    EXPECT_EQ(json["walk"].size(), report.walk.size());
    const std::string table = benchTable(report);
    EXPECT_THAT(table, testing::HasSubstr("A quick run: the figures are rough."));
    EXPECT_THAT(table, testing::HasSubstr(report.machine.processor));
    EXPECT_THAT(table, testing::Not(testing::HasSubstr("nan")));
    const BenchRow& view = *report.find("view.footprint", 1);
    EXPECT_THAT(table, testing::HasSubstr(text(fixed(view.own.medianMs, 2), " ms on one thread")));
    const std::string plot = benchPlot(report);
    EXPECT_EQ(test::markupDefect(plot), "");
    EXPECT_THAT(plot, testing::HasSubstr("Samplings at 57 degrees"));
}

} // namespace

TEST(Bench, MeasuresAllAndShowsTheSameInEachForm) {
    const test::TemporaryFolder folder;
    const auto dataset = test::openMadeDataset(folder.path());
    BenchOptions options = withFields({57});
    options.quick = true;
    test::KeptProgress progress;
    const BenchReport report = bench(dataset, options, progress, {});
    EXPECT_TRUE(report.quick);
    expectAllRows(report);
    expectFiguresOfTheDataset(report, dataset->info());
    expectWalksAndErrors(report);
    expectThatAllShowTheSame(report);
    EXPECT_TRUE(std::is_sorted(progress.fractions.begin(), progress.fractions.end()));
    EXPECT_GE(progress.fractions.front(), 0);
    EXPECT_NEAR(progress.fractions.back(), 1, 1e-12);
}

TEST(BenchOptions, HaveLimitsThatAreAllowedThemselves) {
    BenchOptions().validate();
    withFields({}).validate();
    withFields({1, 170}).validate();
    withCopies(0).validate();
    withCopies(10000).validate();
}

TEST(BenchOptions, AreRefusedWithTheNumberThatIsWrong) {
    for (const auto& [field, words] : {std::pair(0.5, "0.5"),
                                       {170.5, "170.5"},
                                       {-90.0, "-90"},
                                       {std::numeric_limits<double>::quiet_NaN(), "nan"},
                                       {std::numeric_limits<double>::infinity(), "inf"}}) {
        expectError(ErrorKind::InvalidInput, words, [&] { withFields({90, field}).validate(); });
    }
    for (const int copies : {-1, 10001}) {
        expectError(ErrorKind::InvalidInput, std::to_string(copies), [&] { withCopies(copies).validate(); });
    }
}

TEST(Bench, RefusesOptionsThatCannotBe) {
    const test::TemporaryFolder folder;
    const auto dataset = test::openMadeDataset(folder.path());
    BenchOptions options;
    options.gridPhotos = 20000;
    expectError(ErrorKind::InvalidInput, "20000", [&] { bench(dataset, options, noProgress(), {}); });
    options.gridPhotos = 0;
    options.fieldsDeg = {90, 180};
    expectError(ErrorKind::InvalidInput, "180", [&] { bench(dataset, options, noProgress(), {}); });
}

TEST(Bench, StopsAtTheNextStepAndLeavesNothing) {
    const test::TemporaryFolder folder;
    const auto dataset = test::openMadeDataset(folder.path());
    for (const int copies : {0, 50}) {
        StopAtOnce progress;
        BenchOptions options;
        options.gridPhotos = copies;
        expectError(ErrorKind::Stopped, "Stopped",
                    [&] { bench(dataset, options, progress, progress.source.get_token()); });
        EXPECT_EQ(progress.reports, 1);
    }
}

TEST(Bench, NamesThePhotoThatWasChanged) {
    const test::TemporaryFolder folder;
    const auto dataset = test::openMadeDataset(folder.path());
    Bytes bytes = readFile(dataset->folder() / "photos/1.jpg");
    bytes[bytes.size() / 2] ^= 1;
    writeFile(dataset->folder() / "photos/1.jpg", bytes);
    expectError(ErrorKind::Corrupt, "photos/1.jpg", [&] { bench(dataset, {}, noProgress(), {}); });
}

} // namespace spherewalk::bench
