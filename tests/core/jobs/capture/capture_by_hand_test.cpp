// SPDX-License-Identifier: GPL-3.0-or-later
// Photos wherever the operator stands: the survey shows where while more are taken.
#include "capture_pipeline.h"

#include "spherewalk/base/file.h"
#include "spherewalk/geometry/polygon.h"
#include "spherewalk/jobs/align_survey.h"
#include "spherewalk/jobs/check_places.h"
#include "spherewalk/jobs/solution_findings.h"
#include "spherewalk/photo/position_tag.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

namespace spherewalk::jobs {

using testing::HasSubstr;

namespace {

/// Carries the practice camera through its room, and is told what was found.
class Walker : public Operator {
  public:
    explicit Walker(const camera::Endpoint& endpoint) : m_cart(endpoint) {}

    void moveTo(const store::StationRecord& station, const std::stop_token& /*stop*/) override {
        ADD_FAILURE() << "nobody knows where " << station.name << " is";
    }

    bool walkOn(int photo, const std::stop_token& stop) override {
        return photo <= most && (stays || m_cart.walkOn(photo, stop));
    }

    bool tryAgain(const store::StationRecord& /*station*/, const camera::ShotOutcome& /*outcome*/,
                  int /*tries*/, const std::stop_token& /*stop*/) override {
        return false;
    }

    void placesFound(const PlacesFound& found) override { looks.push_back(found); }

    int most = 6;
    bool stays = false;
    std::vector<PlacesFound> looks;

  private:
    PracticeOperator m_cart;
};

class CaptureByHand : public CapturePipeline {
  protected:
    CaptureByHand() {
        m_store.reset();
        m_store = std::make_unique<store::SurveyStore>(
            store::SurveyStore::create(m_folder / "h.spherewalk", "h", survey::unknownRoom(), {}, {}));
    }

    CaptureSurveyReport walk(Operator& people) {
        camera::OscClient osc = client();
        CaptureSurveyOptions options = practiceCaptureOptions(kTimeScale);
        options.byHand = true;
        return captureSurvey(*m_store, osc, people, systemClock(), options, noProgress(), {});
    }

    std::vector<Eigen::Vector3d> truePlaces() const {
        std::vector<Eigen::Vector3d> places;
        for (const practice::Truth& truth : practice::readTruth(m_folder / "truth.jsonl")) {
            places.push_back(truth.positionM);
        }
        return places;
    }

    /// The greatest error of a distance between two stations, as a share of it.
    double worstDistanceError() const {
        const std::vector<Eigen::Vector3d> truth = truePlaces();
        const std::vector<store::StationRecord> stations = m_store->stations();
        double worst = 0;
        for (std::size_t i = 0; i < stations.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                const double apart = (truth[i] - truth[j]).norm();
                const double shown = (stations[i].station.positionM - stations[j].station.positionM).norm();
                worst = std::max(worst, std::abs(shown / apart - 1));
            }
        }
        return worst;
    }
};

} // namespace

TEST_F(CaptureByHand, ShowsWherePhotosWereTakenAndTheRoomAroundThem) {
    Walker walker(endpoint());
    EXPECT_TRUE(isByHand(*m_store));
    const CaptureSurveyReport report = walk(walker);
    EXPECT_EQ(report.taken, 6);
    EXPECT_TRUE(report.flawed.empty()) << report.flawed.front().verdict.sentence();
    ASSERT_TRUE(report.places);
    EXPECT_EQ(report.places->photos, 6);
    EXPECT_EQ(report.places->placed.size(), 6U);
    EXPECT_THAT(report.places->sentence(), HasSubstr("All photos are placed"));
    ASSERT_FALSE(walker.looks.empty());
    EXPECT_EQ(walker.looks.back().placed, report.places->placed);
    ASSERT_EQ(m_store->stations().size(), 6U);
    EXPECT_LT(worstDistanceError(), 0.03);
    for (const store::StationRecord& station : m_store->stations()) {
        EXPECT_FALSE(station.isPlaceKnown) << station.name; // a look is no alignment
        EXPECT_TRUE(contains(m_store->room().outline, station.station.positionM.head<2>()));
        const store::PhotoRecord photo = m_store->photosAt(station.id).at(0);
        EXPECT_FALSE(
            photo::readPositionTag(readFile(m_store->photoFolder() / photo.fileName), photo.fileName));
    }
    EXPECT_NE(m_store->room().outline, survey::unknownRoom().outline);
    EXPECT_TRUE(photosToExport(*m_store).photos.empty());
    EXPECT_TRUE(checkPlaces(*m_store, noProgress(), {}).empty());
}

TEST_F(CaptureByHand, TellsWhoStaysAtOnePlaceAndMakesNoRoomOfIt) {
    Walker walker(endpoint());
    walker.most = 3;
    walker.stays = true;
    const CaptureSurveyReport report = walk(walker);
    EXPECT_EQ(report.taken, 3);
    EXPECT_TRUE(report.flawed.empty()) << report.flawed.front().verdict.sentence();
    ASSERT_TRUE(report.places);
    EXPECT_TRUE(report.places->placed.empty());
    EXPECT_THAT(report.places->sentence(),
                HasSubstr("Of the last photo: It was taken at one place with the others"));
    EXPECT_EQ(m_store->room().outline, survey::unknownRoom().outline);
}

TEST_F(CaptureByHand, GoesOnAfterAnAlignmentInItsFrame) {
    Walker walker(endpoint());
    walk(walker);
    AlignOptions options;
    options.isFree = true;
    alignSurvey(*m_store, options, noProgress(), {});
    const std::vector<store::StationRecord> aligned = m_store->stations();
    ASSERT_EQ(aligned.size(), 6U); // each photo keeps its station
    for (const store::StationRecord& station : aligned) {
        EXPECT_TRUE(station.isPlaceKnown);
        EXPECT_THAT(station.name, testing::StartsWith("place of "));
        EXPECT_EQ(m_store->photosAt(station.id).at(0).positionM, station.station.positionM);
    }
    walker.most = 2;
    walk(walker);
    ASSERT_EQ(m_store->stations().size(), 8U);
    EXPECT_LT(worstDistanceError(), 0.03);
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(m_store->stations()[i].station.positionM, aligned[i].station.positionM);
    }
    EXPECT_EQ(m_store->activeSolution()->source, "align");
}

TEST_F(CaptureByHand, AShotThatTookNoPictureLeavesItsStationToTheNext) {
    Walker walker(endpoint());
    walker.most = 1;
    m_camera->arm({practice::FaultKind::ServiceUnavailable, "camera.takePicture", 0, 50, 0});
    const CaptureSurveyReport refused = walk(walker);
    EXPECT_EQ(refused.taken, 0);
    EXPECT_EQ(refused.places->photos, 0);
    m_camera->disarm();
    walker.most = 2;
    EXPECT_EQ(walk(walker).taken, 2);
    EXPECT_EQ(m_store->stations().size(), 2U);
}

TEST_F(CaptureByHand, PhotosFromOnePlaceAreNoFault) {
    Walker walker(endpoint());
    walker.most = 1;
    EXPECT_EQ(walk(walker).places->sentence(), "The photo is placed."); // the first is where all begins

    class Standing : public Walker {
      public:
        using Walker::Walker;

        bool walkOn(int photo, const std::stop_token& /*stop*/) override { return photo <= 1; }
    } standing(endpoint());

    const CaptureSurveyReport report = walk(standing);
    EXPECT_EQ(report.taken, 1);
    EXPECT_TRUE(report.flawed.empty()) << report.flawed.front().verdict.sentence();
}

TEST_F(CaptureByHand, NobodyIsSentToAnUnknownPlace) {
    Walker walker(endpoint());
    walker.most = 1;
    walk(walker);
    m_store->setReview({m_store->photos().at(0).id, store::Decision::Rejected, ""});
    EXPECT_TRUE(isByHand(*m_store));
    EXPECT_EQ(capture(walker).exposed, 0);
}

TEST_F(CaptureByHand, ALookThatFailsEndsNoWalk) {
    survey::Room hall = survey::unknownRoom();
    hall.ceilingM = 40;
    survey::PlanOptions plan;
    plan.heightsM = {25}; // of a crane: no free solution takes it for a lens's height
    m_store.reset();
    m_store = std::make_unique<store::SurveyStore>(
        store::SurveyStore::create(m_folder / "crane.spherewalk", "crane", hall, plan, {}));
    Walker walker(endpoint());
    walker.most = 2;
    const CaptureSurveyReport report = walk(walker);
    EXPECT_EQ(report.taken, 2);
    ASSERT_FALSE(walker.looks.empty());
    EXPECT_NE(walker.looks.back().trouble, "");
    EXPECT_THAT(report.places->sentence(), HasSubstr("is not known yet"));
    EXPECT_EQ(m_store->room().outline, hall.outline);
}

TEST_F(CaptureByHand, ASurveyWithRailsKeepsItsRoomAndItsStations) {
    store::SurveyStore planned = store::SurveyStore::open(m_folder / "s.spherewalk", store::Access::Write);
    EXPECT_FALSE(isByHand(planned));
    const survey::Room room = planned.room();
    const std::size_t stations = planned.stations().size();
    camera::OscClient osc = client();
    CaptureSurveyOptions options = practiceCaptureOptions(kTimeScale);
    options.byHand = true;
    Walker walker(endpoint());
    walker.most = 3;
    const CaptureSurveyReport report =
        captureSurvey(planned, osc, walker, systemClock(), options, noProgress(), {});
    EXPECT_EQ(report.places->placed.size(), 3U);
    EXPECT_EQ(planned.room().outline, room.outline);
    EXPECT_EQ(planned.stations().size(), stations + 3);
}

} // namespace spherewalk::jobs
