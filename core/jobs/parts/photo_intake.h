// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/bytes.h"
#include "spherewalk/store/survey_store.h"

namespace spherewalk::jobs {

/// A photo on its way into a survey.
struct Arrival {
    Bytes jpeg;         ///< The file as the camera gave it.
    std::string source; ///< Name of the photo in sentences.
    std::int64_t station = 0;
    Eigen::Vector3d positionM = Eigen::Vector3d::Zero();
    bool isPlaced = true; ///< Whether the position is known. If not, the file gets no position tag.
    std::string cameraFileName;
    std::string cameraSerial;
    std::string fileUrl;
    std::optional<Eigen::Quaterniond> roomFromPhoto; ///< Goes into the position tag too, if known.
};

/// A photo that is checked and tagged. Neither the file nor its row has a name yet.
struct TaggedPhoto {
    store::NewPhoto row; ///< To be recorded in the store.
    Bytes file;          ///< To be written into the photo folder.
};

/// Checks the photo and writes its position tag: the slow part of taking a photo in.
/// Errors: those of checking and tagging. Threads: any.
TaggedPhoto tagged(const Arrival& arrival, const std::string& surveyId, const std::string& stationName);

/// Writes the file into the survey's photo folder, durably, and returns its row. If the program is killed
/// before the row is recorded, the next try replaces the file. Errors: those of writing.
store::NewPhoto put(const store::SurveyStore& store, TaggedPhoto photo);

/// Tags the photo and writes its file; the caller records the row. Errors: those of tagged() and put().
store::NewPhoto takeIn(const store::SurveyStore& store, const Arrival& arrival);

} // namespace spherewalk::jobs
