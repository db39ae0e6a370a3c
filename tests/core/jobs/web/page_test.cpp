// SPDX-License-Identifier: GPL-3.0-or-later
#include "program.h"
#include "temporary_folder.h"
#include "test_dataset.h"

#include "spherewalk/jobs/export_place.h"

#include <gtest/gtest.h>

namespace spherewalk::jobs {

/// The room of which page_test.py knows the truth: 3 x 2 x 2.5 m, four photos, the last without a depth.
TEST(WebPage, IsWalkedAndMeasuredInABrowser) {
    const test::TemporaryFolder folder;
    render::DatasetInfo info = test::writeEmptyRoom(folder / "room.dataset");
    info.name = "Room </script><img src=x onerror=\"hacked = 1\">";
    info.outline = info.roomShape->outline;
    info.photos[1].station = "two </script><img src=x onerror=\"hacked = 1\">";
    info.photos[3].depth.clear();
    info.scaleSigma = 0.25;
    test::rewriteInfo(folder / "room.dataset", info);
    exportWeb(folder / "room.dataset", folder / "page", {}, noProgress(), {});
    test::Program browser({SPHEREWALK_PYTHON, "-B", SPHEREWALK_PAGE_TEST, (folder / "page").string()});
    const int status = browser.wait();
    constexpr int kNoBrowser = 77;
    if (status == kNoBrowser) {
        GTEST_SKIP() << "chromium is not installed";
    }
    EXPECT_EQ(status, 0) << browser.output() << browser.errors();
}

} // namespace spherewalk::jobs
