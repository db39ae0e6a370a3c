// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "temporary_folder.h"

#include "spherewalk/camera/capture.h"
#include "spherewalk/jobs/capture_survey.h"
#include "spherewalk/practice/practice_camera.h"
#include "spherewalk/practice/truth.h"
#include "spherewalk/store/survey_store.h"

#include <gtest/gtest.h>

#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace spherewalk::jobs {

/// A practice camera, a survey of its room, and what stands between them.
class CapturePipeline : public testing::Test {
  protected:
    CapturePipeline() {
        practice::PracticeCameraOptions options;
        options.width = 1024;
        options.truthFile = m_folder / "truth.jsonl";
        m_camera = std::make_unique<practice::PracticeCamera>(options);
        m_camera->start();
        const practice::RoomPlan drawn = practice::PracticeRoom().plan();
        const survey::Room room{drawn.outline, drawn.obstacles, drawn.ceilingM};
        survey::PlanOptions plan;
        plan.stepM = 1.3;
        m_store = std::make_unique<store::SurveyStore>(
            store::SurveyStore::create(m_folder / "s.spherewalk", "s", room, plan, survey::plan(room, plan)));
        m_stations = m_store->stations();
    }

    camera::Endpoint endpoint() const { return {"127.0.0.1", m_camera->port()}; }

    camera::OscClient client() const {
        return {endpoint(), camera::OscOptions{}.scaled(kTimeScale), systemClock()};
    }

    CaptureSurveyReport capture(Operator& people, const std::stop_token& stop = {}) {
        camera::OscClient osc = client();
        return captureSurvey(*m_store, osc, people, systemClock(), practiceCaptureOptions(kTimeScale),
                             noProgress(), stop);
    }

    void expectAllPhotosAreWhereTheyBelong() {
        std::map<std::string, Eigen::Vector3d> placeOf;
        for (const practice::Truth& truth : practice::readTruth(m_folder / "truth.jsonl")) {
            placeOf[truth.sha256] = truth.nominalPositionM;
        }
        EXPECT_EQ(placeOf.size(), m_stations.size()); // none twice
        for (const store::StationRecord& station : m_stations) {
            const auto photo = m_store->chosenPhoto(station.id);
            ASSERT_TRUE(photo) << station.name;
            EXPECT_EQ(placeOf.at(photo->cameraSha256), station.station.positionM);
            EXPECT_TRUE(m_store->verdict(photo->id)) << station.name;
        }
    }

    static constexpr double kTimeScale = 0.02;
    test::TemporaryFolder m_folder;
    std::unique_ptr<practice::PracticeCamera> m_camera;
    std::unique_ptr<store::SurveyStore> m_store;
    std::vector<store::StationRecord> m_stations;
};

/// Moves the practice cart, and waits where a test wants it.
class Cart : public Operator {
  public:
    explicit Cart(camera::Endpoint endpoint) : m_cart(std::move(endpoint)) {}

    void moveTo(const store::StationRecord& station, const std::stop_token& stop) override {
        if (onMove) {
            onMove(stop);
        }
        if (!stays || !stays(station)) {
            m_cart.moveTo(station, stop);
        }
    }

    bool tryAgain(const store::StationRecord& station, const camera::ShotOutcome& outcome, int tries,
                  const std::stop_token& stop) override {
        return m_cart.tryAgain(station, outcome, tries, stop);
    }

    void exposed(const store::StationRecord& /*station*/) override { ++exposures; }

    void shotEnded(const store::StationRecord& /*station*/, const camera::ShotOutcome& /*outcome*/,
                   const photo::Verdict* verdict) override {
        {
            const std::scoped_lock lock(m_mutex);
            m_ended += 1;
            verdicts += verdict != nullptr ? 1 : 0;
        }
        m_changed.notify_all();
    }

    void waitForEnded(int count, const std::stop_token& stop) {
        std::unique_lock lock(m_mutex);
        m_changed.wait(lock, stop, [&] { return m_ended >= count; });
    }

    std::function<void(const std::stop_token&)> onMove;
    std::function<bool(const store::StationRecord&)> stays; ///< Somebody forgets to move on.
    int exposures = 0;
    int verdicts = 0;

  private:
    PracticeOperator m_cart;
    std::mutex m_mutex;
    std::condition_variable_any m_changed;
    int m_ended = 0;
};

} // namespace spherewalk::jobs
