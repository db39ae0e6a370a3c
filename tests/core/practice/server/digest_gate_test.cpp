// SPDX-License-Identifier: GPL-3.0-or-later
#include "random.h"
#include "server/digest_gate.h"

#include "spherewalk/base/bytes.h"
#include "spherewalk/base/digest.h"
#include "spherewalk/base/text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <set>

namespace spherewalk::practice {
namespace {

using testing::HasSubstr;
using testing::Not;

/// What a client answers a challenge with. Source: RFC 7616, section 3.4.
struct ClientAnswer {
    std::string user = "THETAYL00123456";
    std::string password = "00123456";
    std::string realm = "RICOH THETA V";
    std::string method = "GET";
    std::string uri = "/osc/info";
    std::string nonce;
    std::string counter = "00000001";
    std::string clientNonce = "0a4f113b";
    std::string quality = "auth";

    std::string header() const {
        const auto md5 = [](const std::string& words) { return md5Hex(bytesOf(words)); };
        const std::string response =
            md5(text(md5(text(user, ":", realm, ":", password)), ":", nonce, ":", counter, ":", clientNonce,
                     ":", quality, ":", md5(text(method, ":", uri))));
        return text("Digest username=\"", user, "\", realm=\"", realm, "\", nonce=\"", nonce, "\", uri=\"",
                    uri, "\", qop=", quality, ", nc=", counter, ", cnonce=\"", clientNonce, "\", response=\"",
                    response, "\"");
    }
};

class PracticeDigest : public testing::Test {
  protected:
    static std::string nonceIn(const std::string& challenge) {
        const std::string begin = "nonce=\"";
        const std::size_t at = challenge.find(begin) + begin.size();
        return challenge.substr(at, challenge.find('"', at) - at);
    }

    std::string challenge(const std::string& header = {}) {
        return m_gate.challenge("GET", "/osc/info", header);
    }

    ClientAnswer answer() {
        ClientAnswer given;
        given.nonce = nonceIn(challenge());
        return given;
    }

    DigestGate m_gate{"RICOH THETA V", "THETAYL00123456", "00123456", 0, 1};
};

TEST_F(PracticeDigest, AsksWhoSaysNothing) {
    EXPECT_THAT(challenge(), testing::MatchesRegex("Digest realm=\"RICOH THETA V\", nonce=\"[0-9a-f]{32}\", "
                                                   "qop=\"auth\", algorithm=MD5"));
    EXPECT_EQ(challenge(), challenge()) << "the nonce stays until it is used up";
    EXPECT_THAT(challenge("Basic dXNlcjpwYXNz"), HasSubstr("Digest realm"));
    EXPECT_THAT(challenge("Digest "), Not(HasSubstr("stale")));
}

TEST_F(PracticeDigest, LetsTheRightAnswerPass) {
    ClientAnswer right = answer();
    EXPECT_EQ(challenge(right.header()), "");
    right.counter = "00000002";
    EXPECT_EQ(challenge(right.header()), "") << "a nonce is good for many requests";
}

TEST_F(PracticeDigest, EveryPartOfTheAnswerCounts) {
    const auto refuses = [&](auto&& change) {
        ClientAnswer wrong = answer();
        change(wrong);
        return !challenge(wrong.header()).empty();
    };
    EXPECT_TRUE(refuses([](ClientAnswer& a) { a.password = "00123457"; }));
    EXPECT_TRUE(refuses([](ClientAnswer& a) { a.user = "THETAYL00123457"; }));
    EXPECT_TRUE(refuses([](ClientAnswer& a) { a.realm = "RICOH THETA S"; }));
    EXPECT_TRUE(refuses([](ClientAnswer& a) { a.method = "POST"; }));
    EXPECT_TRUE(refuses([](ClientAnswer& a) { a.uri = "/osc/state"; }));
    EXPECT_TRUE(refuses([](ClientAnswer& a) { a.quality = "auth-int"; }));
    EXPECT_TRUE(refuses([](ClientAnswer& a) { a.counter = "1"; }));
    EXPECT_TRUE(refuses([](ClientAnswer& a) { a.nonce = "0123"; }));
    EXPECT_FALSE(refuses([](ClientAnswer& a) { a.clientNonce = "another"; }));
}

TEST_F(PracticeDigest, AnAnswerIsNotGoodTwice) {
    const std::string header = answer().header();
    EXPECT_EQ(challenge(header), "");
    EXPECT_THAT(challenge(header), HasSubstr("stale=true")) << "somebody replays it";
}

TEST_F(PracticeDigest, ARenewedNonceMakesRightAnswersStale) {
    const ClientAnswer before = answer();
    m_gate.renew();
    const std::string again = challenge(before.header());
    EXPECT_THAT(again, HasSubstr("stale=true"));
    ClientAnswer after = before;
    after.nonce = nonceIn(again);
    EXPECT_NE(after.nonce, before.nonce);
    EXPECT_EQ(challenge(after.header()), "");
}

TEST(PracticeDigestOfFewRequests, ANonceIsGoodForSoMany) {
    DigestGate gate("RICOH THETA V", "THETAYL00123456", "00123456", 3, 1);
    std::set<std::string> nonces;
    ClientAnswer given;
    std::string challenge = gate.challenge("GET", "/osc/info", "");
    for (int round = 0; round < 4; ++round) {
        const std::string begin = "nonce=\"";
        const std::size_t at = challenge.find(begin) + begin.size();
        given.nonce = challenge.substr(at, 32);
        EXPECT_TRUE(nonces.insert(given.nonce).second);
        for (int i = 1; i <= 3; ++i) {
            given.counter = text("0000000", i);
            EXPECT_EQ(gate.challenge("GET", "/osc/info", given.header()), "") << round << " " << i;
        }
        given.counter = "00000004";
        challenge = gate.challenge("GET", "/osc/info", given.header());
        EXPECT_THAT(challenge, HasSubstr("stale=true"));
    }
}

TEST(PracticeDigestOfNobody, LetsEverybodyPass) {
    DigestGate gate("RICOH THETA V", "", "", 0, 1);
    EXPECT_EQ(gate.challenge("GET", "/osc/info", ""), "");
    EXPECT_EQ(gate.challenge("GET", "/osc/info", "Digest garbage"), "");
}

/// The responses of the standards' examples: right, but for a nonce of another server, hence stale.
TEST(PracticeDigestOfTheStandards, ResponsesAreTheirs) {
    struct Example {
        std::string realm;
        std::string password;
        std::string nonce;
        std::string clientNonce;
        std::string response;
    };

    const std::array examples{
        // RFC 2617, section 3.5.
        Example{"testrealm@host.com", "Circle Of Life", "dcd98b7102dd2f0e8b11d0f600bfb0c093", "0a4f113b",
                "6629fae49393a05397450978507c4ef1"},
        // RFC 7616, section 3.9.1.
        Example{"http-auth@example.org", "Circle of Life", "7ypf/xlj9XXwfDPEoM4URrv/xwf94BcCAzFZH4GiTo0v",
                "f2/wE4q74E6zIJEtWaHKaf5wv/H5QzzpXusqGemxURZJ", "8ca523f5e9506fed4657c9700eebdbec"},
    };
    for (const Example& one : examples) {
        DigestGate gate(one.realm, "Mufasa", one.password, 0, 1);
        const auto challenge = [&](const std::string& response) {
            return gate.challenge(
                "GET", "/dir/index.html",
                text("Digest username=\"Mufasa\", realm=\"", one.realm, "\", nonce=\"", one.nonce,
                     "\", uri=\"/dir/index.html\", qop=auth, nc=00000001, cnonce=\"", one.clientNonce,
                     "\", response=\"", response, "\", opaque=\"5ccc069c\""));
        };
        EXPECT_THAT(challenge(one.response), HasSubstr("stale=true")) << one.realm;
        std::string wrong = one.response;
        wrong.back() = wrong.back() == '0' ? '1' : '0';
        EXPECT_THAT(challenge(wrong), Not(HasSubstr("stale"))) << one.realm;
    }
}

TEST(PracticeDigestOfGarbage, IsAChallenge) {
    DigestGate gate("RICOH THETA V", "u", "p", 0, 1);
    test::Random random(77);
    SCOPED_TRACE(random.seed());
    for (int i = 0; i < 2000; ++i) {
        std::string header = "Digest ";
        for (int length = random.integer(0, 60); length > 0; --length) {
            header += "=\",ab \x80\xff"[random.integer(0, 7)];
        }
        EXPECT_THAT(gate.challenge("GET", "/", header), HasSubstr("Digest realm")) << header;
    }
}

} // namespace
} // namespace spherewalk::practice
