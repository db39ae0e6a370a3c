// SPDX-License-Identifier: Apache-2.0
#include "pictures.h"

#include "spherewalk/base/parallel.h"
#include "spherewalk/geometry/equirect.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace spherewalk::bench {

namespace {

/// In [-1, 1], different for each lattice point.
double hashed(int x, int y, int z) {
    auto h = static_cast<std::uint32_t>(x) * 0x9E3779B1U ^ static_cast<std::uint32_t>(y) * 0x85EBCA77U ^
             static_cast<std::uint32_t>(z) * 0xC2B2AE3DU;
    h = (h ^ h >> 15) * 0x2C1B3C6DU;
    h = (h ^ h >> 12) * 0x297A2D39U;
    return static_cast<double>(h ^ h >> 15) / 2147483648.0 - 1;
}

double noise(const Eigen::Vector3d& p) {
    const Eigen::Vector3d base = p.array().floor();
    const Eigen::Vector3d f = p - base;
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        double weight = 1;
        Eigen::Vector3i at = base.cast<int>();
        for (int axis = 0; axis < 3; ++axis) {
            const int bit = corner >> axis & 1;
            const double t = f[axis] * f[axis] * (3 - 2 * f[axis]);
            weight *= bit != 0 ? t : 1 - t;
            at[axis] += bit;
        }
        sum += weight * hashed(at.x(), at.y(), at.z());
    }
    return sum;
}

} // namespace

RgbImage detailedPanorama() {
    const EquirectSize size{5376, 2688};
    RgbImage picture(size.width, size.height);
    parallelFor(size.height, 8, 0, [&](int begin, int end) {
        for (int v = begin; v < end; ++v) {
            for (int u = 0; u < size.width; ++u) {
                const Eigen::Vector3d d = direction(size, Eigen::Vector2d(u, v));
                double value = 128;
                double amplitude = 60;
                double scale = 3;
                for (int octave = 0; octave < 8; ++octave, amplitude *= 0.6, scale *= 2) {
                    value += amplitude * noise(d * scale);
                }
                // Tiles on the floor and the walls of a cube, with joints about three pixels wide.
                const Eigen::Vector3d cube = d / d.cwiseAbs().maxCoeff() * 12;
                const Eigen::Vector3d joint = (cube.array() - cube.array().round()).abs();
                const bool onJoint = (joint.array() < 0.03 && cube.array().abs() < 11.9).any();
                value += onJoint ? -50 : 0;
                for (int c = 0; c < 3; ++c) {
                    const double shade = value + 12 * noise(d * 6 + Eigen::Vector3d::Constant(10 * (c + 1)));
                    picture.at(u, v)[c] = static_cast<std::uint8_t>(std::clamp(shade, 0.0, 255.0));
                }
            }
        }
    });
    return picture;
}

} // namespace spherewalk::bench
