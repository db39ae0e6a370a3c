// SPDX-License-Identifier: Apache-2.0
#include "expect_error.h"
#include "temporary_folder.h"

#include "spherewalk/base/file.h"
#include "spherewalk/base/sha256.h"

namespace spherewalk {

// The digests are the examples of FIPS 180-4.
TEST(Sha256, GivesThePublishedDigests) {
    EXPECT_EQ(sha256Hex({}), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256Hex(bytesOf("abc")), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(Sha256, IsTheSameInPiecesAndFromAFile) {
    const test::TemporaryFolder folder;
    Bytes bytes(3'000'001);
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        bytes[i] = static_cast<std::uint8_t>(i * 7);
    }
    Sha256 hash;
    hash.update(ByteView(bytes).first(1000));
    hash.update(ByteView(bytes).subspan(1000));
    const std::string whole = sha256Hex(bytes);
    EXPECT_EQ(hash.hex(), whole);
    writeFile(folder / "f", bytes);
    EXPECT_EQ(sha256HexOfFile(folder / "f"), whole);
    test::expectError(ErrorKind::NotFound, "absent", [&] { sha256HexOfFile(folder / "absent"); });
}

} // namespace spherewalk
