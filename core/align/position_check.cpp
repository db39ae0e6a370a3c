// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/align/position_check.h"

#include "part_heading.h"
#include "planned_lines.h"
#include "position_hypotheses.h"
#include "position_sentences.h"
#include "rough_rotations.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace spherewalk::align {

namespace {

constexpr double kRivalGain = 16; ///< a rival that gains so much less is out of the question
constexpr int kMostBlunders = 100;
constexpr double kSameM = 0.01;
constexpr double kBlunderPrice = 15; ///< of two explanations about as good the one of fewer blunders is right

struct Judged {
    PositionEvidence evidence;
    Places places;
    std::vector<Finding> findings; ///< one a photo
    double score = 0;
};

const Move* moveOf(const Hypothesis& hypothesis, int photo) {
    const auto found = std::ranges::find(hypothesis.moves, photo, &Move::photo);
    return found == hypothesis.moves.end() ? nullptr : &*found;
}

/// Whether both lay the photo at one place; a hypothesis that does not move it leaves it where it is.
bool agree(const Hypothesis& best, const Hypothesis& rival, int photo) {
    const Move* ofBest = moveOf(best, photo);
    const Move* ofRival = moveOf(rival, photo);
    return ofBest != nullptr && ofRival != nullptr &&
           (ofBest->positionM - ofRival->positionM).norm() < kSameM;
}

/// Rivals are those that explain the same contradictions: once the best is believed they gain little.
std::vector<Hypothesis> rivals(std::span<const Hypothesis> found, PositionEvidence& evidenceAfter) {
    std::vector<Hypothesis> all;
    for (const Hypothesis& other : found.subspan(1)) {
        if (other.gain > found[0].gain - kRivalGain && evidenceAfter.gain(other.moves) < other.gain / 2) {
            all.push_back(other);
        }
    }
    return all;
}

double confidence(const Hypothesis& best, std::span<const Hypothesis> rivals, int photo) {
    double sum = 1 + std::exp(-best.gain / 2); // that nothing is wrong rivals too
    for (const Hypothesis& rival : rivals) {
        // Half of the nats: a photo's baselines share its errors.
        sum += agree(best, rival, photo) ? 0 : std::exp((rival.gain - best.gain) / 2);
    }
    return 1 / sum;
}

void believe(const Hypothesis& best, std::span<const Hypothesis> rivals, Judged& judged) {
    for (const Move& move : best.moves) {
        const auto photo = static_cast<std::size_t>(move.photo);
        Finding& finding = judged.findings[photo];
        finding.blunder = finding.timesMoved == 0 ? best.blunder : Blunder::Elsewhere;
        finding.stopsFarther = best.stopsFarther;
        finding.together = static_cast<int>(best.moves.size());
        finding.confidence = confidence(best, rivals, move.photo);
        ++finding.timesMoved;
        judged.places[photo] = move.planned;
    }
    judged.score -= kBlunderPrice;
}

/// Finds one blunder after the other, the one that explains most first.
void judge(const PlannedLines& lines, const Eigen::Vector3d& up, Judged& judged) {
    judged.evidence.turn(refinedHeading(judged.evidence, up));
    for (int round = 0; round < kMostBlunders; ++round) {
        const std::vector<Hypothesis> found = hypotheses(judged.evidence, lines, judged.places);
        if (found.empty()) {
            break;
        }
        judged.evidence.apply(found[0].moves);
        believe(found[0], rivals(found, judged.evidence), judged);
        judged.evidence.turn(refinedHeading(judged.evidence, up));
    }
    judged.score += judged.evidence.score();
}

Judged start(std::span<const PhotoPrior> photos, const PlannedLines& lines, std::vector<Baseline> baselines) {
    std::vector<Eigen::Vector3d> positionsM;
    std::vector<double> sigmasM;
    Places places;
    for (const PhotoPrior& photo : photos) {
        positionsM.push_back(photo.positionM);
        sigmasM.push_back(photo.positionSigmaM);
        places.push_back(lines.tag(photo));
    }
    std::erase_if(baselines, [&](const Baseline& baseline) {
        const Eigen::Vector3d& aM = positionsM[static_cast<std::size_t>(baseline.a)];
        return !std::isfinite((positionsM[static_cast<std::size_t>(baseline.b)] - aM).squaredNorm());
    });
    return {PositionEvidence(std::move(baselines), std::move(positionsM), std::move(sigmasM)),
            std::move(places), std::vector<Finding>(photos.size())};
}

void report(const Judged& judged, std::span<const PhotoPrior> photos, const PlannedLines& lines,
            std::vector<WrongPosition>& wrong) {
    for (std::size_t i = 0; i < photos.size(); ++i) {
        const double movedM = (judged.evidence.positionsM()[i] - photos[i].positionM).norm();
        if (judged.findings[i].timesMoved > 0 && movedM > kSameM) {
            const int photo = static_cast<int>(i);
            wrong.push_back({photo, judged.places[i], judged.findings[i].confidence,
                             sentence(photo, photos, judged.places, judged.findings[i],
                                      judged.evidence.positionsM()[i], lines)});
        }
    }
}

} // namespace

std::vector<WrongPosition> wrongPositions(std::span<const PhotoPrior> photos,
                                          std::span<const PairEstimate> estimates,
                                          std::span<const PlannedPosition> planned) {
    const RoughRotations rotations = roughRotations(static_cast<int>(photos.size()), estimates);
    const PlannedLines lines(planned);
    std::vector<WrongPosition> wrong;
    for (int part = 0; part < rotations.parts; ++part) {
        const Eigen::Vector3d up = upInPart(photos, rotations, part);
        const Judged untouched = start(photos, lines, baselines(estimates, rotations, part));
        std::optional<Judged> best;
        for (const Eigen::Quaterniond& roomFromPart : likelyHeadings(untouched.evidence, up)) {
            Judged judged = untouched;
            judged.evidence.turn(roomFromPart);
            judge(lines, up, judged);
            if (!best || judged.score > best->score) {
                best = std::move(judged);
            }
        }
        if (best) {
            report(*best, photos, lines, wrong);
        }
    }
    std::ranges::sort(wrong, std::less(), &WrongPosition::photo);
    return wrong;
}

} // namespace spherewalk::align
