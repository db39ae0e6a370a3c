// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/camera/capture.h"
#include "spherewalk/photo/verdict.h"

namespace spherewalk::ui {

/// What the operator hears and sees of a shot.
enum class Verdict {
    None,
    Good,     ///< the photo is in the survey, and nothing is to be said about it
    Doubtful, ///< it is in the survey or still on the camera, and there is something to read
    Failed,   ///< there is no photo, or the checks failed it
};

/// found: what the checks say of the photo; null without one.
inline Verdict verdictOf(const camera::ShotOutcome& outcome, const photo::Verdict* found) {
    switch (outcome.shot.step) {
    case camera::ShotStep::Downloaded:
        if (found != nullptr && found->quality() == photo::Quality::Failed) {
            return Verdict::Failed;
        }
        return outcome.warnings.empty() && (found == nullptr || found->findings.empty()) ? Verdict::Good
                                                                                         : Verdict::Doubtful;
    case camera::ShotStep::Taken:
        return Verdict::Doubtful;
    default:
        return Verdict::Failed;
    }
}

} // namespace spherewalk::ui
