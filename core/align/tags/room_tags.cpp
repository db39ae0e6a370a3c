// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/align/room_tags.h"

#include "pairs/pair_geometry.h"
#include "tags/changed_misses.h"

#include "spherewalk/base/statistics.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace spherewalk::align {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kLeastSigmaRad = 1e-4;
constexpr double kReachRad = 0.012;     ///< A photo that misses a corner by more sees another tag.
constexpr double kMostSigmaShare = 0.2; ///< Of a tag's size: a corner known worse says nothing.
constexpr double kPrinted = 0.001;      ///< One sheet's size against another's, as a share: paper curls.
constexpr double kMeasured = 0.001;     ///< A ruler's error on a tag, as a share; all tags have it in common.
constexpr double kTorn = 0.03;          ///< At the seam of two lenses pictures of tags are torn.

/// A corner as one photo sees it, in the frame of the photos' places.
struct CornerRay {
    Vector3d from;
    Vector3d direction;
    double sigmaRad = 0;
};

struct Sight {
    int photo = 0;
    photo::TagCorners<CornerRay> rays;
};

/// A square: its middle, its axes to the right, down and into the wall, and its side.
struct Square {
    Rigid3 roomFromSquare;
    double size = 1;

    Vector3d corner(std::size_t i) const {
        const double x = i == 1 || i == 2 ? 0.5 : -0.5;
        const double y = i >= 2 ? 0.5 : -0.5;
        return roomFromSquare * (size * Vector3d(x, y, 0));
    }
};

Vector3d missOf(const CornerRay& ray, const Vector3d& point) {
    const Vector3d apart = point - ray.from;
    return apart / std::max(apart.norm(), 1e-12) - ray.direction;
}

/// Where the rays come nearest to each other.
Vector3d meeting(std::span<const Sight> sights, std::size_t corner) {
    Matrix3d matrix = Matrix3d::Zero();
    Vector3d right = Vector3d::Zero();
    for (const Sight& sight : sights) {
        const CornerRay& ray = sight.rays[corner];
        const Matrix3d across = Matrix3d::Identity() - ray.direction * ray.direction.transpose();
        matrix += across;
        right += across * ray.from;
    }
    return matrix.ldlt().solve(right);
}

/// A square about the places where rays meet; empty where they hardly meet.
std::optional<Square> firstSquare(std::span<const Sight> sights) {
    photo::TagCorners<Vector3d> at;
    for (std::size_t i = 0; i < at.size(); ++i) {
        at[i] = meeting(sights, i);
        const bool isInFront = std::ranges::all_of(sights, [&](const Sight& sight) {
            return sight.rays[i].direction.dot(at[i] - sight.rays[i].from) > 0;
        });
        if (!at[i].allFinite() || !isInFront) {
            return std::nullopt;
        }
    }
    const Vector3d across = at[1] - at[0] + at[2] - at[3];
    const Vector3d down = at[3] - at[0] + at[2] - at[1];
    Square square;
    square.size = (across.norm() + down.norm()) / 4;
    Matrix3d axes;
    axes.col(0) = across.normalized();
    axes.col(2) = across.cross(down).normalized();
    axes.col(1) = axes.col(2).cross(axes.col(0));
    if (!axes.allFinite() || !(square.size > 0)) {
        return std::nullopt;
    }
    square.roomFromSquare = {Eigen::Quaterniond(axes), (at[0] + at[1] + at[2] + at[3]) / 4};
    return square;
}

/// The square after a small change: a turn, a shift in sizes, and the logarithm of the size.
Square changed(const Square& square, const Eigen::Matrix<double, 7, 1>& change) {
    Square made = square;
    made.roomFromSquare.rotation = (square.roomFromSquare.rotation * turn(change.head<3>())).normalized();
    made.roomFromSquare.translation += square.size * change.segment<3>(3);
    made.size *= std::exp(change[6]);
    return made;
}

double worstMiss(const Square& square, const Sight& sight) {
    double worst = 0;
    for (std::size_t i = 0; i < sight.rays.size(); ++i) {
        worst = std::max(worst, missOf(sight.rays[i], square.corner(i)).norm());
    }
    return worst;
}

/// One tag's square by least squares, and how well it is known.
class TagSolver {
  public:
    using Normal = Eigen::Matrix<double, 7, 7>;

    explicit TagSolver(std::span<const Sight> sights) : m_sights(sights) {}

    std::optional<Square> square() const {
        std::optional<Square> made = firstSquare(m_sights);
        if (!made) {
            return std::nullopt;
        }
        made = changed(*made, ChangedMisses<7, Residuals>({m_sights, *made}, kStep).solved());
        return made->roomFromSquare.translation.allFinite() ? made : std::nullopt;
    }

    /// The covariance of the change. All corners of a photo err together where its pose does, so photos are
    /// what is counted. Source: Cameron and Miller 2015, cluster-robust inference.
    Normal covariance(const Square& square) const {
        const Residuals residuals{m_sights, square};
        const auto slopes =
            ChangedMisses<7, Residuals>(residuals, kStep).slopesAt(Eigen::Matrix<double, 7, 1>::Zero());
        const Eigen::VectorXd misses = residuals(Eigen::Matrix<double, 7, 1>::Zero());
        const Normal inverse = (slopes.transpose() * slopes).ldlt().solve(Normal::Identity());
        Normal meat = Normal::Zero();
        constexpr Eigen::Index kRows = 12; // Of a photo.
        for (Eigen::Index row = 0; row < misses.size(); row += kRows) {
            const Eigen::Matrix<double, 7, 1> pull =
                slopes.middleRows<kRows>(row).transpose() * misses.segment<kRows>(row);
            meat += pull * pull.transpose();
        }
        const auto photos = static_cast<double>(m_sights.size());
        const double freedom = std::max(1.0, 8 * photos - 7);
        const Normal formal = inverse * std::max(1.0, misses.squaredNorm() / freedom);
        const Normal clustered = inverse * meat * inverse * (photos / std::max(1.0, photos - 1));
        return formal.trace() > clustered.trace() ? formal : clustered;
    }

  private:
    static constexpr double kStep = 1e-5;

    struct Residuals {
        std::span<const Sight> sights;
        Square about;

        Eigen::VectorXd operator()(const Eigen::Matrix<double, 7, 1>& change) const {
            const Square square = changed(about, change);
            Eigen::VectorXd made(static_cast<Eigen::Index>(12 * sights.size()));
            Eigen::Index row = 0;
            for (const Sight& sight : sights) {
                for (std::size_t i = 0; i < sight.rays.size(); ++i, row += 3) {
                    made.segment<3>(row) = missOf(sight.rays[i], square.corner(i)) / sight.rays[i].sigmaRad;
                }
            }
            return made;
        }
    };

    std::span<const Sight> m_sights;
};

std::optional<Sight> sightOf(const TagSighting& sighting,
                             std::span<const std::optional<PlacedPhoto>> photos) {
    const auto& photo = photos[static_cast<std::size_t>(sighting.photo)];
    if (!photo) {
        return std::nullopt;
    }
    Sight sight;
    sight.photo = sighting.photo;
    for (std::size_t i = 0; i < sight.rays.size(); ++i) {
        const Vector3d& seen = sighting.tag.directions[i];
        if (photo->lenses.aheadM != 0 && std::abs(seen.x()) < kTorn) {
            return std::nullopt;
        }
        sight.rays[i] = {photo->roomFromPhoto * photo->lenses.place(seen),
                         photo->roomFromPhoto.rotation * seen,
                         std::max(kLeastSigmaRad, sighting.tag.sigmaRad)};
    }
    return sight;
}

/// The sights that most of them agree with: those of one tag, if several have the number. So many pairs are
/// tried that one of agreeing sights is among them, even where most sights err.
std::vector<Sight> agreeing(std::span<const Sight> sights) {
    constexpr std::size_t kMostPairs = 2000;
    const std::size_t every = sights.size() * sights.size() / 2 / kMostPairs + 1;
    std::vector<Sight> best;
    double bestMiss = 0;
    std::size_t pair = 0;
    for (std::size_t i = 0; i < sights.size() && best.size() < sights.size(); ++i) {
        for (std::size_t j = i + 1; j < sights.size(); ++j) {
            if (pair++ % every != 0) {
                continue;
            }
            const std::array two{sights[i], sights[j]};
            const std::optional<Square> square = firstSquare(two);
            if (!square) {
                continue;
            }
            std::vector<Sight> agree;
            double miss = 0;
            for (const Sight& sight : sights) {
                const double own = worstMiss(*square, sight);
                if (own < kReachRad) {
                    agree.push_back(sight);
                    miss += own;
                }
            }
            if (agree.size() > best.size() || (agree.size() == best.size() && miss < bestMiss)) {
                best = std::move(agree);
                bestMiss = miss;
            }
        }
    }
    return best;
}

std::string namesOf(std::span<const Sight> sights, std::span<const std::optional<PlacedPhoto>> photos) {
    std::string names;
    for (std::size_t i = 0; i < std::min<std::size_t>(sights.size(), 3); ++i) {
        names += text(i == 0 ? "" : ", ", photos[static_cast<std::size_t>(sights[i].photo)]->name);
    }
    return sights.size() > 3 ? text(names, " and ", sights.size() - 3, " more") : names;
}

double missOf(const Square& square, const Sight& sight) {
    double squares = 0;
    for (std::size_t i = 0; i < sight.rays.size(); ++i) {
        squares += std::pow(missOf(sight.rays[i], square.corner(i)).norm() / sight.rays[i].sigmaRad, 2);
    }
    return std::sqrt(squares / 8);
}

/// Without the photos that miss by far more than most: they see the tag in part, or err in their pose.
std::vector<Sight> withoutStrays(std::vector<Sight> sights) {
    constexpr double kStray = 5;
    while (sights.size() > 3) {
        const std::optional<Square> square = TagSolver(sights).square();
        if (!square) {
            break;
        }
        std::vector<double> misses;
        for (const Sight& sight : sights) {
            misses.push_back(missOf(*square, sight));
        }
        const auto worst = std::ranges::max_element(misses);
        if (*worst < kStray * std::max(1.0, median(misses))) {
            break;
        }
        sights.erase(sights.begin() + (worst - misses.begin()));
    }
    return sights;
}

std::optional<RoomTag> placed(int number, std::span<const Sight> sights) {
    const TagSolver solver(sights);
    const std::optional<Square> square = solver.square();
    if (!square) {
        return std::nullopt;
    }
    const TagSolver::Normal covariance = solver.covariance(*square);
    RoomTag tag;
    tag.number = number;
    tag.size = square->size;
    tag.sizeSigma = square->size * std::sqrt(std::max(0.0, covariance(6, 6)));
    tag.photos = static_cast<int>(sights.size());
    const Matrix3d place = covariance.block<3, 3>(3, 3);
    const Matrix3d lean = covariance.topLeftCorner<3, 3>() / 2; // A corner lies 0.7 sizes from the middle.
    tag.sigma = square->size * std::sqrt(std::max(0.0, (place + lean).eigenvalues().real().maxCoeff()));
    for (std::size_t i = 0; i < tag.corners.size(); ++i) {
        tag.corners[i] = square->corner(i);
    }
    return tag.sigma < kMostSigmaShare * tag.size ? std::optional(tag) : std::nullopt;
}

std::optional<Scale> scaleOf(std::span<const RoomTag> tags, double sizeM) {
    double weights = 0;
    double sum = 0;
    for (const RoomTag& tag : tags) {
        const double weight = 1 / (std::pow(tag.sizeSigma / tag.size, 2) + kPrinted * kPrinted);
        weights += weight;
        sum += weight * tag.size / sizeM;
    }
    if (tags.empty()) {
        return std::nullopt;
    }
    const double value = sum / weights;
    double chi = 0;
    for (const RoomTag& tag : tags) {
        const double weight = 1 / (std::pow(tag.sizeSigma / tag.size, 2) + kPrinted * kPrinted);
        chi += weight * std::pow(tag.size / sizeM / value - 1, 2);
    }
    const double excess = tags.size() > 1 ? chi / static_cast<double>(tags.size() - 1) : 1;
    return Scale{value, value * std::hypot(std::sqrt(std::max(1.0, excess) / weights), kMeasured)};
}

} // namespace

RoomTags roomTags(std::span<const std::optional<PlacedPhoto>> photos, std::span<const TagSighting> sightings,
                  double sizeM) {
    std::map<int, std::vector<Sight>> byNumber;
    for (const TagSighting& sighting : sightings) {
        if (const std::optional<Sight> sight = sightOf(sighting, photos)) {
            byNumber[sighting.tag.number].push_back(*sight);
        }
    }
    RoomTags made;
    for (const auto& [number, sights] : byNumber) {
        const std::vector<Sight> agree = agreeing(sights);
        const std::optional<RoomTag> tag =
            agree.empty() ? std::nullopt : placed(number, withoutStrays(agree));
        if (!tag) {
            made.warnings.push_back(text("Where AprilTag ", number, " hangs is not known: ",
                                         counted(static_cast<int>(sights.size()), "photo sees", "photos see"),
                                         " it (", namesOf(sights, photos),
                                         "), but not from places far enough apart. Take a photo near it."));
            continue;
        }
        made.tags.push_back(*tag);
        std::vector<Sight> others;
        std::ranges::copy_if(sights, std::back_inserter(others), [&](const Sight& sight) {
            return std::ranges::none_of(agree, [&](const Sight& one) {
                return one.photo == sight.photo && one.rays[0].direction == sight.rays[0].direction;
            });
        });
        if (!others.empty()) {
            made.warnings.push_back(text("AprilTag ", number, " hangs in more than one place, or was moved: ",
                                         counted(tag->photos, "photo sees", "photos see"), " it at (",
                                         fixed(tag->corners[0].x(), 2), ", ", fixed(tag->corners[0].y(), 2),
                                         ", ", fixed(tag->corners[0].z(), 2), "), but ",
                                         namesOf(others, photos), " elsewhere. Hang each number once."));
        }
    }
    made.scale = scaleOf(made.tags, sizeM);
    return made;
}

} // namespace spherewalk::align
