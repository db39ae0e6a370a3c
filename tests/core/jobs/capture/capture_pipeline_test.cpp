// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture/capture_pipeline.h"

#include "spherewalk/base/error.h"
#include "spherewalk/jobs/follow_positions.h"

#include <gmock/gmock.h>
#include <sqlite3.h>

#include <deque>

namespace spherewalk::jobs {

TEST_F(CapturePipeline, EveryPhotoComesInWithItsVerdict) {
    Cart cart(endpoint());
    const CaptureSurveyReport report = capture(cart);
    EXPECT_EQ(report.taken, static_cast<int>(m_stations.size()));
    EXPECT_EQ(report.exposed, report.taken);
    EXPECT_EQ(report.remaining, 0);
    EXPECT_EQ(cart.verdicts, report.taken);
    EXPECT_TRUE(report.flawed.empty()) << report.flawed.front().verdict.sentence();
    expectAllPhotosAreWhereTheyBelong();
}

TEST_F(CapturePipeline, ACameraThatWasNotMovedIsNamedAtOnce) {
    Cart cart(endpoint());
    cart.stays = [&](const store::StationRecord& station) { return station.id == m_stations[2].id; };
    const CaptureSurveyReport report = capture(cart);
    std::vector<std::string> unmoved;
    for (const FlawedPhoto& photo : report.flawed) {
        const std::string sentence = photo.verdict.sentence();
        if (sentence.find("the camera was not moved in between") != std::string::npos) {
            unmoved.push_back(photo.station);
            EXPECT_THAT(sentence, testing::HasSubstr(m_store->chosenPhoto(m_stations[1].id)->fileName));
        }
    }
    EXPECT_EQ(unmoved, std::vector{m_stations[2].name});
}

TEST_F(CapturePipeline, PhotosComeInWhileTheCartIsOnItsWay) {
    Cart cart(endpoint());
    int moves = 0;
    cart.onMove = [&](const std::stop_token& stop) { cart.waitForEnded(moves++, stop); };
    EXPECT_EQ(capture(cart).taken, static_cast<int>(m_stations.size())); // else it would wait for ever
    expectAllPhotosAreWhereTheyBelong();
}

TEST_F(CapturePipeline, TheCartMovesOnWhileDownloadsFail) {
    Cart cart(endpoint());
    m_camera->arm({practice::FaultKind::ServiceUnavailable, "/files", 0, 1000, 0});
    const CaptureSurveyReport failed = capture(cart);
    EXPECT_EQ(cart.exposures, static_cast<int>(m_stations.size()));
    EXPECT_EQ(failed.taken, 0);
    EXPECT_EQ(failed.missed.size(), m_stations.size());
    EXPECT_EQ(m_store->openShots().size(), m_stations.size());
}

TEST_F(CapturePipeline, WhatWasTakenBeforeAStopIsFetchedByTheNextRun) {
    Cart cart(endpoint());
    std::stop_source stop;
    int moves = 0;
    cart.onMove = [&](const std::stop_token& /*stop*/) {
        if (++moves == 4) {
            stop.request_stop();
        }
    };
    EXPECT_THROW(capture(cart, stop.get_token()), Error);
    cart.onMove = {};
    const CaptureSurveyReport report = capture(cart);
    EXPECT_EQ(report.remaining, 0);
    EXPECT_EQ(cart.exposures, static_cast<int>(m_stations.size()));
    expectAllPhotosAreWhereTheyBelong();
}

TEST_F(CapturePipeline, APhotoThatARunFetchedAndDidNotJudgeIsJudgedByTheNextRun) {
    Cart cart(endpoint());
    capture(cart);
    const std::filesystem::path folder = m_store->folder();
    m_store.reset();
    // As if the run had been stopped between the two.
    sqlite3* database = nullptr;
    ASSERT_EQ(sqlite3_open((folder / "survey.sqlite").c_str(), &database), SQLITE_OK);
    ASSERT_EQ(sqlite3_exec(database, "DELETE FROM verdict WHERE photo = 2", nullptr, nullptr, nullptr),
              SQLITE_OK);
    ASSERT_EQ(sqlite3_changes(database), 1);
    sqlite3_close(database);
    m_store = std::make_unique<store::SurveyStore>(store::SurveyStore::open(folder, store::Access::Write));
    EXPECT_FALSE(m_store->verdict(2));
    EXPECT_EQ(capture(cart).taken, 0);
    expectAllPhotosAreWhereTheyBelong();
}

TEST_F(CapturePipeline, ADiskThatTakesNoMorePhotosEndsTheRunWithItsOwnSentence) {
    Cart cart(endpoint());
    int moves = 0;
    cart.onMove = [&](const std::stop_token& stop) {
        if (++moves == 3) {
            cart.waitForEnded(2, stop);
            m_folder.leaveUnchecked();
            std::filesystem::remove_all(m_store->photoFolder());
            std::filesystem::remove_all(m_store->downloadFolder());
        }
    };
    try {
        capture(cart);
        FAIL() << "it went on";
    } catch (const Error& error) {
        EXPECT_NE(error.kind(), ErrorKind::Stopped);
        EXPECT_FALSE(error.sentence().empty());
    }
}

TEST_F(CapturePipeline, ARobotIsAnsweredLineByLine) {
    std::deque<std::string> lines{"there", "1 2", "9 9 9", R"({"x": 1})"};
    for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Vector3d& p = m_stations[i].station.positionM;
        lines.push_back(std::to_string(p.x()) + " " + std::to_string(p.y()) + " " +
                        std::to_string(p.z() + 0.01));
    }
    std::vector<FollowEvent> events;
    PracticeOperator cart(endpoint());
    const FollowLink link{
        [&](const std::stop_token& /*stop*/) {
            std::optional<std::string> line;
            if (!lines.empty()) {
                line = lines.front();
                lines.pop_front();
            }
            return line;
        },
        {},
        [&](const store::StationRecord& station, const std::stop_token& stop) { cart.moveTo(station, stop); },
        [&](const FollowEvent& event) { events.push_back(event); }};
    const FollowOptions options{practiceCaptureOptions(kTimeScale).camera};
    const auto run = [&] {
        camera::OscClient osc = client();
        return followPositions(*m_store, osc, link, systemClock(), options, noProgress(), {});
    };
    EXPECT_EQ(run().taken, 3);
    std::map<FollowEvent::Kind, int> counts;
    for (const FollowEvent& event : events) {
        ++counts[event.kind];
        EXPECT_TRUE(event.kind != FollowEvent::Kind::Refused || !event.sentence.empty());
    }
    EXPECT_EQ(counts[FollowEvent::Kind::Refused], 4);
    EXPECT_EQ(counts[FollowEvent::Kind::Exposed], 3);
    EXPECT_EQ(counts[FollowEvent::Kind::Verdict], 3);

    // A station that has its photo is answered, and only taken again when that is said.
    const Eigen::Vector3d& p = m_stations[0].station.positionM;
    const std::string position =
        std::to_string(p.x()) + " " + std::to_string(p.y()) + " " + std::to_string(p.z());
    events.clear();
    lines = {position, position + " again"};
    EXPECT_EQ(run().taken, 1);
    ASSERT_EQ(events.size(), 3U);
    EXPECT_EQ(events[0].kind, FollowEvent::Kind::Verdict);
    EXPECT_THAT(line(events[0]), testing::HasSubstr("has a photo already"));
    EXPECT_EQ(events[1].kind, FollowEvent::Kind::Exposed);
    EXPECT_EQ(m_store->photosAt(m_stations[0].id).size(), 2U);
}

TEST_F(CapturePipeline, LinesThatARobotSentBeforeTheExposureWasOverAreRefused) {
    std::deque<std::string> lines;
    for (const store::StationRecord& station : m_stations) {
        const Eigen::Vector3d& p = station.station.positionM;
        lines.push_back(std::to_string(p.x()) + " " + std::to_string(p.y()) + " " + std::to_string(p.z()));
    }
    std::vector<FollowEvent> events;
    PracticeOperator cart(endpoint());
    FollowLink link;
    link.nextLine = [&](const std::stop_token& /*stop*/) {
        std::optional<std::string> line;
        if (!lines.empty()) {
            line = lines.front();
            lines.pop_front();
        }
        return line;
    };
    link.waitingLines = [&] {
        std::vector<std::string> waiting(lines.begin(), lines.end());
        lines.clear();
        return waiting;
    };
    cart.moveTo(m_stations[0], {}); // where the camera stays
    link.tell = [&](const FollowEvent& event) { events.push_back(event); };
    camera::OscClient osc = client();
    const FollowOptions options{practiceCaptureOptions(kTimeScale).camera};
    EXPECT_EQ(followPositions(*m_store, osc, link, systemClock(), options, noProgress(), {}).taken, 1);
    ASSERT_GE(events.size(), m_stations.size());
    for (std::size_t i = 0; i + 1 < m_stations.size(); ++i) {
        EXPECT_EQ(events[i].kind, FollowEvent::Kind::Refused);
        EXPECT_THAT(events[i].sentence, testing::HasSubstr("before the exposure at"));
    }
    EXPECT_EQ(events[m_stations.size() - 1].kind, FollowEvent::Kind::Exposed);
}

} // namespace spherewalk::jobs
