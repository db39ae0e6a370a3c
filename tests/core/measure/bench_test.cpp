// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "made_dataset.h"
#include "temporary_folder.h"

#include "spherewalk/measure/bench.h"

namespace spherewalk::measure {

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

} // namespace

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

} // namespace spherewalk::measure
