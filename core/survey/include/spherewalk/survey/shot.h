// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/enum_names.h"

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace spherewalk::survey {

/// What the camera held before a shot. What is newer afterwards came from the shot.
struct Baseline {
    /// URL of the newest file, with the mark that camera/shot_settler.h describes; "" if the camera held
    /// none.
    std::string latestFileUrl;
    std::int64_t totalEntries = 0; ///< Number of files that the camera listed.

    bool operator==(const Baseline&) const = default;
};

/// How far one shot has come. The steps are recorded in this order; each is on disk before the next begins.
enum class ShotStep {
    Intended,   ///< The shot is recorded, and the camera was perhaps triggered.
    Started,    ///< The camera gave a command id.
    Taken,      ///< The file on the camera is known.
    Downloaded, ///< The photo is complete, verified, and in the survey.
    NotTaken,   ///< It is proved that the camera took no picture, or a person gave the shot up.
    Unclear,    ///< A person must decide: two new files, another camera, or a counter that began anew.
};

inline constexpr EnumNames<ShotStep, 6> kShotStepNames{{{ShotStep::Intended, "intended"},
                                                        {ShotStep::Started, "started"},
                                                        {ShotStep::Taken, "taken"},
                                                        {ShotStep::Downloaded, "downloaded"},
                                                        {ShotStep::NotTaken, "not_taken"},
                                                        {ShotStep::Unclear, "unclear"}}};

/// The word for the step in the survey's database, "not_taken" for example.
inline std::string_view name(ShotStep step) {
    return nameOf(kShotStepNames, step);
}

/// Errors: InvalidInput for an unknown name; the sentence lists all names.
inline ShotStep shotStepNamed(std::string_view name) {
    return valueOf(kShotStepNames, "The step", name);
}

/// One exposure at a station, from the intention to the photo in the survey.
struct Shot {
    std::int64_t id = 0;      ///< Identity in the survey's database, from 1; 0 for a shot of no survey.
    std::int64_t station = 0; ///< Identity of the station that the shot belongs to.
    ShotStep step = ShotStep::Intended;
    std::chrono::system_clock::time_point intendedAt; ///< When the shot was recorded, to the millisecond.
    std::string cameraSerial;                         ///< Serial number of the camera; "" if it has none.
    Baseline baseline;
    std::string commandId; ///< The camera's name for the running command; "" until Started.
    /// URL of the photo on the camera, with its mark if the camera listed the file; "" until Taken. Of an
    /// Unclear shot: the picture that may be its own, or "".
    std::string fileUrl;
    std::string note;                  ///< Why the shot is Unclear, in a sentence.
    std::optional<std::int64_t> photo; ///< Identity of the photo in the survey, once it is Downloaded.
};

/// How good a photo or its alignment is, from good to bad, so that the worse grade compares greater.
enum class Quality { Good, Doubtful, Failed };

inline constexpr EnumNames<Quality, 3> kQualityNames{
    {{Quality::Good, "good"}, {Quality::Doubtful, "doubtful"}, {Quality::Failed, "failed"}}};

/// "good", "doubtful" or "failed", as the database, reports and options spell the grade.
inline std::string_view name(Quality quality) {
    return nameOf(kQualityNames, quality);
}

/// Errors: InvalidInput for an unknown name; the sentence lists all names.
inline Quality qualityNamed(std::string_view name) {
    return valueOf(kQualityNames, "The verdict", name);
}

} // namespace spherewalk::survey
