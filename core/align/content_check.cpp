// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/align/content_check.h"

#include "content_occlusion.h"
#include "content_witness.h"
#include "sphere_cells.h"

#include "spherewalk/base/parallel.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace spherewalk::align {

namespace {

constexpr Radians kCell = Degrees(4);
constexpr std::array<Degrees, 3> kRadii = {Degrees(4.5), Degrees(8), Degrees(13)};
constexpr int kLeastNeighbours = 3;
constexpr double kStillSeen = 0.1; ///< of the chance, where the content changed
constexpr double kLeastScore = 12; ///< nats
/// Of what is not found elsewhere in the photo either. Clean pictures beside furniture reach about as much.
constexpr double kLeastVanishedScore = 24;
constexpr double kLeastMissed = 5;     ///< things that all neighbours see
constexpr double kLargestShare = 0.15; ///< of what is expected, that may be seen all the same
constexpr double kOneSidedTimes = 1.3; ///< as much is asked where something might hide what is missed
constexpr double kAgreedWeight = 0.5;
constexpr std::size_t kMostParts = 4; ///< more: the photo is wrong as a whole
constexpr std::size_t kLeastMoved = 4;
constexpr double kMovedAlikeShare = 0.35; ///< of the displacement
constexpr double kFarthestChord = 0.6;

/// Sums over some directions.
struct Tally {
    double score = 0; ///< log-likelihood of changed content over that of the same
    double expected = 0;
    double seen = 0;
    double missed = 0;

    void operator+=(const Tally& other) {
        score += other.score;
        expected += other.expected;
        seen += other.seen;
        missed += other.missed;
    }
};

Tally tally(const Witness& witness) {
    const double score = witness.isSeen ? std::log(kStillSeen)
                                        : std::log((1 - kStillSeen * witness.chance) / (1 - witness.chance));
    return {witness.weight * score, witness.weight * witness.chance, witness.isSeen ? witness.weight : 0,
            witness.isSeen ? 0 : witness.weight};
}

/// The cells and, for each radius, the discs of cells.
struct Discs {
    SphereCells cells{kCell.value()};
    std::vector<std::vector<std::vector<int>>> ofRadius;

    Discs() {
        for (const Degrees radius : kRadii) {
            ofRadius.push_back(cells.discs(Radians(radius).value()));
        }
    }
};

struct Part : PhotoPart {
    Tally tally;
};

std::vector<Tally> tallies(const PhotoWitnesses& photo, const SphereCells& cells) {
    std::vector<Tally> all(static_cast<std::size_t>(cells.size()));
    for (const Witness& witness : photo.witnesses) {
        all[static_cast<std::size_t>(cells.cell(witness.expected))] += tally(witness);
    }
    for (const Eigen::Vector3d& direction : photo.agreed) {
        all[static_cast<std::size_t>(cells.cell(direction))].score += kAgreedWeight * std::log(kStillSeen);
    }
    return all;
}

bool isChanged(const Tally& tally) {
    return tally.score > kLeastScore && tally.missed > kLeastMissed &&
           tally.seen < kLargestShare * tally.expected;
}

/// The disc that speaks most for a change; nothing if none says enough.
std::optional<Part> mostChanged(const std::vector<Tally>& all, const Discs& discs) {
    std::optional<Part> best;
    for (int cell = 0; cell < discs.cells.size(); ++cell) {
        for (std::size_t i = 0; i < kRadii.size(); ++i) {
            Tally sum;
            for (const int within : discs.ofRadius[i][static_cast<std::size_t>(cell)]) {
                sum += all[static_cast<std::size_t>(within)];
            }
            if (sum.score <= 0) {
                break; // its middle shows what neighbours see: a better disc lies beside it
            }
            if (isChanged(sum) && (!best || sum.score > best->tally.score)) {
                best = Part{{discs.cells.centre(cell), kRadii[i]}, sum};
            }
        }
    }
    return best;
}

/// Lays the middle among what is missed, and the radius around nearly all of it.
void fit(const PhotoWitnesses& photo, Part& part) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Witness& witness : photo.witnesses) {
        if (!witness.isSeen && isWithin(witness, part)) {
            sum += witness.weight * witness.chance * witness.expected;
        }
    }
    part.middle = sum.norm() > 0 ? Eigen::Vector3d(sum.normalized()) : part.middle;
}

/// What neighbours expect in the part and the photo shows near it.
std::vector<const Witness*> displaced(const PhotoWitnesses& photo, const Part& part) {
    std::vector<const Witness*> all;
    for (const Witness& witness : photo.witnesses) {
        if (witness.elsewhere && isWithin(witness, part) &&
            (*witness.elsewhere - witness.expected).norm() < kFarthestChord) {
            all.push_back(&witness);
        }
    }
    return all;
}

/// The turn from where neighbours expect things to where the photo shows them, if many moved alike.
std::optional<double> moved(const PhotoWitnesses& photo, const Part& part) {
    const std::vector<const Witness*> all = displaced(photo, part);
    std::size_t most = 0;
    double chord = 0;
    for (const Witness* one : all) {
        const Eigen::Vector3d displacement = *one->elsewhere - one->expected;
        std::set<int> alike; // one wrong feature may match those of many neighbours
        for (const Witness* other : all) {
            if ((*other->elsewhere - other->expected - displacement).norm() <
                kMovedAlikeShare * displacement.norm()) {
                alike.insert(other->featureElsewhere);
            }
        }
        if (alike.size() > most) {
            most = alike.size();
            chord = displacement.norm();
        }
    }
    return most >= kLeastMoved ? std::optional(2 * std::asin(chord / 2)) : std::nullopt;
}

std::string reason(const std::optional<double>& movedRad) {
    if (movedRad) {
        return text("What its neighbours see there stands about ",
                    fixed(Degrees(Radians(*movedRad)).value(), 0), " degrees away in this photo: it moved.");
    }
    return "What its neighbours see there is not in this photo: it moved, vanished or is covered.";
}

/// Whether furniture in front explains as well that the photo misses what its neighbours see.
bool mayBeHidden(const PhotoWitnesses& photo, const Part& part, int index, const Sightings& sightings) {
    return isSeenFromOneSide(photo, part, index, sightings) &&
           (hasNearerThings(photo, part) || part.tally.score < kOneSidedTimes * kLeastScore);
}

std::vector<ChangedContent> changesIn(int index, const Sightings& sightings, const Discs& discs) {
    PhotoWitnesses photo = sightings.witnesses(index);
    std::vector<ChangedContent> changes;
    while (photo.neighbours >= kLeastNeighbours) {
        std::optional<Part> part = mostChanged(tallies(photo, discs.cells), discs);
        if (!part) {
            break;
        }
        fit(photo, *part);
        const std::optional<double> movedRad = moved(photo, *part);
        if (movedRad ||
            (part->tally.score > kLeastVanishedScore && !mayBeHidden(photo, *part, index, sightings))) {
            const double confidence = 1 - std::exp(-part->tally.score / kLeastScore);
            changes.push_back({index, part->middle, part->radius, confidence, reason(movedRad)});
        }
        if (changes.size() > kMostParts) {
            return {};
        }
        std::erase_if(photo.witnesses, [&](const Witness& witness) { return isWithin(witness, *part, 1.5); });
    }
    return changes;
}

} // namespace

std::vector<ChangedContent> changedContent(std::span<const std::optional<Rigid3>> roomFromPhoto,
                                           std::span<const PhotoPair> pairs,
                                           std::span<const std::vector<bool>> isInlier,
                                           const ContentCheckOptions& options) {
    const Sightings sightings(roomFromPhoto, pairs, isInlier);
    const Discs discs;
    const int count = static_cast<int>(roomFromPhoto.size());
    std::vector<std::vector<ChangedContent>> changes(roomFromPhoto.size());
    parallelFor(count, 4, options.threads, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            changes[static_cast<std::size_t>(i)] = changesIn(i, sightings, discs);
        }
    });
    std::vector<ChangedContent> all;
    for (std::vector<ChangedContent>& some : changes) {
        all.insert(all.end(), std::make_move_iterator(some.begin()), std::make_move_iterator(some.end()));
    }
    return all;
}

} // namespace spherewalk::align
