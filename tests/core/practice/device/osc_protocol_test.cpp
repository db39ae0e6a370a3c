// SPDX-License-Identifier: GPL-3.0-or-later
// Codes, replies, parameters and sessions of the Open Spherical Camera API, without a network.
#include "device/osc_protocol.h"
#include "manual_clock.h"

#include "spherewalk/base/json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <limits>
#include <set>

namespace spherewalk::practice {
namespace {

using std::chrono::seconds;

/// The code that the call is refused with; nothing if it is not refused.
std::optional<OscCode> refusedWith(const std::function<void()>& call) {
    try {
        call();
        return std::nullopt;
    } catch (const OscError& error) {
        return error.code();
    }
}

constexpr std::array kSpelledCodes{
    std::pair{OscCode::UnknownCommand, "unknownCommand"},
    std::pair{OscCode::DisabledCommand, "disabledCommand"},
    std::pair{OscCode::MissingParameter, "missingParameter"},
    std::pair{OscCode::InvalidParameterName, "invalidParameterName"},
    std::pair{OscCode::InvalidParameterValue, "invalidParameterValue"},
    std::pair{OscCode::TooManyParameters, "tooManyParameters"},
    std::pair{OscCode::CorruptedFile, "corruptedFile"},
    std::pair{OscCode::PowerOffSequenceRunning, "powerOffSequenceRunning"},
    std::pair{OscCode::InvalidFileFormat, "invalidFileFormat"},
    std::pair{OscCode::ServiceUnavailable, "serviceUnavailable"},
    std::pair{OscCode::CanceledShooting, "canceledShooting"},
    std::pair{OscCode::CanceledConversion, "canceledConversion"},
    std::pair{OscCode::Unexpected, "unexpected"},
    std::pair{OscCode::NotFound, "notFound"},
    std::pair{OscCode::InvalidSessionId, "invalidSessionId"},
    std::pair{OscCode::CameraInExclusiveUse, "cameraInExclusiveUse"},
    std::pair{OscCode::DeviceBusy, "deviceBusy"},
    std::pair{OscCode::NoFreeSpace, "noFreeSpace"},
    std::pair{OscCode::ServerError, "serverError"},
};

TEST(OscProtocol, EveryCodeIsFoundByItsSpelling) {
    ASSERT_EQ(kSpelledCodes.size(), static_cast<std::size_t>(OscCode::ServerError) + 1);
    for (const auto& [code, spelled] : kSpelledCodes) {
        EXPECT_EQ(oscCode(spelled), code) << spelled;
        EXPECT_EQ(refusal("camera.x", code).body["error"]["code"], spelled);
    }
    EXPECT_EQ(oscCode("DeviceBusy"), std::nullopt) << "spellings distinguish capital letters";
    EXPECT_EQ(oscCode(""), std::nullopt);
}

TEST(OscProtocol, ARefusalHasTheStatusOfTheSpecification) {
    const auto status = [](OscCode code) { return refusal("camera.x", code).status; };
    EXPECT_EQ(status(OscCode::UnknownCommand), 400);
    EXPECT_EQ(status(OscCode::MissingParameter), 400);
    EXPECT_EQ(status(OscCode::InvalidParameterName), 400);
    EXPECT_EQ(status(OscCode::InvalidParameterValue), 400);
    EXPECT_EQ(status(OscCode::CameraInExclusiveUse), 400);
    EXPECT_EQ(status(OscCode::DisabledCommand), 403);
    EXPECT_EQ(status(OscCode::TooManyParameters), 403);
    EXPECT_EQ(status(OscCode::InvalidSessionId), 403);
    EXPECT_EQ(status(OscCode::NoFreeSpace), 403);
    EXPECT_EQ(status(OscCode::NotFound), 404);
    EXPECT_EQ(status(OscCode::ServerError), 500);
    EXPECT_EQ(status(OscCode::ServiceUnavailable), 503);
    EXPECT_EQ(status(OscCode::DeviceBusy), 503);
}

TEST(OscProtocol, ARefusalNamesTheCommandAndSaysWhy) {
    const OscReply reply = refusal("camera.delete", OscCode::TooManyParameters);
    EXPECT_EQ(reply.body["name"], "camera.delete");
    EXPECT_EQ(reply.body["state"], "error");
    EXPECT_THAT(reply.body["error"]["message"].get<std::string>(), testing::EndsWith("."));
    EXPECT_FALSE(reply.body.contains("results"));
}

TEST(OscProtocol, DoneCarriesResultsOnlyWhereThereAreSome) {
    EXPECT_EQ(done("camera.delete").body, (Json{{"name", "camera.delete"}, {"state", "done"}}));
    const OscReply reply = done("camera.listFiles", {{"totalEntries", 0}});
    EXPECT_EQ(reply.status, 200);
    EXPECT_EQ(reply.body["results"]["totalEntries"], 0);
}

TEST(OscParameters, ARequiredOneMustBeThere) {
    const Json parameters = {{"a", nullptr}};
    EXPECT_TRUE(required(parameters, "a").is_null()) << "null is a value";
    EXPECT_EQ(refusedWith([&] { required(parameters, "b"); }), OscCode::MissingParameter);
}

TEST(OscParameters, WholeNumbersAreSpelledWithOrWithoutAFraction) {
    EXPECT_EQ(wholeNumber(7, 0, 10), 7);
    EXPECT_EQ(wholeNumber(7.0, 0, 10), 7);
    EXPECT_EQ(wholeNumber(0, 0, 10), 0) << "the ends belong to the range";
    EXPECT_EQ(wholeNumber(10, 0, 10), 10);
    EXPECT_EQ(wholeNumber(-3, -5, 5), -3);
}

TEST(OscParameters, WhatIsNoWholeNumberInTheRangeIsRefused) {
    const std::array<Json, 9> wrong{Json(-1),    Json(11),     Json(7.5), Json("7"),       Json(true),
                                    Json(1e300), Json(-1e300), Json(),    Json::array({7})};
    for (const Json& value : wrong) {
        EXPECT_EQ(refusedWith([&] { wholeNumber(value, 0, 10); }), OscCode::InvalidParameterValue) << value;
    }
}

TEST(OscParameters, AWordIsOneOfThoseThatAreKnown) {
    EXPECT_EQ(word("image", {"all", "image"}), "image");
    for (const Json& value : {Json("Image"), Json(""), Json(1), Json(), Json::object()}) {
        EXPECT_EQ(refusedWith([&] {
                      word(value, {"all", "image"});
                  }),
                  OscCode::InvalidParameterValue)
            << value;
    }
}

TEST(OscParameters, AFlagHasAFallbackButNoOtherType) {
    const Json parameters = {{"yes", true}, {"no", false}, {"one", 1}, {"null", nullptr}};
    EXPECT_TRUE(flag(parameters, "yes", false));
    EXPECT_FALSE(flag(parameters, "no", true));
    EXPECT_TRUE(flag(parameters, "missing", true));
    EXPECT_FALSE(flag(parameters, "missing", false));
    EXPECT_EQ(refusedWith([&] { flag(parameters, "one", true); }), OscCode::InvalidParameterValue);
    EXPECT_EQ(refusedWith([&] { flag(parameters, "null", true); }), OscCode::InvalidParameterValue);
}

class OscSessions : public testing::Test {
  protected:
    std::optional<OscCode> use(const Json& id) {
        return refusedWith([&] { m_session.use({{"sessionId", id}}); });
    }

    test::ManualClock m_clock;
    OscSession m_session{m_clock, 1};
};

TEST_F(OscSessions, EachHasANameOfItsOwn) {
    std::set<std::string> names;
    for (int i = 0; i < 12; ++i) {
        m_session.end();
        const std::string name = m_session.start();
        EXPECT_THAT(name, testing::MatchesRegex("SID_[0-9]{4}"));
        EXPECT_TRUE(names.insert(name).second) << name;
        EXPECT_EQ(m_session.id(), name);
    }
}

TEST_F(OscSessions, WithoutOneNothingIsAllowed) {
    EXPECT_EQ(m_session.id(), "");
    EXPECT_EQ(use(""), OscCode::InvalidSessionId);
    EXPECT_EQ(use("SID_0001"), OscCode::InvalidSessionId);
    EXPECT_EQ(refusedWith([&] { m_session.use(Json::object()); }), OscCode::MissingParameter);
}

TEST_F(OscSessions, ThereIsOneUntilItEndsOrIsUnused) {
    const std::string first = m_session.start();
    EXPECT_EQ(use(first), std::nullopt);
    EXPECT_EQ(refusedWith([&] { m_session.start(); }), OscCode::CameraInExclusiveUse);
    EXPECT_EQ(use(first), std::nullopt);
    m_clock.advance(seconds(181));
    const std::string second = m_session.start();
    EXPECT_EQ(use(first), OscCode::InvalidSessionId);
    EXPECT_EQ(use(second), std::nullopt);
    m_session.end();
    EXPECT_EQ(use(second), OscCode::InvalidSessionId);
}

TEST_F(OscSessions, ItsNameIsNotTakenForAnotherType) {
    m_session.start();
    EXPECT_EQ(use(1), OscCode::InvalidSessionId);
    EXPECT_EQ(use(nullptr), OscCode::InvalidSessionId);
}

TEST_F(OscSessions, EachUseBeginsTheTimeAnew) {
    const std::string id = m_session.start();
    for (int i = 0; i < 4; ++i) {
        m_clock.advance(seconds(179));
        EXPECT_EQ(use(id), std::nullopt) << i;
    }
    m_clock.advance(seconds(181));
    EXPECT_EQ(use(id), OscCode::InvalidSessionId);
}

TEST(OscSession, EndsSoonerWhereTheCamerasTimeIsQuicker) {
    test::ManualClock clock;
    OscSession session(clock, 0.1);
    const Json parameters = {{"sessionId", session.start()}};
    clock.advance(seconds(17));
    session.use(parameters);
    clock.advance(seconds(19));
    EXPECT_EQ(refusedWith([&] { session.use(parameters); }), OscCode::InvalidSessionId);
}

TEST(OscSession, LastsForEverWhereTheCameraDoesNotWait) {
    test::ManualClock clock;
    OscSession session(clock, 0);
    const Json parameters = {{"sessionId", session.start()}};
    clock.advance(std::chrono::hours(1000));
    EXPECT_EQ(refusedWith([&] { session.use(parameters); }), std::nullopt);
}

} // namespace
} // namespace spherewalk::practice
