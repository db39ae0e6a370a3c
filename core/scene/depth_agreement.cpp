// SPDX-License-Identifier: GPL-3.0-or-later
#include "plane_filters.h"
#include "small_surfaces.h"
#include "vector_math.h"

#include "spherewalk/base/parallel.h"
#include "spherewalk/base/statistics.h"
#include "spherewalk/photo/picture_file.h"
#include "spherewalk/scene/depth_sweep.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace spherewalk::scene {

namespace {

constexpr float kShare = 0.015F; ///< Share of 1 / distance by which two depths may differ.
constexpr float kPixels = 0.75F; ///< Parallax in pixels by which two depths may differ.
constexpr int kBeside = 2;       ///< Half the sides of the squares in which confirmed pixels are counted.
constexpr int kAbout = 10;
constexpr int kWidely = 60;
constexpr float kChance = 0.35F;       ///< Share of the pixels that neighbours may confirm by chance.
constexpr float kCertain = 0.7F;       ///< Share from which the pixels' depth counts in full.
constexpr float kChanceOfPhoto = 0.2F; ///< The same of what is evident in a whole photo.
constexpr float kCertainOfPhoto = 0.4F;
constexpr float kBareWeight = 0.004F; ///< Of a depth that is confirmed, but not evident.
constexpr float kSureShare = 0.9F; ///< Of what lies about a bare depth, so much is confirmed if it is sure.
constexpr float kLeastWeight = 0.05F; ///< From which a depth is kept as it was found.
constexpr double kLargeSurface = 300; ///< Pixels of a surface that counts in full for what is continued.
constexpr float kOnSurface = 0.03F; ///< Share of 1 / distance by which a depth may differ from the surface's.
constexpr float kNearestM = 0.2F;
constexpr float kFarthestM = 100;

/// Marks in a row what the neighbour gives the same distance to.
void markConfirmed(const Plane& inverseM, SeenByOther& seen, int y, const Plane& neighbourInverseM,
                   std::uint8_t* marks) {
    const int width = inverseM.width();
    const float pixelRad = 2 * std::numbers::pi_v<float> / static_cast<float>(width);
    const float parallax = kPixels * pixelRad / std::max(seen.apartM(), 1e-3F);
    seen.enter(y);
    for (int x = 0; x < width; ++x) {
        const Eigen::Vector3f point = seen.at(x, *inverseM.at(x, y));
        const float expected = 1 / std::max(1e-6F, point.norm());
        const FastPixel at = fastPixel(point.x(), point.y(), point.z(), static_cast<float>(width));
        const int atX = nearestInt(at.u) % width;
        const int atY = std::min(nearestInt(at.v), neighbourInverseM.height() - 1);
        const bool agrees =
            std::fabs(*neighbourInverseM.at(atX, atY) - expected) < kShare * expected + parallax;
        marks[x] = agrees ? 255 : marks[x];
    }
}

/// Where a neighbour says the same.
MaskImage confirmed(const PosedDepth& photo, std::span<const PosedDepth> neighbours, int threads) {
    const Plane& inverseM = photo.depth->inverseM;
    const PixelAngles angles(inverseM.width());
    MaskImage result(inverseM.width(), inverseM.height());
    parallelFor(result.height(), 8, threads, [&](int begin, int end) {
        for (const PosedDepth& neighbour : neighbours) {
            SeenByOther seen(neighbour.roomFromPhoto.inverse() * photo.roomFromPhoto, photo.lenses,
                             neighbour.lenses, angles);
            for (int y = begin; y < end; ++y) {
                markConfirmed(inverseM, seen, y, neighbour.depth->inverseM, result.at(0, y));
            }
        }
    });
    return result;
}

Plane sharesAbout(const MaskImage& mask, int radius, int threads) {
    Plane result(mask.width(), mask.height());
    std::transform(mask.values().begin(), mask.values().end(), result.values().begin(),
                   [](std::uint8_t value) { return value != 0 ? 1.0F : 0.0F; });
    blur(result, radius, threads);
    return result;
}

/// reach: in pixels of a depth of the usual width.
Plane sharesWithin(int reach, const MaskImage& mask, int threads) {
    return sharesAbout(mask, std::max(1, reach * mask.width() / kUsualWidth), threads);
}

/// How far a share is above what chance makes, from 0 to 1.
float aboveChance(float share) {
    return std::clamp((share - kChance) / (kCertain - kChance), 0.0F, 1.0F);
}

/// The same for the share of what is evident in a whole photo, which may look into rooms that no other photo
/// sees. Rows count by their length on the sphere. Of a bare wall much is confirmed by chance.
float aboveChance(const MaskImage& evident, const MaskImage& confirmed) {
    constexpr double kBareShare = 0.01;
    double all = 0;
    double sum = 0;
    for (int y = 0; y < confirmed.height(); ++y) {
        const double length = std::sin(std::numbers::pi * (y + 0.5) / confirmed.height());
        for (int x = 0; x < confirmed.width(); ++x) {
            const double area = *evident.at(x, y) != 0 ? length : kBareShare * length;
            all += area;
            sum += *confirmed.at(x, y) != 0 ? area : 0;
        }
    }
    const auto share = static_cast<float>(sum / all);
    return std::clamp((share - kChanceOfPhoto) / (kCertainOfPhoto - kChanceOfPhoto), 0.0F, 1.0F);
}

/// How much each confirmed depth counts, from 0 to 1. Where neighbours contradict most of what lies about,
/// the rest was confirmed by chance. At the border of what is confirmed a depth may belong to the thing
/// beside.
Plane weights(const MaskImage& evident, const MaskImage& confirmed, const Plane& about, int threads) {
    const Plane beside = sharesWithin(kBeside, confirmed, threads);
    const Plane widely = sharesWithin(kWidely, confirmed, threads);
    const float ofPhoto = aboveChance(evident, confirmed);
    Plane result(evident.width(), evident.height());
    for (std::size_t i = 0; i < result.values().size(); ++i) {
        if (confirmed.values()[i] != 0) {
            const float share = ofPhoto * aboveChance(about.values()[i]) * aboveChance(widely.values()[i]);
            result.values()[i] = share * beside.values()[i] * beside.values()[i] *
                                 (evident.values()[i] != 0 ? 1.0F : kBareWeight);
        }
    }
    return result;
}

/// The values with a weight. The others are joined to nothing.
Plane weighted(const Plane& inverseM, const Plane& weight) {
    Plane known = inverseM;
    for (std::size_t i = 0; i < weight.values().size(); ++i) {
        known.values()[i] = weight.values()[i] > 0 ? inverseM.values()[i] : -1;
    }
    return known;
}

/// What is known in small surfaces only does not count.
void dropSpecks(const Plane& inverseM, Plane& weight) {
    forEachSpeck(weighted(inverseM, weight), [&](const std::vector<std::size_t>& pixels) {
        for (const std::size_t i : pixels) {
            weight.values()[i] = 0;
        }
    });
}

/// The smaller a surface is, the less it counts: a few pixels that are wrong then pull less of a wall along.
void weighBySize(const Plane& inverseM, Plane& weight) {
    const double scale = inverseM.width() / double{kUsualWidth};
    const double large = kLargeSurface * scale * scale;
    const Plane known = weighted(inverseM, weight);
    Surfaces(known).forEach([&](const std::vector<std::size_t>& pixels) {
        const auto share = static_cast<float>(std::min(1.0, static_cast<double>(pixels.size()) / large));
        for (const std::size_t i : pixels) {
            weight.values()[i] *= share;
        }
    });
}

/// The median of what is evident, or of all if nothing is. Rows count by their length on the sphere.
float usualInverse(const PhotoDepth& depth) {
    std::vector<float> evident;
    std::vector<float> all;
    for (int y = 0; y < depth.sure.height(); ++y) {
        const double length = std::sin(std::numbers::pi * (y + 0.5) / depth.sure.height());
        const int step = static_cast<int>(std::min(4 / length, static_cast<double>(depth.sure.width())));
        for (int x = 0; x < depth.sure.width(); x += step) {
            all.push_back(*depth.inverseM.at(x, y));
            if (*depth.sure.at(x, y) != 0) {
                evident.push_back(all.back());
            }
        }
    }
    return quantileInPlace(evident.empty() ? all : evident, 0.5);
}

Plane completed(const PhotoDepth& depth, const Plane& weight, const RgbImage& picture, const Plane& base,
                int threads) {
    const RgbImage guide = photo::resized(picture, weight.width(), weight.height());
    return completedByPlanes(depth.inverseM, weight, guide, base,
                             {base.empty() ? usualInverse(depth) : 0, 1 / kFarthestM, 1 / kNearestM},
                             threads);
}

} // namespace

Plane continuedFromSure(const PhotoDepth& depth, const RgbImage& picture, const Plane& base, int threads) {
    Plane weight = sharesAbout(depth.sure, kBeside, threads);
    for (std::size_t i = 0; i < weight.values().size(); ++i) {
        weight.values()[i] = depth.sure.values()[i] != 0 ? weight.values()[i] * weight.values()[i] : 0;
    }
    weighBySize(depth.inverseM, weight);
    Plane result = completed(depth, weight, picture, base, threads);
    for (std::size_t i = 0; i < result.values().size(); ++i) {
        result.values()[i] = depth.sure.values()[i] != 0 ? depth.inverseM.values()[i] : result.values()[i];
    }
    return result;
}

PhotoDepth agreeingDepth(const PosedDepth& photo, const RgbImage& picture,
                         std::span<const PosedDepth> neighbours, int threads) {
    const PhotoDepth& own = *photo.depth;
    const MaskImage agreed = confirmed(photo, neighbours, threads);
    const Plane about = sharesWithin(kAbout, agreed, threads);
    Plane weight = weights(own.sure, agreed, about, threads);
    dropSpecks(own.inverseM, weight);
    const Plane planes = completed(own, weight, picture, {}, threads);
    PhotoDepth result{planes, MaskImage(own.sure.width(), own.sure.height())};
    for (std::size_t i = 0; i < weight.values().size(); ++i) {
        const float found = own.inverseM.values()[i];
        const bool isEvident = own.sure.values()[i] != 0;
        if (weight.values()[i] > (isEvident ? kLeastWeight : kBareWeight * kLeastWeight)) {
            const bool fits =
                about.values()[i] > kSureShare && std::fabs(found - planes.values()[i]) < kOnSurface * found;
            result.inverseM.values()[i] = isEvident ? found : planes.values()[i];
            result.sure.values()[i] = isEvident || fits ? 255 : 0;
        }
    }
    forEachSpeck(Plane(result.inverseM), [&](const std::vector<std::size_t>& pixels) {
        for (const std::size_t i : pixels) {
            result.inverseM.values()[i] = planes.values()[i];
        }
    });
    result.inverseM = smoothedSurfaces(result.inverseM, threads);
    return result;
}

} // namespace spherewalk::scene
