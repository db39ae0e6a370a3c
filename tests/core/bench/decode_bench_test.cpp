// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "kept_progress.h"
#include "made_dataset.h"
#include "measurements.h"
#include "temporary_folder.h"

#include "spherewalk/base/parallel.h"

#include <algorithm>
#include <cctype>

namespace spherewalk::bench {

using test::expectError;

namespace {

class DecodeRows : public testing::Test {
  protected:
    std::vector<BenchRow> rows(bool peers = false) const {
        return measureDecoding(BenchPhoto(m_dataset), peers, 1, noProgress(), {});
    }

    static std::uint64_t bytesOfRow(const std::vector<BenchRow>& rows, const std::string& name) {
        const auto found =
            std::find_if(rows.begin(), rows.end(), [&](const BenchRow& row) { return row.name == name; });
        return found == rows.end() ? 0 : found->bytes;
    }

    test::TemporaryFolder m_folder;
    std::shared_ptr<const render::Dataset> m_dataset = test::openMadeDataset(m_folder.path());
};

} // namespace

TEST_F(DecodeRows, SayHowManyBytesEachPartHas) {
    const jpeg::PixelRect region = regionAhead(standardCamera(90), {512, 256});
    const auto pixels = static_cast<std::uint64_t>(region.width) * static_cast<std::uint64_t>(region.height);
    const std::vector<BenchRow> all = rows();
    EXPECT_EQ(bytesOfRow(all, "decode.region"), 3 * pixels);
    EXPECT_EQ(bytesOfRow(all, "decode.reduced"), 3 * pixels / 4);
    EXPECT_EQ(bytesOfRow(all, "decode.thumbnail"), 3U * 128 * 64);
    EXPECT_EQ(bytesOfRow(all, "decode.whole.planes"), 512U * 256 * 3 / 2); // chroma has a quarter of luma
    EXPECT_EQ(bytesOfRow(all, "decode.region.planes"), pixels * 3 / 2);
}

TEST_F(DecodeRows, AreForOneThreadAndForTwoWhereTheMachineHasTwo) {
    const std::vector<BenchRow> all = rows();
    for (const char* name : {"decode.whole", "decode.region", "decode.reduced", "decode.whole.planes"}) {
        std::vector<int> threads;
        for (const BenchRow& row : all) {
            if (row.name == name) {
                threads.push_back(row.threads);
            }
        }
        EXPECT_EQ(threads, hardwareThreads() > 1 ? (std::vector<int>{1, 2}) : std::vector<int>{1}) << name;
    }
}

TEST_F(DecodeRows, AreComparedWithOneTimeOfThePeer) {
    double medianMs = 0;
    for (const BenchRow& row : rows(true)) {
        if (row.peer) {
            EXPECT_EQ(row.peer->name, kLibjpegWhole);
            EXPECT_TRUE(medianMs == 0 || row.peer->medianMs == medianMs) << row.name;
            medianMs = row.peer->medianMs;
        }
    }
    EXPECT_GT(medianMs, 0);
}

TEST_F(DecodeRows, NameAnIndexThatIsDamaged) {
    const std::string index = m_dataset->info().photos.front().restartIndex;
    writeFile(m_dataset->folder() / index, bytesOf("no index"));
    expectError(ErrorKind::Corrupt, index, [&] { rows(); });
}

TEST_F(DecodeRows, ReportProgressThatRisesToTheWhole) {
    test::KeptProgress progress;
    measureDecoding(BenchPhoto(m_dataset), false, 2, progress, {});
    EXPECT_TRUE(std::is_sorted(progress.fractions.begin(), progress.fractions.end()));
    EXPECT_EQ(progress.fractions.back(), 1);
}

TEST(RegionAhead, HoldsWholeMcusAroundTheMiddle) {
    for (const double fieldDeg : {10.0, 57.0, 90.0}) {
        for (const int width : {512, 1024, 5376}) {
            const jpeg::PixelRect region = regionAhead(standardCamera(fieldDeg), {width, width / 2});
            EXPECT_EQ(region.x % 16 + region.y % 16 + region.width % 16 + region.height % 16, 0);
            EXPECT_LT(region.x, width / 2);
            EXPECT_GT(region.x + region.width, width / 2);
            // No more than two MCUs around the field of view.
            EXPECT_LE(region.width, width * fieldDeg / 360 + 2 * 16 + 1);
        }
    }
}

TEST(WalkPhases, BeginWithNothingInMemory) {
    const test::TemporaryFolder folder;
    const auto dataset = test::openMadeDataset(folder.path());
    for (const WalkRow& row : measureWalks(dataset, {{2}, 1}, noProgress(), {})) {
        EXPECT_GE(row.lateAtStart, 1) << name(row.policy);
        EXPECT_LE(row.lateAtStart, 10) << name(row.policy);
        EXPECT_TRUE(row.lateShare == 0 || row.lateShare == 1) << name(row.policy); // of one view
        EXPECT_EQ(row.missedShare > 0, row.p99Ms > 1000.0 / 30) << name(row.policy);
    }
}

TEST(WalkPhases, LookAtNoPhotoWhereNoneIsAskedFor) {
    const test::TemporaryFolder folder;
    EXPECT_EQ(lookAllRound(test::openMadeDataset(folder.path()), 0, noProgress(), {}), 0U);
}

TEST(Machine, HasAVersionThatBeginsWithNumbers) {
    const Machine machine = thisMachine({});
    EXPECT_THAT(machine.version, testing::ContainsRegex("^[0-9]+\\.[0-9]+"));
    EXPECT_EQ(machine.peerVersion, ""); // which bench() fills
    EXPECT_TRUE(std::none_of(machine.processor.begin(), machine.processor.end(),
                             [](unsigned char letter) { return std::iscntrl(letter) != 0; }));
}

TEST(Machine, PeakOfMemoryNeverFalls) {
    const std::uint64_t before = peakResidentBytes();
    { const std::vector<char> used(8 << 20, 1); }
    EXPECT_GE(peakResidentBytes(), before);
}

} // namespace spherewalk::bench
