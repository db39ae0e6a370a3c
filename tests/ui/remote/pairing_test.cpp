// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/remote/pairing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

namespace spherewalk::ui {

namespace {

std::string otherThan(std::string code) {
    code.back() = code.back() == '0' ? '1' : '0';
    return code;
}

} // namespace

TEST(Pairing, CodesAreSixDigitsAndDiffer) {
    std::set<std::string> codes;
    Pairing pairing;
    for (int i = 0; i < 50; ++i) {
        pairing.renew();
        const std::string code = pairing.code();
        EXPECT_EQ(code.size(), 6U);
        EXPECT_TRUE(std::ranges::all_of(code, [](char c) { return c >= '0' && c <= '9'; })) << code;
        codes.insert(code);
    }
    EXPECT_GE(codes.size(), 45U);
}

TEST(Pairing, TheCodePairsOneDevice) {
    Pairing pairing;
    const std::string code = pairing.code();
    EXPECT_EQ(pairing.pair(otherThan(code)), Pairing::Answer::Wrong);
    EXPECT_FALSE(pairing.isPaired());
    EXPECT_EQ(pairing.pair(code), Pairing::Answer::Paired);
    EXPECT_TRUE(pairing.isPaired());
    EXPECT_EQ(pairing.code(), "");
    EXPECT_EQ(pairing.pair(code), Pairing::Answer::Taken);
    EXPECT_EQ(pairing.session().size(), 64U);
    EXPECT_NE(pairing.session(), pairing.token());
}

TEST(Pairing, TheCodeIsVoidAfterTooManyWrongOnes) {
    Pairing pairing;
    const std::string code = pairing.code();
    for (int i = 1; i < Pairing::kTries; ++i) {
        EXPECT_EQ(pairing.pair(otherThan(code)), Pairing::Answer::Wrong);
    }
    EXPECT_EQ(pairing.pair(otherThan(code)), Pairing::Answer::Void);
    EXPECT_EQ(pairing.pair(code), Pairing::Answer::Void);
    EXPECT_EQ(pairing.pair(""), Pairing::Answer::Void) << "an empty code is none";
    pairing.renew();
    EXPECT_EQ(pairing.pair(pairing.code()), Pairing::Answer::Paired);
}

TEST(Pairing, OnlyTheWholeSecretIsOne) {
    Pairing pairing;
    EXPECT_FALSE(pairing.isSession("")) << "nobody is paired";
    EXPECT_FALSE(pairing.isToken(""));
    pairing.pair(pairing.code());
    const std::string session = pairing.session();
    EXPECT_TRUE(pairing.isSession(session));
    EXPECT_FALSE(pairing.isSession(session.substr(1)));
    EXPECT_FALSE(pairing.isSession(session + "0"));
    EXPECT_FALSE(pairing.isSession(otherThan(session)));
    EXPECT_FALSE(pairing.isToken(session));
    pairing.renew();
    EXPECT_FALSE(pairing.isSession(session)) << "the device was let go of";
}

} // namespace spherewalk::ui
