// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/base/md5.h"

#include <gtest/gtest.h>

namespace spherewalk {

/// Source: RFC 1321, A.5.
TEST(Md5, IsThatOfTheStandard) {
    EXPECT_EQ(md5Hex(bytesOf("")), "d41d8cd98f00b204e9800998ecf8427e");
    EXPECT_EQ(md5Hex(bytesOf("message digest")), "f96b697d7cb7938d525a2f31aaf161d0");
}

} // namespace spherewalk
