// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/fault_plan.h"
#include "expect_error.h"
#include "random.h"

#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace spherewalk::practice {
namespace {

using test::expectError;

Fault parsed(const Json& object) {
    return faultOf(JsonReader(object, "the fault"));
}

/// The object that spells the fault, member by member.
Json spelled(const Fault& fault) {
    return {{"fault", name(fault.kind)}, {"on", fault.on},     {"skip", fault.skip},
            {"count", fault.count},      {"byte", fault.byte}, {"amount", fault.amount},
            {"code", fault.code}};
}

TEST(Faults, AreReadAsTheyAreSpelled) {
    test::Random random(19);
    SCOPED_TRACE(random.seed());
    for (int i = 0; i <= static_cast<int>(FaultKind::NoMoreTrouble); ++i) {
        Fault fault;
        fault.kind = static_cast<FaultKind>(i);
        fault.on = text("camera.", random.integer(0, 99));
        fault.skip = random.integer(0, 1000);
        fault.count = random.integer(1, 1000);
        fault.byte = static_cast<std::uint64_t>(random.integer(0, 1 << 30)) * 3;
        fault.amount = random.uniform(0, 1000);
        fault.code = "deviceBusy";
        const Json object = spelled(fault);
        EXPECT_EQ(spelled(parsed(object)), object);
    }
}

TEST(Faults, HaveDefaultsForAllButTheirName) {
    const Fault fault = parsed({{"fault", "reboot"}, {"on", nullptr}});
    EXPECT_EQ(fault.kind, FaultKind::Reboot);
    EXPECT_EQ(fault.on, "");
    EXPECT_EQ(fault.skip, 0);
    EXPECT_EQ(fault.count, 1);
    EXPECT_EQ(fault.byte, 0U);
    EXPECT_EQ(fault.amount, 0);
    EXPECT_EQ(fault.code, "");
}

TEST(Faults, OfNoKnownNameOrTypeAreRefused) {
    expectError(ErrorKind::Corrupt, "earthquake", [] { parsed({{"fault", "earthquake"}}); });
    expectError(ErrorKind::Corrupt, "fault", [] { parsed({{"on", "x"}}); });
    expectError(ErrorKind::Corrupt, "/skip", [] { parsed({{"fault", "hot"}, {"skip", -1}}); });
    expectError(ErrorKind::Corrupt, "/count", [] { parsed({{"fault", "hot"}, {"count", 0}}); });
    expectError(ErrorKind::Corrupt, "/byte", [] { parsed({{"fault", "cut-download"}, {"byte", -1}}); });
    expectError(ErrorKind::Corrupt, "/amount", [] { parsed({{"fault", "slow"}, {"amount", "much"}}); });
    EXPECT_EQ(name(static_cast<FaultKind>(1000)), "unknown");
}

TEST(Faults, ThatMakeNoSenseAreNotArmed) {
    FaultPlan plan;
    const auto refuses = [&](const std::string& part, const Fault& fault) {
        expectError(ErrorKind::InvalidInput, part, [&] { plan.arm(fault); });
    };
    refuses("skip -1", {FaultKind::Hot, "", -1, 1});
    refuses("count 0", {FaultKind::Hot, "", 0, 0});
    refuses("1000", {FaultKind::Slow, "", 0, 1, 0, 1001});
    refuses("1000", {FaultKind::Slow, "", 0, 1, 0, -0.1});
    refuses("1000", {FaultKind::Slow, "", 0, 1, 0, std::numeric_limits<double>::quiet_NaN()});
    refuses("noSuchCode", {FaultKind::Refuse, "", 0, 1, 0, 0, "noSuchCode"});
    EXPECT_TRUE(plan.takeOfCamera("").empty());
}

TEST(FaultPlan, AFaultMeetsItsCallsAfterThoseItSkips) {
    test::Random random(4);
    SCOPED_TRACE(random.seed());
    for (int round = 0; round < 20; ++round) {
        const int skip = random.integer(0, 5);
        const int count = random.integer(1, 5);
        FaultPlan plan;
        plan.arm({FaultKind::Refuse, "camera.x", skip, count});
        for (int call = 0; call < skip + count + 3; ++call) {
            EXPECT_FALSE(plan.take(FaultKind::Refuse, "camera.y")) << "another call is not counted";
            EXPECT_FALSE(plan.take(FaultKind::WebPage, "camera.x")) << "neither is another kind";
            EXPECT_EQ(plan.take(FaultKind::Refuse, "camera.x").has_value(),
                      call >= skip && call < skip + count)
                << call;
        }
    }
}

TEST(FaultPlan, ACallIsMatchedByItsBeginning) {
    FaultPlan plan;
    const auto meets = [&](const std::string& on, const std::string& call) {
        plan.clear();
        plan.arm({FaultKind::EmptyBody, on});
        return plan.take(FaultKind::EmptyBody, call).has_value();
    };
    EXPECT_TRUE(meets("", "/osc/info"));
    EXPECT_TRUE(meets("/files", "/files/abc/R0010001.JPG"));
    EXPECT_TRUE(meets("camera.", "camera.takePicture"));
    EXPECT_FALSE(meets("/osc/info", "/osc"));
    EXPECT_FALSE(meets("takePicture", "camera.takePicture"));
}

TEST(FaultPlan, FaultsOfOneCallComeInTheOrderOfArming) {
    FaultPlan plan;
    plan.arm({FaultKind::Refuse, "", 0, 1, 0, 0, "deviceBusy"});
    plan.arm({FaultKind::WebPage, ""});
    plan.arm({FaultKind::Refuse, "", 0, 1, 0, 0, "notFound"});
    const auto next = [&] { return plan.take({FaultKind::Refuse, FaultKind::WebPage}, "/osc/info"); };
    EXPECT_EQ(next()->code, "deviceBusy");
    EXPECT_EQ(next()->kind, FaultKind::WebPage);
    EXPECT_EQ(next()->code, "notFound");
    EXPECT_FALSE(next());
}

TEST(FaultPlan, WhatHappensToTheCameraComesAllAtOnceAndInNoOtherWay) {
    FaultPlan plan;
    plan.arm({FaultKind::Hot, "/osc/state"});
    plan.arm({FaultKind::EmptyBody, "/osc/state"});
    plan.arm({FaultKind::Battery, "/osc/state", 1, 2, 0, 0.1});
    const auto kinds = [&] {
        std::vector<FaultKind> met;
        for (const Fault& fault : plan.takeOfCamera("/osc/state")) {
            met.push_back(fault.kind);
        }
        return met;
    };
    EXPECT_THAT(kinds(), testing::ElementsAre(FaultKind::Hot));
    EXPECT_THAT(kinds(), testing::ElementsAre(FaultKind::Battery));
    EXPECT_THAT(kinds(), testing::ElementsAre(FaultKind::Battery));
    EXPECT_THAT(kinds(), testing::IsEmpty());
    EXPECT_TRUE(plan.take(FaultKind::EmptyBody, "/osc/state")) << "a fault of answers is still armed";
}

TEST(FaultPlan, TellsFaultsOfTheCameraFromThoseOfAnswers) {
    for (const FaultKind kind :
         {FaultKind::NeverAnswer, FaultKind::Chunked, FaultKind::ForgetIds, FaultKind::HostileMakerNote,
          FaultKind::MissingFile, FaultKind::PreviewStall}) {
        EXPECT_FALSE(isOfCamera(kind)) << name(kind);
    }
    for (const FaultKind kind : {FaultKind::RefuseConnections, FaultKind::Reboot, FaultKind::StorageFull,
                                 FaultKind::Slow, FaultKind::StaleNonce, FaultKind::NoMoreTrouble}) {
        EXPECT_TRUE(isOfCamera(kind)) << name(kind);
    }
}

TEST(FaultPlan, ClearingLeavesNone) {
    FaultPlan plan;
    for (int i = 0; i < 50; ++i) {
        plan.arm({static_cast<FaultKind>(i % 40), "", 0, 1000});
    }
    plan.clear();
    for (int i = 0; i < 40; ++i) {
        EXPECT_FALSE(plan.take(static_cast<FaultKind>(i), "anything"));
    }
    EXPECT_TRUE(plan.takeOfCamera("anything").empty());
}

} // namespace
} // namespace spherewalk::practice
