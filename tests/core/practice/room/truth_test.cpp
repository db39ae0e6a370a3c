// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "random.h"
#include "temporary_folder.h"

#include "spherewalk/base/file.h"
#include "spherewalk/practice/truth.h"

#include <gtest/gtest.h>

namespace spherewalk::practice {
namespace {

using test::expectError;

Truth randomTruth(test::Random& random, int shot) {
    Truth truth;
    truth.file = "R001000" + std::to_string(shot) + ".JPG";
    truth.urlPath = "/files/00ff/100RICOH/" + truth.file;
    truth.shot = shot;
    truth.nominalPositionM = random.vector(10);
    truth.positionM = random.vector(10);
    if (shot % 3 != 0) {
        truth.roomFromPhoto = random.rotation();
    }
    truth.time = "2026-02-28T23:00:00.000Z";
    truth.sha256 = std::string(64, 'a');
    truth.options = {{"iso", 100 * shot}, {"whiteBalance", "auto"}};
    truth.byButton = shot % 2 == 0;
    return truth;
}

TEST(PracticeTruth, IsReadAsItWasWritten) {
    const test::TemporaryFolder folder;
    test::Random random(8);
    SCOPED_TRACE(random.seed());
    std::vector<Truth> written;
    for (int shot = 1; shot <= 9; ++shot) {
        written.push_back(randomTruth(random, shot));
        TruthFile(folder / "truth.jsonl").append(written.back());
    }
    const std::vector<Truth> read = readTruth(folder / "truth.jsonl");
    ASSERT_EQ(read.size(), written.size());
    for (std::size_t i = 0; i < read.size(); ++i) {
        EXPECT_EQ(read[i].file, written[i].file);
        EXPECT_EQ(read[i].urlPath, written[i].urlPath);
        EXPECT_EQ(read[i].shot, written[i].shot);
        EXPECT_EQ(read[i].nominalPositionM, written[i].nominalPositionM) << "numbers keep all their digits";
        EXPECT_EQ(read[i].positionM, written[i].positionM);
        ASSERT_EQ(read[i].roomFromPhoto.has_value(), written[i].roomFromPhoto.has_value());
        if (read[i].roomFromPhoto) {
            EXPECT_LT(read[i].roomFromPhoto->angularDistance(*written[i].roomFromPhoto), 1e-12);
        }
        EXPECT_EQ(read[i].time, written[i].time);
        EXPECT_EQ(read[i].sha256, written[i].sha256);
        EXPECT_EQ(read[i].options, written[i].options);
        EXPECT_EQ(read[i].byButton, written[i].byButton);
    }
}

TEST(PracticeTruth, ALastLineThatWasCutShortIsLeftOut) {
    const test::TemporaryFolder folder;
    const std::filesystem::path file = folder / "truth.jsonl";
    test::Random random(9);
    SCOPED_TRACE(random.seed());
    TruthFile(file).append(randomTruth(random, 1));
    const std::string first = readTextFile(file, 1 << 20);
    TruthFile(file).append(randomTruth(random, 2));
    const std::string both = readTextFile(file, 1 << 20);
    for (const std::size_t end : {first.size() + 1, (first.size() + both.size()) / 2, both.size() - 2}) {
        writeFile(file, bytesOf(both.substr(0, end)));
        EXPECT_EQ(readTruth(file).size(), 1U) << end;
    }
    writeFile(file, bytesOf(both));
    EXPECT_EQ(readTruth(file).size(), 2U);
}

TEST(PracticeTruth, AnythingElseIsCorrupt) {
    const test::TemporaryFolder folder;
    const std::filesystem::path file = folder / "truth.jsonl";
    expectError(ErrorKind::NotFound, "truth.jsonl", [&] { readTruth(file); });
    writeFile(file, bytesOf("no line\n{}\n"));
    expectError(ErrorKind::Corrupt, "truth.jsonl", [&] { readTruth(file); });
    writeFile(file, bytesOf("{}\n"));
    expectError(ErrorKind::Corrupt, "truth.jsonl", [&] { readTruth(file); });
    writeFile(file, {});
    EXPECT_TRUE(readTruth(file).empty());
}

} // namespace
} // namespace spherewalk::practice
