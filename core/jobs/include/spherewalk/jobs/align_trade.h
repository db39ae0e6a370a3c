// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/jobs/align_survey.h"
#include "spherewalk/jobs/alignment_truth.h"

#include <optional>
#include <string>
#include <vector>

namespace spherewalk::jobs {

struct AlignTradeOptions {
    std::vector<align::Effort> efforts = {align::Effort::Draft, align::Effort::Normal, align::Effort::Fine,
                                          align::Effort::Exact};
    std::vector<align::Model> models = {align::Model::Yaw, align::Model::Tilt, align::Model::Placement,
                                        align::Model::Position};
    std::filesystem::path mask;
    TruePoses truth; ///< may be empty
    int threads = 0; ///< 0: all that the machine has
};

/// One effort with one model.
struct AlignTradeRow {
    align::Effort effort = align::Effort::Normal;
    std::string detector;
    int width = 0; ///< working pixels per turn
    int most = 0;  ///< features a photo
    align::Model model = align::Model::Yaw;
    double featureSeconds = 0; ///< nothing taken from an earlier run
    double matchSeconds = 0;
    double solveSeconds = 0;
    int solved = 0;                      ///< photos
    std::optional<AlignmentError> error; ///< where the truth is known
    std::optional<double> heldOutDeg;    ///< misfit of matches that the model was not shown
    double cycleErrorDeg = 0;            ///< left around triangles of pairs
    double sigmaYawDeg = 0;              ///< median of what the solution states

    double seconds() const { return featureSeconds + matchSeconds + solveSeconds; }
};

struct AlignTrade {
    std::size_t photos = 0;
    bool hasTruth = false;
    std::vector<AlignTradeRow> rows;
};

/// Aligns the survey with each effort and model, and says what each costs and gains. Records nothing. Errors:
/// those of alignSurvey().
AlignTrade alignTrade(store::SurveyStore& store, const AlignTradeOptions& options, ProgressSink& progress,
                      const std::stop_token& stop);

Json toJson(const AlignTrade& trade);

/// A table for people.
std::string tradeTable(const AlignTrade& trade);

/// Error against time. Shape: SVG.
std::string tradePlot(const AlignTrade& trade, const std::string& title);

} // namespace spherewalk::jobs
