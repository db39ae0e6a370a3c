// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/align/content_check.h"

#include "check/content_witness.h"
#include "pairs/pair_geometry.h"

#include "spherewalk/base/parallel.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace spherewalk::align {

namespace {

constexpr double kSharedPlaceM = 0.01;
constexpr double kMostFitSigmas = 4;
/// Error of a direction between positions that are solved to a millimetre.
constexpr Degrees kPositionsSigma{0.02};

bool fitsPoses(const Eigen::Vector3d& baselineM, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
               double sigmaRad) {
    if (baselineM.norm() < kSharedPlaceM) {
        return angleBetween(a, b).value() < kMostFitSigmas * sigmaRad;
    }
    const Eigen::Vector3d direction = baselineM.normalized();
    // Along the baseline any plane fits.
    const EpipolarResidual residual = epipolarResidual(a, b, direction, sigmaRad);
    if (std::min(residual.sineA, residual.sineB) < kLeastSine) {
        return angleBetween(a, b).value() < kLeastSine;
    }
    return std::abs(residual.value) < kMostFitSigmas &&
           parallaxOf(a, b, direction) > -kMostFitSigmas * sigmaRad;
}

} // namespace

std::vector<std::vector<bool>> fittingMatches(std::span<const std::optional<Rigid3>> roomFromPhoto,
                                              std::span<const PhotoPair> pairs) {
    std::vector<std::vector<bool>> result;
    result.reserve(pairs.size());
    for (const PhotoPair& pair : pairs) {
        std::vector<bool>& list = result.emplace_back(pair.matches.size(), false);
        const auto& poseA = roomFromPhoto[static_cast<std::size_t>(pair.a)];
        const auto& poseB = roomFromPhoto[static_cast<std::size_t>(pair.b)];
        if (!poseA || !poseB) {
            continue;
        }
        const Eigen::Vector3d baselineM = poseB->translation - poseA->translation;
        for (std::size_t i = 0; i < list.size(); ++i) {
            const Correspondence& match = pair.matches[i];
            const double sigmaRad = std::hypot(match.sigmaRad, Radians(kPositionsSigma).value());
            list[i] =
                fitsPoses(baselineM, poseA->rotation * match.inA, poseB->rotation * match.inB, sigmaRad);
        }
    }
    return result;
}

namespace {

constexpr Radians kCell = Degrees(4);
constexpr std::array<Degrees, 3> kRadii = {Degrees(4.5), Degrees(8), Degrees(13)};
constexpr int kLeastNeighbours = 3;
constexpr double kStillSeen = 0.1; ///< Share of the chance that is left where the content changed.
constexpr double kLeastScore = 12; ///< In nats.
/// For things that are not found elsewhere in the photo. Clean pictures beside furniture reach about as much.
constexpr double kLeastVanishedScore = 24;
/// Neighbours that look at a thing from farther aside may see behind what hides it.
constexpr Radians kAlong = Degrees(12);
constexpr double kLeastMissed = 5;     ///< Number of things that all neighbours see.
constexpr double kLargestShare = 0.15; ///< Share of the expected things that may be seen all the same.
constexpr double kOneSidedTimes = 1.3; ///< Factor of the score where something may hide the missed things.
constexpr double kAgreedWeight = 0.5;
constexpr std::size_t kMostRegions = 4; ///< With more, the photo is wrong as a whole.
constexpr std::size_t kLeastMoved = 4;
constexpr double kMovedAlikeShare = 0.35; ///< Share of the displacement.
constexpr double kFarthestChord = 0.6;

/// Sums over some directions.
struct Tally {
    double score = 0; ///< Log-likelihood of changed content, less that of the same content.
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

/// The sphere of directions, cut into rows of cells of about equal size.
class SphereCells {
  public:
    explicit SphereCells(double cellRad);

    int size() const { return static_cast<int>(m_centres.size()); }

    /// The cell that holds the direction. Range: unit, finite.
    int cell(const Eigen::Vector3d& direction) const;

    const Eigen::Vector3d& centre(int cell) const { return m_centres[static_cast<std::size_t>(cell)]; }

    /// For each cell the cells with centres within this angle of its own centre.
    std::vector<std::vector<int>> discs(double radiusRad) const;

  private:
    std::vector<int> m_firstOfRow; ///< At the end the number of cells.
    std::vector<Eigen::Vector3d> m_centres;
};

SphereCells::SphereCells(double cellRad) {
    const int rows = std::max(1, static_cast<int>(std::lround(EIGEN_PI / cellRad)));
    for (int row = 0; row < rows; ++row) {
        const double elevation = EIGEN_PI * ((row + 0.5) / rows - 0.5);
        const int columns =
            std::max(1, static_cast<int>(std::lround(2 * EIGEN_PI * std::cos(elevation) / cellRad)));
        m_firstOfRow.push_back(size());
        for (int column = 0; column < columns; ++column) {
            const double azimuth = 2 * EIGEN_PI * (column + 0.5) / columns - EIGEN_PI;
            m_centres.emplace_back(std::cos(elevation) * std::cos(azimuth),
                                   std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
        }
    }
    m_firstOfRow.push_back(size());
}

int SphereCells::cell(const Eigen::Vector3d& direction) const {
    const int rows = static_cast<int>(m_firstOfRow.size()) - 1;
    const double elevation = std::asin(std::clamp(direction.z(), -1., 1.));
    const double azimuth = std::atan2(direction.y(), direction.x());
    const auto row = static_cast<std::size_t>(
        std::clamp(static_cast<int>((elevation / EIGEN_PI + 0.5) * rows), 0, rows - 1));
    const int columns = m_firstOfRow[row + 1] - m_firstOfRow[row];
    const int column = static_cast<int>((azimuth / (2 * EIGEN_PI) + 0.5) * columns);
    return m_firstOfRow[row] + std::clamp(column, 0, columns - 1);
}

std::vector<std::vector<int>> SphereCells::discs(double radiusRad) const {
    const double least = std::cos(radiusRad);
    std::vector<std::vector<int>> discs(m_centres.size());
    for (int i = 0; i < size(); ++i) {
        for (int j = 0; j < size(); ++j) {
            if (centre(i).dot(centre(j)) >= least) {
                discs[static_cast<std::size_t>(i)].push_back(j);
            }
        }
    }
    return discs;
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

struct ChangedRegion : PhotoRegion {
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

/// The disc that speaks most for a change. Empty if none says enough.
std::optional<ChangedRegion> mostChanged(const std::vector<Tally>& all, const Discs& discs) {
    std::optional<ChangedRegion> best;
    for (int cell = 0; cell < discs.cells.size(); ++cell) {
        for (std::size_t i = 0; i < kRadii.size(); ++i) {
            Tally sum;
            for (const int within : discs.ofRadius[i][static_cast<std::size_t>(cell)]) {
                sum += all[static_cast<std::size_t>(within)];
            }
            if (sum.score <= 0) {
                break; // Its middle shows what neighbours see: a better disc lies beside it.
            }
            if (isChanged(sum) && (!best || sum.score > best->tally.score)) {
                best = ChangedRegion{{discs.cells.centre(cell), kRadii[i]}, sum};
            }
        }
    }
    return best;
}

/// Moves the middle to the mean of the missed things.
void fit(const PhotoWitnesses& photo, ChangedRegion& region) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Witness& witness : photo.witnesses) {
        if (!witness.isSeen && isWithin(witness, region)) {
            sum += witness.weight * witness.chance * witness.expected;
        }
    }
    region.middle = sum.norm() > 0 ? Eigen::Vector3d(sum.normalized()) : region.middle;
}

/// The things that neighbours expect in the region and the photo shows near it.
std::vector<const Witness*> displaced(const PhotoWitnesses& photo, const ChangedRegion& region) {
    std::vector<const Witness*> all;
    for (const Witness& witness : photo.witnesses) {
        if (witness.elsewhere && isWithin(witness, region) &&
            (*witness.elsewhere - witness.expected).norm() < kFarthestChord) {
            all.push_back(&witness);
        }
    }
    return all;
}

/// The turn from where neighbours expect things to where the photo shows them, if many moved alike.
std::optional<double> moved(const PhotoWitnesses& photo, const ChangedRegion& region) {
    const std::vector<const Witness*> all = displaced(photo, region);
    std::size_t most = 0;
    double chord = 0;
    for (const Witness* one : all) {
        const Eigen::Vector3d displacement = *one->elsewhere - one->expected;
        std::set<int> alike; // One wrong feature may match those of many neighbours.
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

/// Whether furniture in front may explain as well that the photo misses things.
bool mayBeHidden(const PhotoWitnesses& photo, const ChangedRegion& region, int index,
                 const Sightings& sightings) {
    return isSeenFromOneSide(photo, region, index, sightings) &&
           (hasNearerThings(photo, region) || region.tally.score < kOneSidedTimes * kLeastScore);
}

/// What neighbours say that look at the region from about where the photo stands. Furniture and walls may
/// hide from the photo what the others see.
double scoreAlong(const PhotoWitnesses& photo, const PhotoRegion& region) {
    double score = 0;
    for (const Witness& witness : photo.witnesses) {
        score += witness.aside < kAlong && isWithin(witness, region) ? tally(witness).score : 0;
    }
    return score;
}

std::vector<ChangedContent> changesIn(int index, const Sightings& sightings, const Discs& discs) {
    PhotoWitnesses photo = sightings.witnesses(index);
    std::vector<ChangedContent> changes;
    while (photo.neighbours >= kLeastNeighbours) {
        std::optional<ChangedRegion> region = mostChanged(tallies(photo, discs.cells), discs);
        if (!region) {
            break;
        }
        fit(photo, *region);
        const std::optional<double> movedRad = moved(photo, *region);
        if (movedRad || (scoreAlong(photo, *region) > kLeastVanishedScore &&
                         !mayBeHidden(photo, *region, index, sightings))) {
            const double confidence = 1 - std::exp(-region->tally.score / kLeastScore);
            changes.push_back({index, region->middle, region->radius, confidence, reason(movedRad)});
        }
        if (changes.size() > kMostRegions) {
            return {};
        }
        std::erase_if(photo.witnesses,
                      [&](const Witness& witness) { return isWithin(witness, *region, 1.5); });
    }
    return changes;
}

} // namespace

std::vector<ChangedContent> changedContent(std::span<const std::optional<Rigid3>> roomFromPhoto,
                                           std::span<const PhotoPair> pairs,
                                           std::span<const std::vector<bool>> isInlier,
                                           const ContentCheckOptions& options) {
    const Sightings sightings(roomFromPhoto, pairs, isInlier, options.isSearched);
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
