// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json.h"
#include "spherewalk/practice/truth.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace spherewalk::store {
class SurveyStore;
}

namespace spherewalk::campaign {

class HandWork;
class RunCameras;

/// What the cameras' own truth says of a survey at the end.
struct Findings {
    int photos = 0;
    int exposures = 0; ///< that the program asked for
    int buttonPictures = 0;
    int toldShots = 0;                   ///< of which the operator has been told that they need a look
    int datasetPhotos = 0;               ///< of datasets, each known by its own picture
    std::vector<std::string> violations; ///< sentences
};

/// What a survey is compared with.
struct Evidence {
    const RunCameras& cameras;
    const HandWork& people;
    const Json& exposure;    ///< of the profile
    const std::string& said; ///< by all programs
    bool isCartElsewhere;    ///< Somebody took pictures at stations that were not asked for.
};

/// How a picture was exposed otherwise than wanted; "" if it was not.
std::string exposureDifference(const Json& wanted, const practice::Truth& truth);

/// Sentences on photos whose tag, record, solution and truth differ, but for places that people have said
/// wrongly on purpose.
std::vector<std::string> wrongPlaces(const std::filesystem::path& survey, const Evidence& evidence);

/// Compares the survey with the truth: no stored photo lost, none at another station than its own, none with
/// another exposure than the profile's, no second exposure that the operator was not told of.
Findings examine(const std::filesystem::path& survey, const Evidence& evidence);

/// Compares a dataset with the truth. Each photo is known by its picture, whatever the survey says of it.
/// words: what the export said. Adds to the findings.
void examineDataset(const std::filesystem::path& dataset, const RunCameras& cameras, const std::string& words,
                    Findings& findings);

} // namespace spherewalk::campaign
