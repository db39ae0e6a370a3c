// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/photo/verdict.h"
#include "spherewalk/store/survey_store.h"

#include <stop_token>

namespace spherewalk::jobs {

struct JudgeReport {
    int judged = 0;
    int good = 0;
    int doubtful = 0;
    int failed = 0;
};

/// Judges photos of the survey, each against all that stand near it, and keeps the verdicts. all: also those
/// that have a verdict, which may have been given when fewer neighbours were there. Errors: those of the
/// store; Stopped, with what is done kept.
JudgeReport judgeSurvey(store::SurveyStore& store, bool all, ProgressSink& progress,
                        const std::stop_token& stop);

Json toJson(const JudgeReport& report);

/// A verdict as the store keeps it, read back. Errors: Corrupt.
photo::Verdict verdictOf(const store::PhotoVerdict& record);

} // namespace spherewalk::jobs
