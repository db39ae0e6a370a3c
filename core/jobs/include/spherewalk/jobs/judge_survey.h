// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json_fwd.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/photo/verdict.h"
#include "spherewalk/store/records.h"

#include <cstddef>
#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

namespace spherewalk::store {
class SurveyStore;
}

namespace spherewalk::jobs {

/// How many photos were judged, and how many of them have each quality.
struct JudgeReport {
    int judged = 0;
    int good = 0;
    int doubtful = 0;
    int failed = 0;
    int notCompared = 0;        ///< Number of photos without a neighbour to compare light and colour with.
    int contentNotCompared = 0; ///< Number of photos in which persons were not looked for.
};

/// Judges photos of the survey, each against the photos that stand near it, and keeps the verdicts in the
/// store. With `all`, photos that have a verdict are judged again: more neighbours may be there now.
///
/// Errors: those of the store.
/// Stop: Stopped before the next photo; the verdicts so far are kept.
JudgeReport judgeSurvey(store::SurveyStore& store, bool all, ProgressSink& progress,
                        const std::stop_token& stop);

Json toJson(const JudgeReport& report);

/// Says what could not be compared, with what helps; "" if all was. contentNotCompared includes notCompared.
std::string notComparedText(int photos, int notCompared, int contentNotCompared);

/// The verdict that a record of the store holds. Errors: Corrupt.
photo::Verdict verdictOf(const store::PhotoVerdict& record);

/// A station whose photo should be taken again.
struct Retake {
    store::StationRecord station;
    bool isFailed = true; ///< The checks failed the photo, or a person rejected it. Otherwise it is doubtful.
    /// Good photos stand around the photo and can stand in for it. Otherwise it leaves a hole.
    bool isSurrounded = false;
    std::string sentence; ///< Says why.
};

/// Stations in walking order whose chosen photo a person rejected, or whose verdict is not good and no person
/// accepted it. Stations that never had a photo are not listed. A photo counts as surrounded by good photos
/// at its height, one and a half steps away at most, that leave no half of the directions around it empty.
/// Errors: those of the store.
std::vector<Retake> retakes(const store::SurveyStore& store);

Json toJson(const std::vector<Retake>& retakes);

struct FaceOptions {
    /// Photos that were searched already are searched again. Regions that a person has marked or rejected
    /// stay.
    bool again = false;
    int threads = 0;                ///< 0: all that the machine has.
    std::filesystem::path cascades; ///< The folder that holds them; empty for where the system has them.
};

struct FaceReport {
    std::size_t photos = 0;            ///< Photos that were searched.
    std::size_t before = 0;            ///< Photos that an earlier run has searched.
    std::size_t regions = 0;           ///< Regions that were found and are new.
    std::size_t photosWithRegions = 0; ///< Photos in which they are.
    double seconds = 0;
};

/// Looks for faces in the photos of a survey, and keeps them as regions that datasets show blurred. Errors:
/// those of photo::FaceSearch and of the store; Corrupt and Unsupported for photos that cannot be decoded.
/// Stop: Stopped, within 200 ms; the photos before are done, and the next run goes on behind them.
FaceReport searchFaces(store::SurveyStore& store, const FaceOptions& options, ProgressSink& progress,
                       const std::stop_token& stop);

Json toJson(const FaceReport& report);

/// The number of photos that searchFaces() would search if it were not to search any again. Errors: those of
/// the store.
std::size_t unsearchedPhotos(const store::SurveyStore& store);

} // namespace spherewalk::jobs
