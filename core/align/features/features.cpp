// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/align/features.h"

#include "features/keypoints.h"
#include "features/option_check.h"
#include "features/sphere_view.h"

#include "spherewalk/base/enum_names.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/jpeg/jpeg.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numbers>

namespace spherewalk::align {

namespace {

constexpr int kLeastWidth = 64;  ///< Least width of a photo in pixels.
constexpr int kTile = 768;       ///< In pixels; bounds the memory and the time until a stop is heard.
constexpr float kLargestPx = 48; ///< Larger spots are too blurred to tell a direction.
constexpr double kOwnPx = 2;     ///< Within this distance one of several orientations or scales is enough.
constexpr double kLeastSigmaPx = 0.13; ///< In the camera's own pixels, from noise and compression; measured.
constexpr std::array<Squeeze, 4> kSqueezes{{{1.6, 1}, {2.5, 1}, {1, 1.6}, {1, 2.5}}};
constexpr double kOneThingPx = 3;     ///< Features of several views within this distance show one thing.
constexpr double kMaskedAround = 1.5; ///< In diameters of a spot: a mask's edge must not look like a thing.

/// What was found in a piece of a view. One entry a feature.
struct Tile {
    std::vector<Spot> spots;
    std::vector<float> sigmasRad;
    std::vector<std::uint8_t> descriptors;
};

GreyImage cut(const GreyImage& from, int left, int top, int width, int height) {
    GreyImage part(width, height);
    for (int y = 0; y < height; ++y) {
        std::memcpy(part.at(0, y), from.at(left, top + y), static_cast<std::size_t>(width));
    }
    return part;
}

/// Begins and ends of pieces of [begin, end), about equal and not longer than a tile. Joints are multiples of
/// 32 so that each tile halves the picture at the same pixels.
std::vector<std::pair<int, int>> pieces(int begin, int end) {
    const int count = std::max(1, (end - begin + kTile - 1) / kTile);
    std::vector<std::pair<int, int>> result;
    for (int i = 0, from = begin; i < count; ++i) {
        const int to = i + 1 == count ? end : begin + (end - begin) * (i + 1) / count / 32 * 32;
        result.emplace_back(from, to);
        from = to;
    }
    return result;
}

bool isLeftOut(const MaskImage& mask, const Eigen::Vector3d& bearing, double aroundRad) {
    if (mask.empty()) {
        return false;
    }
    const Eigen::Vector3d side = bearing.unitOrthogonal();
    const Eigen::Vector3d other = bearing.cross(side);
    const EquirectSize size{mask.width(), mask.height()};
    const auto isZero = [&](const Eigen::Vector3d& at) {
        const Eigen::Vector2d p = pixel(size, at);
        const int x = static_cast<int>(std::lround(p.x()));
        return *mask.at(((x % size.width) + size.width) % size.width,
                        std::clamp(static_cast<int>(std::lround(p.y())), 0, size.height - 1)) == 0;
    };
    bool isOut = isZero(bearing);
    for (int i = 0; i < 8 && !isOut; ++i) {
        const double turn = i * std::atan(1.0);
        isOut = isZero((bearing + aroundRad * (std::cos(turn) * side + std::sin(turn) * other)).normalized());
    }
    return isOut;
}

class FeatureFinder {
  public:
    FeatureFinder(const FeatureOptions& options, const MaskImage& mask, std::stop_token stop, int cameraWidth)
        : m_options(options),
          m_mask(mask),
          m_stop(std::move(stop)),
          m_leastSigmaRad(kLeastSigmaPx * 2 * std::numbers::pi / cameraWidth),
          m_detector(options) {}

    Features find(const GreyImage& photo) const {
        throwIfStopped(m_stop);
        Features features =
            found(sphereViews(photo, m_options.width, m_options.lowestElevation, m_options.usesZenith));
        if (m_options.isWide) {
            for (const Squeeze& squeeze : kSqueezes) {
                throwIfStopped(m_stop);
                append(found({SphereView::band(photo, m_options.width, m_options.lowestElevation, squeeze)}),
                       features);
            }
            features.firstOf =
                firstNear(features.bearings, kOneThingPx * 2 * std::numbers::pi / m_options.width);
        }
        return features;
    }

  private:
    static void append(const Features& more, Features& features) {
        const auto add = [](const auto& from, auto& to) { to.insert(to.end(), from.begin(), from.end()); };
        add(more.bearings, features.bearings);
        add(more.sigmasRad, features.sigmasRad);
        add(more.responses, features.responses);
        add(more.descriptors, features.descriptors);
        features.descriptorBytes = std::max(features.descriptorBytes, more.descriptorBytes);
    }

    /// The best features of these views.
    Features found(const std::vector<SphereView>& views) const {
        std::vector<Tile> tiles;
        for (const SphereView& view : views) {
            for (const auto& [top, bottom] :
                 pieces(SphereView::kMargin, view.picture().height() - SphereView::kMargin)) {
                for (const auto& [left, right] :
                     pieces(SphereView::kMargin, view.picture().width() - SphereView::kMargin)) {
                    throwIfStopped(m_stop);
                    tiles.push_back(searched(view, left, right, top, bottom));
                }
            }
        }
        return selected(tiles);
    }

    /// Searches the tile that owns [left, right) x [top, bottom) of the view.
    Tile searched(const SphereView& view, int left, int right, int top, int bottom) const {
        constexpr int kMargin = SphereView::kMargin;
        const DescribedKeypoints found =
            m_detector.find(cut(view.picture(), left - kMargin, top - kMargin, right - left + 2 * kMargin,
                                bottom - top + 2 * kMargin));
        Tile tile;
        for (const Keypoint& keypoint : found.keypoints) {
            const double x = keypoint.x + left - kMargin;
            const double y = keypoint.y + top - kMargin;
            if (keypoint.sizePx > kLargestPx || x < left - 0.5 || x >= right - 0.5 || y < top - 0.5 ||
                y >= bottom - 0.5 || !view.owns(x, y)) {
                continue;
            }
            const double pixelRad = view.pixelRad(x, y);
            const Eigen::Vector3d bearing = view.bearing(x, y);
            if (!isSearched(m_options, m_mask, bearing,
                            Radians(kMaskedAround * keypoint.sizePx * pixelRad))) {
                continue;
            }
            const std::uint8_t* descriptor = found.descriptor(keypoint.row, m_detector.descriptorBytes());
            tile.descriptors.insert(tile.descriptors.end(), descriptor,
                                    descriptor + m_detector.descriptorBytes());
            tile.spots.push_back({bearing, keypoint.response, kOwnPx * pixelRad});
            tile.sigmasRad.push_back(
                static_cast<float>(std::hypot(m_detector.sigmaPx(keypoint) * pixelRad, m_leastSigmaRad)));
        }
        return tile;
    }

    Features selected(const std::vector<Tile>& tiles) const {
        std::vector<Spot> spots;
        for (const Tile& tile : tiles) {
            spots.insert(spots.end(), tile.spots.begin(), tile.spots.end());
        }
        const std::vector<int> chosen = evenSelection(spots, m_options.most);
        Features features;
        features.detector = m_options.detector;
        if (chosen.empty()) {
            return features;
        }
        std::vector<int> placeOf(spots.size(), -1);
        for (std::size_t i = 0; i < chosen.size(); ++i) {
            placeOf[static_cast<std::size_t>(chosen[i])] = static_cast<int>(i);
        }
        features.descriptorBytes = m_detector.descriptorBytes();
        features.bearings.resize(chosen.size());
        features.sigmasRad.resize(chosen.size());
        features.responses.resize(chosen.size());
        features.descriptors.resize(chosen.size() * static_cast<std::size_t>(features.descriptorBytes));
        const int* places = placeOf.data();
        for (const Tile& tile : tiles) {
            take(tile, places, features);
            places += tile.spots.size();
        }
        return features;
    }

    /// places: the place of each of the tile's spots among the features; -1 if it has none.
    static void take(const Tile& tile, const int* places, Features& features) {
        const auto bytes = static_cast<std::size_t>(features.descriptorBytes);
        for (std::size_t i = 0; i < tile.spots.size(); ++i) {
            if (places[i] < 0) {
                continue;
            }
            const auto place = static_cast<std::size_t>(places[i]);
            features.bearings[place] = tile.spots[i].bearing.cast<float>();
            features.sigmasRad[place] = tile.sigmasRad[i];
            features.responses[place] = tile.spots[i].response;
            std::memcpy(features.descriptors.data() + place * bytes, tile.descriptors.data() + i * bytes,
                        bytes);
        }
    }

    const FeatureOptions& m_options;
    const MaskImage& m_mask;
    std::stop_token m_stop;
    double m_leastSigmaRad;
    KeypointDetector m_detector;
};

/// How far decoding can reduce the picture so that it is not coarser than the working width. No part of a
/// pixel may be left over, since that would shift all others.
int denominatorFor(const jpeg::Info& info, int width) {
    int denominator = 1;
    while (denominator < 8 && info.width / (2 * denominator) >= width &&
           info.width % (2 * denominator) == 0 && info.height % (2 * denominator) == 0) {
        denominator *= 2;
    }
    return denominator;
}

/// The features of a photo. cameraWidth: width of the photo before it was reduced.
Features found(const RgbImage& photo, int cameraWidth, const FeatureOptions& options, const MaskImage& mask,
               const std::stop_token& stop) {
    if (photo.width() < kLeastWidth || photo.height() < kLeastWidth / 2) {
        throw Error(ErrorKind::InvalidInput,
                    text("Could not look for features in a photo of ", photo.width(), " x ", photo.height(),
                         " pixels: it must have 64 x 32 or more."));
    }
    const GreyImage luma = grey(photo);
    Features features = FeatureFinder(options, mask, stop, cameraWidth).find(luma);
    features.vertical = findVertical(luma, options, mask);
    return features;
}

} // namespace

std::string_view name(Detector detector) {
    constexpr EnumNames<Detector, 3> kNames{
        {{Detector::Sift, "sift"}, {Detector::Akaze, "akaze"}, {Detector::Orb, "orb"}}};
    return nameOf(kNames, detector);
}

void FeatureOptions::validate() const {
    require(name(detector) != "unknown", "features'", "detector", "one of the known ones");
    require(width >= 256 && width <= 8192 && width % 32 == 0, "features'", "width",
            "a multiple of 32 from 256 to 8192");
    require(most >= 1 && most <= 50000, "features'", "most", "from 1 to 50000");
    require(leastContrast > 0 && leastContrast <= 1, "features'", "leastContrast", "above 0 and at most 1");
    require(lowestElevation >= Radians(Degrees(-90)) && lowestElevation <= Radians(Degrees(45)), "features'",
            "lowestElevation", "from -90 to 45 degrees");
}

bool isSearched(const FeatureOptions& options, const MaskImage& mask, const Eigen::Vector3d& bearing,
                Radians around) {
    return bearing.z() >= sin(options.lowestElevation) && !isLeftOut(mask, bearing, around.value());
}

Features detectFeatures(const RgbImage& photo, const FeatureOptions& options, const MaskImage& mask,
                        const std::stop_token& stop) {
    options.validate();
    return found(photo, photo.width(), options, mask, stop);
}

Features detectFeatures(ByteView jpeg, std::string_view source, const FeatureOptions& options,
                        const MaskImage& mask, const std::stop_token& stop) {
    options.validate();
    throwIfStopped(stop);
    const jpeg::Info info = jpeg::readInfo(jpeg, source);
    return found(jpeg::decode(jpeg, source, denominatorFor(info, options.width)), info.width, options, mask,
                 stop);
}

} // namespace spherewalk::align
