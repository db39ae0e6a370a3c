// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/scene/moved_photo.h"

#include "sweep_cost.h"

#include "spherewalk/base/parallel.h"
#include "spherewalk/geometry/equirect.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace spherewalk::scene {

namespace {

constexpr double kHiddenShare = 0.9; ///< A thing hides what is farther than its own distance by a tenth.
constexpr double kHiddenM = 0.05;
constexpr int kRowsAtOnce = 16;

/// 1 / distance in a direction of the depth's frame, interpolated where its neighbours are about as far.
double inverseAt(const render::DepthMap& depth, const Eigen::Vector3d& way) {
    constexpr float kJump = 1.15F; // beyond that, two things lie beside each other
    const Image<float, 1>& values = depth.inverseM();
    const Eigen::Vector2d at = pixel({values.width(), values.height()}, way);
    const double u = at.x() < 0 ? at.x() + values.width() : at.x();
    const double v = std::clamp(at.y(), 0.0, static_cast<double>(values.height() - 1));
    const int left = std::min(static_cast<int>(u), values.width() - 1);
    const int right = left + 1 < values.width() ? left + 1 : 0;
    const int above = static_cast<int>(v);
    const int below = std::min(above + 1, values.height() - 1);
    const float p[4] = {*values.at(left, above), *values.at(right, above), *values.at(left, below),
                        *values.at(right, below)};
    const auto [least, greatest] = std::minmax_element(std::begin(p), std::end(p));
    const double across = u - left;
    const double down = v - above;
    if (*greatest > kJump * *least) {
        return p[(across > 0.5 ? 1 : 0) + (down > 0.5 ? 2 : 0)];
    }
    return (1 - down) * ((1 - across) * p[0] + across * p[1]) + down * ((1 - across) * p[2] + across * p[3]);
}

/// Whether something that `there` sees stands before a place that lies this way and so far from it.
bool isHidden(const PhotoWithDepth& there, const Eigen::Vector3d& way, double distanceM) {
    if (there.depth == nullptr) {
        return false;
    }
    const double inverse = inverseAt(*there.depth, way);
    return inverse > 0 && 1 / inverse < kHiddenShare * distanceM - kHiddenM;
}

} // namespace

RgbImage photoSeenFrom(const PhotoWithDepth& here, const RgbImage& picture, const PhotoWithDepth& there,
                       int threads) {
    const EquirectSize size{picture.width(), picture.height()};
    const Rigid3 thereFromHere = there.roomFromPhoto.inverse() * here.roomFromPhoto;
    const Eigen::Matrix3d turn = thereFromHere.rotation.toRotationMatrix();
    RgbImage moved(picture.width(), picture.height());
    parallelFor(picture.height(), kRowsAtOnce, threads, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                const Eigen::Vector3d way = direction(size, {static_cast<double>(x), static_cast<double>(y)});
                const double inverse = here.depth != nullptr ? inverseAt(*here.depth, way) : 0;
                // The same point, as many times nearer as the distance has metres.
                const Eigen::Vector3d seen = turn * way + inverse * thereFromHere.translation;
                if (seen.squaredNorm() < 1e-12) {
                    continue; // the other camera stood in this very place
                }
                const Eigen::Vector2d at = pixel(size, seen);
                float colour[3];
                sampleColour(picture, static_cast<float>(at.x() < 0 ? at.x() + size.width : at.x()),
                             static_cast<float>(std::max(0.0, at.y())), colour);
                const bool isDim = inverse > 0 && isHidden(there, seen, seen.norm() / inverse);
                for (int c = 0; c < 3; ++c) {
                    moved.at(x, y)[c] =
                        static_cast<std::uint8_t>(std::lround(isDim ? 0.5F * colour[c] : colour[c]));
                }
            }
        }
    });
    return moved;
}

} // namespace spherewalk::scene
