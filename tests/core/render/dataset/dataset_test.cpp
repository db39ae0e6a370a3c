// SPDX-License-Identifier: Apache-2.0
#include "expect_error.h"
#include "temporary_folder.h"
#include "test_dataset.h"

#include "spherewalk/render/dataset.h"

namespace spherewalk::render {

using test::expectError;
using test::TemporaryFolder;

namespace {

Rigid3 at(double x, double y, double z) {
    return {Eigen::Quaterniond::Identity(), {x, y, z}};
}

class DatasetTest : public testing::Test {
  protected:
    DatasetTest() {
        info = test::writeTestDataset(folder.path(), {at(0, 0, 1), at(1, 0, 1), at(1, 0, 1)},
                                      test::smoothWorld, 64);
    }

    TemporaryFolder folder;
    DatasetInfo info;
};

} // namespace

TEST_F(DatasetTest, FindsTheNearestPhotoAndOfSeveralTheFirst) {
    const Dataset dataset = Dataset::open(folder.path(), Verify::Hashes);
    EXPECT_EQ(dataset.nearestPhoto({0.49, 5, 1}), 0U);
    EXPECT_EQ(dataset.nearestPhoto({0.51, 5, 1}), 1U);
    EXPECT_EQ(dataset.nearestPhoto({0.5, 0, 1}), 0U);
}

TEST_F(DatasetTest, RefusesAFolderThatIsNoDataset) {
    const TemporaryFolder empty;
    expectError(ErrorKind::NotFound, "holds no dataset.json", [&] { Dataset::open(empty.path()); });
    expectError(ErrorKind::NotFound, "absent", [&] { Dataset::open(folder / "absent"); });
    writeFile(folder / kDatasetFile, bytesOf(std::string(1'000'000, '[')));
    expectError(ErrorKind::Corrupt, "nests deeper", [&] { Dataset::open(folder.path()); });
}

TEST_F(DatasetTest, NamesTheFileThatIsMissingShortOrChanged) {
    Bytes photo = readFile(folder / "photos/1.jpg");
    std::filesystem::remove(folder / "photos/1.jpg");
    expectError(ErrorKind::NotFound, "photos/1.jpg is missing", [&] { Dataset::open(folder.path()); });

    writeFile(folder / "photos/1.jpg", ByteView(photo).first(photo.size() - 1));
    expectError(ErrorKind::Corrupt, "photos/1.jpg has", [&] { Dataset::open(folder.path()); });

    photo[photo.size() / 2] ^= 1;
    writeFile(folder / "photos/1.jpg", photo);
    expectError(ErrorKind::Corrupt, "photos/1.jpg was changed",
                [&] { Dataset::open(folder.path(), Verify::Hashes); });
    const Dataset dataset = Dataset::open(folder.path(), Verify::Sizes);
    EXPECT_NO_THROW(dataset.readPhoto(0));
    expectError(ErrorKind::Corrupt, "photos/1.jpg was changed", [&] { dataset.readPhoto(1); });
}

TEST_F(DatasetTest, MayConsistOfLinksToFilesThatAreHere) {
    const TemporaryFolder elsewhere;
    std::filesystem::rename(folder / "photos/0.jpg", elsewhere / "0.jpg");
    std::filesystem::create_symlink(elsewhere / "0.jpg", folder / "photos/0.jpg");
    EXPECT_NO_THROW(Dataset::open(folder.path(), Verify::Hashes).readPhoto(0));
    std::filesystem::remove(elsewhere / "0.jpg");
    expectError(ErrorKind::NotFound, "photos/0.jpg is a link to a file that is not here",
                [&] { Dataset::open(folder.path()); });
}

TEST_F(DatasetTest, StopsCheckingWhenAsked) {
    std::stop_source stop;
    stop.request_stop();
    expectError(ErrorKind::Stopped, "Stopped",
                [&] { Dataset::open(folder.path(), Verify::Hashes, noProgress(), stop.get_token()); });
}

} // namespace spherewalk::render
