// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/align/position_check.h"

#include "check/position_evidence.h"
#include "check/position_hypotheses.h"
#include "graph/pose_graph.h"

#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace spherewalk::align {

namespace {

constexpr double kRivalGain = 16; ///< A rival that gains less by this much is out of the question.
constexpr int kMostBlunders = 100;
constexpr double kLeastAgreeing = 0.4; ///< Of the best orientation's agreeing share; others are not tried.
constexpr double kSamePositionM = 0.01;
constexpr double kBlunderPrice =
    15; ///< Of two explanations about as good, the one with fewer blunders is right.

/// How a photo's position was found to be wrong.
struct Finding {
    Blunder blunder = Blunder::Elsewhere;
    int stopsFarther = 0;
    int together = 0; ///< Number of photos that were moved together, this one included.
    int timesMoved = 0;
    double confidence = 0;
};

struct Judged {
    PositionEvidence evidence;
    Places places;
    std::vector<Finding> findings; ///< One a photo.
    double score = 0;
};

const Move* moveOf(const Hypothesis& hypothesis, int photo) {
    const auto found = std::ranges::find(hypothesis.moves, photo, &Move::photo);
    return found == hypothesis.moves.end() ? nullptr : &*found;
}

/// Whether both hypotheses move the photo, and to one place.
bool agree(const Hypothesis& best, const Hypothesis& rival, int photo) {
    const Move* ofBest = moveOf(best, photo);
    const Move* ofRival = moveOf(rival, photo);
    return ofBest != nullptr && ofRival != nullptr &&
           (ofBest->positionM - ofRival->positionM).norm() < kSamePositionM;
}

/// Hypotheses that explain the same contradictions as the best one: once it is believed, they gain little.
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
    double sum = 1 + std::exp(-best.gain / 2); // "Nothing is wrong" is a rival too.
    for (const Hypothesis& rival : rivals) {
        // Half of the nats count, since a photo's baselines share its errors.
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

/// A component whose tags are judged, and all photos and estimates.
struct TagCase {
    const Component& component;
    std::span<const PhotoPrior> photos;
    std::span<const PairEstimate> estimates;
    const PlannedLines& lines;
};

/// How the component lies in the room by the positions that are believed now. Of several orientations the one
/// nearest to the present one is taken.
Eigen::Quaterniond reoriented(const TagCase& of, const PositionEvidence& evidence) {
    std::vector<PhotoPrior> believed(of.photos.begin(), of.photos.end());
    for (std::size_t i = 0; i < believed.size(); ++i) {
        believed[i].positionM = evidence.positionsM()[i];
    }
    const std::vector<RoomOrientation> ways = orientations(of.component, believed, of.estimates);
    const auto away = [&](const RoomOrientation& way) {
        return angleBetween(way.roomFromComponent, evidence.roomFromComponent()).value();
    };
    return std::ranges::min_element(ways, {}, away)->roomFromComponent;
}

/// Finds one blunder after the other, the one that explains most first.
void judge(const TagCase& of, Judged& judged) {
    for (int round = 0; round < kMostBlunders; ++round) {
        const std::vector<Hypothesis> found = hypotheses(judged.evidence, of.lines, judged.places);
        if (found.empty()) {
            break;
        }
        judged.evidence.apply(found[0].moves);
        believe(found[0], rivals(found, judged.evidence), judged);
        judged.evidence.turn(reoriented(of, judged.evidence));
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

std::string shows(const std::string& station) {
    return text("it shows what is seen from ", station, ".");
}

/// Whether some photo tagged with the first planned position was taken at the second.
bool isTaken(int tagged, int taken, std::span<const PhotoPrior> photos, const Places& places,
             const PlannedLines& lines) {
    for (std::size_t i = 0; i < photos.size(); ++i) {
        if (places[i] == taken && lines.tag(photos[i]) == tagged) {
            return true;
        }
    }
    return false;
}

std::string shifted(const Finding& finding) {
    const std::string where = finding.stopsFarther > 0 ? "one stop farther along its rail than its tag says"
                                                       : "one stop before the one that its tag says";
    return finding.together > 1 ? text("It is one of ", finding.together, " photos taken ", where, ": ")
                                : text("It was taken ", where, ": ");
}

// What people read of a photo. takenM: where the photo was taken, as is believed now.
std::string sentence(int photo, std::span<const PhotoPrior> photos, const Places& places,
                     const Finding& finding, const Eigen::Vector3d& takenM, const PlannedLines& lines) {
    const PhotoPrior& prior = photos[static_cast<std::size_t>(photo)];
    const int taken = places[static_cast<std::size_t>(photo)];
    const int tagged = lines.tag(prior);
    if (taken < 0) {
        const std::string where = text("It was taken about ", fixed((takenM - prior.positionM).norm(), 2),
                                       " m from where its tag says, where no photo is planned");
        return finding.blunder == Blunder::Shifted ? text(where, ": one stop off the end of its rail.")
                                                   : text(where, ".");
    }
    const std::string& station = lines[taken].name;
    if (finding.blunder == Blunder::Reversed) {
        return text("Its rail was walked from the other end: ", shows(station));
    }
    if (finding.blunder == Blunder::Shifted && finding.together > 1) {
        return shifted(finding) + shows(station);
    }
    if (tagged >= 0 && isTaken(taken, tagged, photos, places, lines)) {
        return text("It shows what is seen from ", station, "; the photo tagged so shows ",
                    lines[tagged].name, ": they are swapped.");
    }
    return finding.blunder == Blunder::Shifted ? shifted(finding) + shows(station)
                                               : text("It shows what is seen from ", station, ".");
}

void report(const Judged& judged, std::span<const PhotoPrior> photos, const PlannedLines& lines,
            std::vector<WrongPosition>& wrong) {
    for (std::size_t i = 0; i < photos.size(); ++i) {
        const double movedM = (judged.evidence.positionsM()[i] - photos[i].positionM).norm();
        if (judged.findings[i].timesMoved > 0 && movedM > kSamePositionM) {
            const int photo = static_cast<int>(i);
            const Eigen::Vector3d& takenM = judged.evidence.positionsM()[i];
            wrong.push_back({photo, judged.places[i], takenM, judged.findings[i].confidence,
                             sentence(photo, photos, judged.places, judged.findings[i], takenM, lines)});
        }
    }
}

} // namespace

std::vector<WrongPosition> wrongPositions(std::span<const PhotoPrior> photos,
                                          std::span<const PairEstimate> estimates,
                                          std::span<const PlannedPosition> planned) {
    const PlannedLines lines(planned);
    std::vector<WrongPosition> wrong;
    // A wrong rotation hardly ever closes a triangle: pairs that no triangle confirms do not count.
    for (const Component& component : poseGraph(static_cast<int>(photos.size()), estimates, 1).components) {
        const TagCase of{component, photos, estimates, lines};
        const Judged untouched = start(photos, lines, baselines(estimates, component));
        const std::vector<RoomOrientation> ways = orientations(component, photos, estimates);
        std::optional<Judged> best;
        for (const RoomOrientation& way : ways) {
            if (!way.hasHeading || way.agreeingShare < kLeastAgreeing * ways.front().agreeingShare) {
                continue;
            }
            Judged judged = untouched;
            judged.evidence.turn(way.roomFromComponent);
            judge(of, judged);
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
