// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/bytes.h"
#include "spherewalk/store/survey_store.h"

namespace spherewalk::jobs {

/// A photo on its way into a survey: what the caller knows of it besides its bytes.
struct Arrival {
    Bytes jpeg;         ///< as the camera gave it
    std::string source; ///< for sentences
    std::int64_t station = 0;
    Eigen::Vector3d positionM = Eigen::Vector3d::Zero();
    std::string cameraFileName;
    std::string cameraSerial;
    std::string fileUrl;
    std::optional<Eigen::Quaterniond> roomFromPhoto; ///< if known, it goes into the photo's tag too
};

/// A photo that is checked and tagged, and the row that is to be recorded, both without a name yet.
struct TaggedPhoto {
    store::NewPhoto row;
    Bytes file;
};

/// Errors: those of checking and tagging. Threads: any; the slow part of taking a photo in.
TaggedPhoto tagged(const Arrival& arrival, const std::string& surveyId, const std::string& stationName);

/// Puts the file into the survey's photo folder, durably, and returns the row. Killed before the row is
/// recorded, it leaves a file that the next try replaces. Errors: those of writing.
store::NewPhoto put(const store::SurveyStore& store, TaggedPhoto photo);

/// Both.
store::NewPhoto takeIn(const store::SurveyStore& store, const Arrival& arrival);

} // namespace spherewalk::jobs
