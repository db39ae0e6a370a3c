// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/base/parallel.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/render/lattice_error.h"

#include <mutex>
#include <numbers>
#include <random>
#include <vector>

namespace spherewalk::render {

using Eigen::Vector3d;

namespace {

using Cases = std::vector<LatticeCase>;

class Random {
  public:
    explicit Random(unsigned seed) : m_engine(seed) {}

    double uniform(double least, double greatest) {
        return std::uniform_real_distribution<double>(least, greatest)(m_engine);
    }

    Eigen::Quaterniond rotation() {
        const double w = normal();
        const Vector3d axis = vector();
        return Eigen::Quaterniond(w, axis.x(), axis.y(), axis.z()).normalized();
    }

    Vector3d direction() { return vector().normalized(); }

  private:
    double normal() { return std::normal_distribution<double>(0, 1)(m_engine); }

    Vector3d vector() {
        const double x = normal();
        const double y = normal();
        return {x, y, normal()};
    }

    std::mt19937 m_engine;
};

CameraModel pinhole(int width, int height, double fieldDeg) {
    return CameraModel(CameraIntrinsics::pinhole(width, height, Radians(Degrees(fieldDeg)).value()));
}

Cases inAnyDirection() {
    Random random(51);
    Cases cases;
    for (int i = 0; i < 150; ++i) {
        const double field = i % 3 == 0   ? random.uniform(1, 40)
                             : i % 3 == 1 ? random.uniform(40, 120)
                                          : random.uniform(120, 179);
        const Rigid3 camera{random.rotation(), Vector3d::Zero()};
        const Rigid3 photo{random.rotation(), Vector3d::Zero()};
        cases.push_back({pinhole(320, 240, field), camera, photo, SceneKind::None, 1, 1 + i % 2});
    }
    return cases;
}

Cases overPolesAndSeam() {
    Cases cases;
    for (const double field : {1.0, 20.0, 57.0, 90.0, 120.0, 160.0, 179.0}) {
        for (const double pitch : {-90.0, -89.999, -85.0, -60.0, 0.0, 45.0, 75.0, 89.9, 90.0}) {
            for (const double yaw : {0.0, 180.0, 179.99}) {
                for (const double roll : {0.0, 30.0}) {
                    const YawPitchRoll angles{Degrees(yaw), Degrees(pitch), Degrees(roll)};
                    const Rigid3 camera{rotation(angles) * bodyFromOptical(), Vector3d::Zero()};
                    cases.push_back({pinhole(160, 120, field), camera, {}});
                }
            }
        }
    }
    return cases;
}

Cases displaced() {
    Random random(52);
    Cases cases;
    for (int i = 0; i < 150; ++i) {
        const double share = i % 3 == 0   ? kLargestDisplacement
                             : i % 3 == 1 ? random.uniform(0, 0.2)
                                          : random.uniform(0, 1.2);
        const Vector3d room = i % 2 == 0 ? Vector3d::Zero() : Vector3d(1e6, -1e6, 1e6);
        const double radius = random.uniform(0.5, 8);
        const Rigid3 photo{random.rotation(), room};
        const Rigid3 camera{random.rotation(), room + share * radius * random.direction()};
        cases.push_back(
            {pinhole(240, 180, random.uniform(1, 179)), camera, photo, SceneKind::Sphere, radius, 1 + i % 2});
    }
    return cases;
}

CameraIntrinsics withLens(CameraIntrinsics k, int which, Random& random) {
    if (which == 0) {
        k.lens = LensModel::PlumbBob;
        k.distortion = {random.uniform(-0.35, 0.2), random.uniform(-0.1, 0.15), random.uniform(-2e-3, 2e-3),
                        random.uniform(-2e-3, 2e-3), random.uniform(-0.02, 0.02)};
    } else if (which == 1) {
        k.lens = LensModel::RationalPolynomial;
        k.distortion = {random.uniform(0, 1),
                        random.uniform(-0.1, 0.3),
                        1e-3,
                        -1e-3,
                        0.01,
                        random.uniform(0, 1),
                        0.1,
                        0.02};
    } else {
        k.lens = LensModel::Equidistant;
        k.fx = k.fy = random.uniform(60, 200);
        k.distortion = {random.uniform(-0.05, 0.05), random.uniform(-0.02, 0.02), 0.002, -0.001};
    }
    return k;
}

Cases throughEveryLens() {
    Random random(53);
    Cases cases;
    for (int i = 0; i < 60; ++i) {
        CameraIntrinsics k = CameraIntrinsics::pinhole(320, 240, random.uniform(0.5, 1.9));
        k.cx += random.uniform(-20, 20);
        k.fy *= random.uniform(0.8, 1.2);
        k = withLens(k, i % 3, random);
        const Rigid3 photo{random.rotation(), Vector3d::Zero()};
        const Vector3d aside = random.direction();
        const Rigid3 camera{random.rotation(), aside * random.uniform(0, 1.9)};
        cases.push_back(
            {CameraModel(k), camera, photo, i % 2 == 0 ? SceneKind::None : SceneKind::Sphere, 2, 1 + i % 2});
    }
    return cases;
}

Cases casesOf(LatticeSearch search) {
    switch (search) {
    case LatticeSearch::AnyDirection:
        return inAnyDirection();
    case LatticeSearch::PolesAndSeam:
        return overPolesAndSeam();
    case LatticeSearch::Displaced:
        return displaced();
    case LatticeSearch::EveryLens:
        break;
    }
    return throughEveryLens();
}

} // namespace

std::string_view name(LatticeSearch search) {
    constexpr std::array<std::string_view, kLatticeSearches.size()> kNames{"any direction", "poles and seam",
                                                                           "displaced", "every lens"};
    return kNames[static_cast<std::size_t>(search)];
}

LatticeError searchLattice(LatticeSearch search, int everyNth, ProgressSink& progress,
                           const std::stop_token& stop) {
    const Cases cases = casesOf(search);
    const int count = (static_cast<int>(cases.size()) + everyNth - 1) / everyNth;
    std::vector<LatticeError> errors(static_cast<std::size_t>(count));
    std::mutex mutex;
    int done = 0;
    parallelFor(count, 1, 0, [&](int i, int /*end*/) {
        throwIfStopped(stop);
        errors[static_cast<std::size_t>(i)] = latticeError(cases[static_cast<std::size_t>(i * everyNth)]);
        const std::scoped_lock lock(mutex);
        progress.progress(static_cast<double>(++done) / count,
                          text("Looking for the worst coordinates, ", name(search)));
    });
    LatticeError worst;
    for (const LatticeError& error : errors) { // in their order: the same report on every run
        worst.add(error);
    }
    return worst;
}

} // namespace spherewalk::render
