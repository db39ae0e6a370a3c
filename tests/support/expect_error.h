// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/error.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace spherewalk::test {

/// Expects that the call throws an Error of this kind whose sentence contains the part.
template <class Call>
void expectError(ErrorKind kind, const std::string& part, Call&& call) {
    try {
        call();
        ADD_FAILURE() << "no error; expected one whose sentence contains: " << part;
    } catch (const Error& error) {
        EXPECT_EQ(name(error.kind()), name(kind)) << error.sentence();
        EXPECT_THAT(error.sentence(), testing::HasSubstr(part));
    }
}

} // namespace spherewalk::test
