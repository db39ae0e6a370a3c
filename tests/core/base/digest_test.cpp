// SPDX-License-Identifier: Apache-2.0
#include "expect_error.h"
#include "temporary_folder.h"

#include "spherewalk/base/digest.h"
#include "spherewalk/base/file.h"

#include <regex>
#include <set>

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

/// Source: RFC 1321, A.5.
TEST(Md5, IsThatOfTheStandard) {
    EXPECT_EQ(md5Hex(bytesOf("")), "d41d8cd98f00b204e9800998ecf8427e");
    EXPECT_EQ(md5Hex(bytesOf("message digest")), "f96b697d7cb7938d525a2f31aaf161d0");
}

TEST(Uuid, IsRandomAndOfVersion4) {
    const std::regex shape("[0-9a-f]{8}-[0-9a-f]{4}-4[0-9a-f]{3}-[89ab][0-9a-f]{3}-[0-9a-f]{12}");
    std::set<std::string> seen;
    for (int i = 0; i < 100; ++i) {
        const std::string uuid = randomUuid();
        EXPECT_TRUE(std::regex_match(uuid, shape)) << uuid;
        EXPECT_TRUE(seen.insert(uuid).second) << uuid;
    }
}

} // namespace spherewalk
