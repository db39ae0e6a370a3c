// SPDX-License-Identifier: GPL-3.0-or-later
#include "verdicts.h"

#include "hand_work.h"
#include "run_cameras.h"

#include "spherewalk/base/progress.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/angle.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jobs/check_places.h"
#include "spherewalk/render/dataset.h"
#include "spherewalk/store/survey_store.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace spherewalk::campaign {

namespace {

bool isSame(const Json& wanted, const Json& found) {
    return wanted.is_number() && found.is_number()
               ? std::abs(wanted.get<double>() - found.get<double>()) <= 1e-3 * std::abs(wanted.get<double>())
               : wanted == found;
}

/// That a photo was asked for, and that there is none: of a camera whose files were deleted meanwhile, or
/// that says that it has cancelled what it has not.
constexpr std::array<std::string_view, 2> kNoPhoto{": The camera has taken no photo",
                                                   ": The camera refused to take the photo"};

constexpr double kTaggedPlaceM = 1e-6;
constexpr double kSolvedPlaceM = 0.03;
constexpr Degrees kSolvedTurn(1.0);

int count(const std::string& said, const std::string& words) {
    int found = 0;
    for (std::size_t at = said.find(words); at != std::string::npos; at = said.find(words, at + 1)) {
        ++found;
    }
    return found;
}

/// Photos and shots of all stations, or of each.
struct Known {
    std::string name;
    int photos = 0;
    int told = 0; ///< shots that are Unclear, or Taken but not to be had, or given up
    int exposures = 0;
};

std::string inWords(const Eigen::Vector3d& p) {
    return text("(", fixed(p.x(), 3), ", ", fixed(p.y(), 3), ", ", fixed(p.z(), 3), ")");
}

/// Photos at wrong places, or exposed otherwise than the profile says.
void examinePhotos(const store::SurveyStore& store, const Evidence& evidence, Findings& findings) {
    const auto truths = evidence.cameras.truth();
    for (const store::PhotoRecord& photo : store.photos()) {
        ++findings.photos;
        const auto found = truths.find(photo.cameraSha256);
        if (found == truths.end()) {
            findings.violations.push_back(text("the photo ", photo.fileName, " is none of the cameras'"));
            continue;
        }
        const std::string station = store.station(photo.station).name;
        const std::string difference = exposureDifference(evidence.exposure, found->second);
        if (!difference.empty() && store.shotOf(photo.id)) {
            findings.violations.push_back(text("the photo of ", station, " was taken with ", difference));
        }
        if ((photo.positionM - found->second.nominalPositionM).norm() > kTaggedPlaceM) {
            findings.violations.push_back(text("the photo ", photo.fileName, " of ", station,
                                               " was taken at ", inWords(found->second.nominalPositionM),
                                               ", not at ", inWords(photo.positionM),
                                               ", and nobody could put it right"));
        }
    }
}

/// By station; under 0 all together where it is not known which station a picture was meant for.
std::map<std::int64_t, Known> knownOf(const store::SurveyStore& store, const Evidence& evidence) {
    std::map<std::int64_t, Known> known;
    const auto truths = evidence.cameras.truth();
    const auto of = [&](std::int64_t station) -> Known& {
        return known[evidence.isCartElsewhere ? 0 : station];
    };
    for (const auto& shots : {store.unclearShots(), store.openShots()}) {
        for (const survey::Shot& shot : shots) {
            ++of(shot.station).told;
        }
    }
    for (const store::PhotoRecord& photo : store.photos()) {
        ++of(photo.station).photos;
    }
    for (const store::StationRecord& station : store.stations()) {
        Known& here = of(station.id);
        here.name = evidence.isCartElsewhere ? "all stations together" : station.name;
        for (const auto& [sha256, truth] : truths) {
            here.exposures += truth.nominalPositionM == station.station.positionM && !truth.byButton ? 1 : 0;
        }
        for (const std::string_view words : kNoPhoto) {
            here.told += count(evidence.said, text(station.name, words));
        }
        const auto& givenUp = evidence.people.givenUp();
        const auto found = givenUp.find(station.name);
        here.told += found == givenUp.end() ? 0 : found->second;
    }
    return known;
}

/// Standard deviation of the angle between the photo's rotation and the true one; zero if none is stated.
Degrees statedTurn(const render::DatasetPhoto& photo) {
    if (!photo.rotationSigma) {
        return {};
    }
    const auto& [yaw, pitch, roll] = *photo.rotationSigma;
    return Radians(std::hypot(yaw.value(), pitch.value(), roll.value()));
}

} // namespace

std::string exposureDifference(const Json& wanted, const practice::Truth& truth) {
    for (const auto& [name, value] : wanted.items()) {
        if (!isSame(value, truth.options.value(name, Json()))) {
            return text(name, " ", truth.options.value(name, Json()).dump());
        }
    }
    return {};
}

std::vector<std::string> wrongPlaces(const std::filesystem::path& survey, const Evidence& evidence) {
    std::vector<std::string> sentences;
    const auto store = store::SurveyStore::open(survey, store::Access::Read);
    if (!store.check(noProgress(), {}).isSound()) {
        sentences.emplace_back("the survey is not sound");
    }
    const auto truths = evidence.cameras.truth();
    bool isAnyOnPurpose = false;
    for (const store::PhotoRecord& photo : store.photos()) {
        const auto found = truths.find(photo.cameraSha256);
        if (found == truths.end() ||
            (photo.positionM - found->second.nominalPositionM).norm() <= kTaggedPlaceM) {
            continue;
        }
        if (evidence.people.isWrongOnPurpose(photo.positionM, found->second.nominalPositionM)) {
            isAnyOnPurpose = true;
            continue;
        }
        sentences.push_back(text("the photo ", photo.fileName, " of ", store.station(photo.station).name,
                                 " was taken at ", inWords(found->second.nominalPositionM), ", not at ",
                                 inWords(photo.positionM)));
    }
    for (std::string& sentence : jobs::checkPlaces(store, noProgress(), {})) {
        if (!isAnyOnPurpose || !sentence.starts_with("The alignment puts")) {
            sentences.push_back(std::move(sentence));
        }
    }
    return sentences;
}

Findings examine(const std::filesystem::path& survey, const Evidence& evidence) {
    Findings findings;
    findings.violations = wrongPlaces(survey, evidence);
    const auto store = store::SurveyStore::open(survey, store::Access::Read);
    examinePhotos(store, evidence, findings);
    findings.toldShots = static_cast<int>(store.unclearShots().size() + store.openShots().size());
    for (const auto& [station, givenUp] : evidence.people.givenUp()) {
        findings.toldShots += givenUp;
    }
    for (const store::StationRecord& station : store.stationsWithoutPhoto()) {
        findings.violations.push_back(text(station.name, " has no photo after all runs"));
    }
    for (const auto& [station, known] : knownOf(store, evidence)) {
        findings.exposures += known.exposures;
        if (known.exposures > known.photos + known.told) {
            findings.violations.push_back(text(known.name, " was exposed ", known.exposures,
                                               " times, but has ", known.photos, " photos and ", known.told,
                                               " shots that the operator was told of"));
        }
    }
    for (const auto& [sha256, truth] : evidence.cameras.truth()) {
        findings.buttonPictures += truth.byButton ? 1 : 0;
    }
    return findings;
}

void examineDataset(const std::filesystem::path& folder, const RunCameras& cameras, const std::string& words,
                    Findings& findings) {
    const render::Dataset dataset = render::Dataset::open(folder);
    const auto truths = cameras.truth();
    for (const render::DatasetPhoto& photo : dataset.info().photos) {
        const auto sha256 = cameras.sha256Of(folder / photo.file);
        if (!sha256) { // the camera had lost the picture before anybody looked at it
            continue;
        }
        ++findings.datasetPhotos;
        const practice::Truth& truth = truths.at(*sha256);
        const Rigid3& pose = photo.roomFromPhoto;
        const bool isTagged = (pose.translation - truth.nominalPositionM).norm() <= kTaggedPlaceM;
        const bool isSolved = (pose.translation - truth.positionM).norm() <= kSolvedPlaceM;
        const bool isTurned = photo.rotationSource == "aligned" || photo.rotationSource == "imported";
        const bool isNamed =
            words.find(std::filesystem::path(photo.file).stem().string()) != std::string::npos;
        if (!isTagged && !isSolved && !isNamed) {
            findings.violations.push_back(text("the dataset's photo ", photo.file, " of ", photo.station,
                                               " was taken at ", inWords(truth.positionM), ", not at ",
                                               inWords(pose.translation)));
        }
        const Degrees turn(angleBetween(pose.rotation, truth.roomFromPhoto.value()));
        const Degrees stated = statedTurn(photo);
        if (isTurned && !isNamed && turn > std::max(kSolvedTurn, Degrees(3 * stated.value()))) {
            findings.violations.push_back(text("the dataset's photo ", photo.file, " of ", photo.station,
                                               " is turned ", fixed(turn.value(), 2),
                                               " degrees otherwise, and states ", fixed(stated.value(), 2)));
        }
    }
}

} // namespace spherewalk::campaign
