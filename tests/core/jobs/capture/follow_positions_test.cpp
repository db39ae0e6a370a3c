// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "random.h"

#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/follow_positions.h"

namespace spherewalk::jobs {

using test::expectError;

namespace {

void expectRefused(std::string_view words) {
    SCOPED_TRACE(std::string(words.substr(0, 60)));
    expectError(ErrorKind::InvalidInput, "", [&] { parseReachedPosition(words); });
}

FollowEvent followEvent(FollowEvent::Kind kind, const std::string& verdict, const std::string& sentence) {
    return {kind, "rail 1, stop 2", verdict, sentence};
}

} // namespace

TEST(ReachedPosition, IsThePlaceThatWasWrittenInWordsOrJson) {
    for (unsigned seed = 1; seed <= 100; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        const ReachedPosition sent{random.vector(100), random.integer(0, 1) == 1};
        const Eigen::Vector3d& p = sent.positionM;
        ASSERT_EQ(parseReachedPosition(text(p.x(), " ", p.y(), " ", p.z(), sent.again ? " again" : "")),
                  sent);
        const Json json{{"x", p.x()}, {"y", p.y()}, {"z", p.z()}, {"again", sent.again}};
        ASSERT_EQ(parseReachedPosition(json.dump()), sent);
    }
}

TEST(ReachedPosition, MayStandBetweenBlanks) {
    const ReachedPosition expected{{1, -2, 0.5}, false};
    for (const char* words : {"1 -2 0.5", "  1\t-2   0.5  ", "1 -2 0.5\r", "\t1 -2 5e-1"}) {
        EXPECT_EQ(parseReachedPosition(words), expected) << words;
    }
    EXPECT_EQ(parseReachedPosition("  {\"x\": 1, \"y\": -2, \"z\": 0.5}"), expected);
}

TEST(ReachedPosition, IsTakenAgainOnlyIfTheLineSaysSo) {
    EXPECT_FALSE(parseReachedPosition("1 2 3").again);
    EXPECT_TRUE(parseReachedPosition("1 2 3 again").again);
    EXPECT_FALSE(parseReachedPosition(R"({"x": 1, "y": 2, "z": 3, "again": false})").again);
    EXPECT_TRUE(parseReachedPosition(R"({"x": 1, "y": 2, "z": 3, "again": true})").again);
    EXPECT_FALSE(parseReachedPosition(R"({"x": 1, "y": 2, "z": 3, "again": null})").again);
}

TEST(ReachedPosition, IgnoresWhatElseAnObjectHas) {
    EXPECT_EQ(parseReachedPosition(R"({"robot": "a", "x": 1, "y": 2, "z": 3})").positionM,
              Eigen::Vector3d(1, 2, 3));
}

TEST(ReachedPosition, RefusesWordsThatAreNoPosition) {
    for (const char* words :
         {"", " ", "\r", "1 2", "1 2 x", "a b c", "1 2 3 4", "1 2 3 Again", "1 2 3 again now", "1,2,3",
          "1 2 3again", "nan 0 0", "inf 0 0", "0 0 1e9", "-1e9 0 0", "again"}) {
        expectRefused(words);
    }
}

TEST(ReachedPosition, RefusesJsonThatIsNoPosition) {
    for (const char* words :
         {"{", "{}", "{\"x\": 1}", R"({"x": 1, "y": 2})", R"({"x": "1", "y": 2, "z": 3})",
          R"({"x": null, "y": 2, "z": 3})", R"({"x": 1, "y": 2, "z": 3, "again": 1})",
          R"({"x": 1, "y": 2, "z": 1e300})", R"({"x": 1, "y": 2, "z": 3} x)", "[1, 2, 3]"}) {
        expectRefused(words);
    }
}

TEST(ReachedPosition, RefusesLinesWithoutAnEnd) {
    expectRefused("1 2 3" + std::string(1 << 20, ' '));
    expectRefused("{\"x\": 1, \"y\": 2, \"z\": " + std::string(1 << 20, '1') + "}");
    expectRefused("{\"a\": " + std::string(1000, '[') + std::string(1000, ']') + "}");
}

TEST(ReachedPosition, ShowsNoControlLettersOfARefusedLine) {
    try {
        parseReachedPosition("\x1b[2J 1 2");
        ADD_FAILURE() << "taken for a position";
    } catch (const Error& error) {
        EXPECT_EQ(error.sentence().find('\x1b'), std::string::npos) << error.sentence();
    }
}

TEST(FollowEvent, IsALineForARobotThatReadsWords) {
    EXPECT_EQ(line(followEvent(FollowEvent::Kind::Exposed, "", "")), "exposed rail 1, stop 2");
    EXPECT_EQ(line(followEvent(FollowEvent::Kind::Verdict, "good", "")), "good rail 1, stop 2");
    EXPECT_EQ(line(followEvent(FollowEvent::Kind::Verdict, "doubtful", "It is blurred.")),
              "doubtful rail 1, stop 2: It is blurred.");
    EXPECT_EQ(line(followEvent(FollowEvent::Kind::Missed, "", "The camera is gone.")),
              "missed rail 1, stop 2: The camera is gone.");
    EXPECT_EQ(line({FollowEvent::Kind::Refused, "", "", "No station is there."}),
              "refused: No station is there.");
}

TEST(FollowEvent, IsAnObjectWithWhatThereIsToSay) {
    EXPECT_EQ(toJson(followEvent(FollowEvent::Kind::Exposed, "", "")),
              (Json{{"event", "exposed"}, {"station", "rail 1, stop 2"}}));
    EXPECT_EQ(toJson(followEvent(FollowEvent::Kind::Verdict, "failed", "It is black.")),
              (Json{{"event", "verdict"},
                    {"station", "rail 1, stop 2"},
                    {"verdict", "failed"},
                    {"sentence", "It is black."}}));
    EXPECT_EQ(toJson({FollowEvent::Kind::Refused, "", "", "No."}),
              (Json{{"event", "refused"}, {"sentence", "No."}}));
}

TEST(FollowOptions, NeedATolerance) {
    for (const double tolerance : {0.001, 0.03, 1.0}) {
        FollowOptions options;
        options.camera.download.check = photoCheck();
        options.toleranceM = tolerance;
        EXPECT_NO_THROW(options.validate()) << tolerance;
    }
    for (const double tolerance : {0.0, -0.1, 1.01, std::numeric_limits<double>::quiet_NaN()}) {
        FollowOptions options;
        options.camera.download.check = photoCheck();
        options.toleranceM = tolerance;
        SCOPED_TRACE(tolerance);
        expectError(ErrorKind::InvalidInput, "tolerance", [&] { options.validate(); });
    }
}

} // namespace spherewalk::jobs
