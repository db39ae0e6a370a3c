// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/align/content_check.h"

#include "content_witness.h"
#include "sphere_cells.h"

#include "spherewalk/base/parallel.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace spherewalk::align {

namespace {

constexpr Radians kCell = Degrees(4);
constexpr std::array<Degrees, 4> kRadii = {Degrees(4.5), Degrees(8), Degrees(13), Degrees(20)};
constexpr int kLeastNeighbours = 3;
constexpr double kStillSeen = 0.1;     ///< of the chance, where the content changed
constexpr double kLeastScore = 12;     ///< nats
constexpr double kLeastMissed = 5;     ///< things that all neighbours see
constexpr double kLargestShare = 0.15; ///< of what is expected, that may be seen all the same
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

struct Part {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    Radians radius;
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
    for (std::size_t i = 0; i < kRadii.size(); ++i) {
        for (int cell = 0; cell < discs.cells.size(); ++cell) {
            Tally sum;
            for (const int within : discs.ofRadius[i][static_cast<std::size_t>(cell)]) {
                sum += all[static_cast<std::size_t>(within)];
            }
            if (isChanged(sum) && (!best || sum.score > best->tally.score)) {
                best = Part{discs.cells.centre(cell), kRadii[i], sum};
            }
        }
    }
    return best;
}

bool isWithin(const Witness& witness, const Part& part, double times = 1) {
    return angleBetween(witness.expected, part.middle) < part.radius * times;
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

/// The turn from where neighbours expect things to where the photo shows them, if many moved alike.
std::optional<double> moved(const PhotoWitnesses& photo, const Part& part) {
    std::vector<Eigen::Vector3d> displacements;
    for (const Witness& witness : photo.witnesses) {
        if (witness.elsewhere && isWithin(witness, part) &&
            (*witness.elsewhere - witness.expected).norm() < kFarthestChord) {
            displacements.emplace_back(*witness.elsewhere - witness.expected);
        }
    }
    std::size_t most = 0;
    double chord = 0;
    for (const Eigen::Vector3d& one : displacements) {
        const auto alike =
            static_cast<std::size_t>(std::ranges::count_if(displacements, [&](const Eigen::Vector3d& other) {
                return (other - one).norm() < kMovedAlikeShare * one.norm();
            }));
        if (alike > most) {
            most = alike;
            chord = one.norm();
        }
    }
    return most >= kLeastMoved && 3 * most > displacements.size() ? std::optional(2 * std::asin(chord / 2))
                                                                  : std::nullopt;
}

std::string reason(const PhotoWitnesses& photo, const Part& part) {
    if (const std::optional<double> turnRad = moved(photo, part)) {
        return text("What its neighbours see there stands about ",
                    fixed(Degrees(Radians(*turnRad)).value(), 0), " degrees away in this photo: it moved.");
    }
    return text("What its neighbours see there is not in this photo: it moved, vanished or is covered.");
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
        const double confidence = 1 - std::exp(-part->tally.score / kLeastScore);
        changes.push_back({index, part->middle, part->radius, confidence, reason(photo, *part)});
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
