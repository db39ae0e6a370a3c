// SPDX-License-Identifier: GPL-3.0-or-later
#include "free/placing.h"
#include "pairs/pair_geometry.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace spherewalk::align {

namespace {

using Rows36 = Eigen::Matrix<double, 3, 6>;

/// The derivatives of one ray, in standard deviations.
struct RayRows {
    Rows36 byPhoto; ///< Turn, then position.
    Eigen::Matrix3d byPoint;
    Eigen::Vector3d byLenses; ///< How far they stand ahead.
};

RayRows rowsOf(const Bundle& bundle, const Ray& ray, const Eigen::Vector3d& point) {
    const PhotoState& photo = bundle.photos[static_cast<std::size_t>(ray.photo)];
    const Eigen::Vector3d apart = point - bundle.lensOf(ray);
    const double distance = std::max(apart.norm(), 1e-9);
    const Eigen::Vector3d unit = apart / distance;
    RayRows rows;
    rows.byPoint =
        (Eigen::Matrix3d::Identity() - unit * unit.transpose()) / (distance * bundle.scale * ray.sigmaRad);
    rows.byPhoto.leftCols<3>() = rows.byPoint * skew(point - photo.positionM);
    rows.byPhoto.rightCols<3>() = -rows.byPoint;
    rows.byLenses = -softSide(ray.bearing) * rows.byPoint * (photo.roomFromPhoto * Eigen::Vector3d::UnitX());
    return rows;
}

/// The normal matrix of all poses and, last, of the lenses, with all points solved for.
Eigen::MatrixXd poseNormal(const Bundle& bundle) {
    const auto last = static_cast<Eigen::Index>(6 * bundle.photos.size());
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(last + 1, last + 1);
    for (const SeenPoint& point : bundle.points) {
        const auto rays = static_cast<Eigen::Index>(point.rays.size());
        Eigen::MatrixXd by(3 * rays, 7);
        Eigen::MatrixX3d byPoint(3 * rays, 3);
        for (Eigen::Index i = 0; i < rays; ++i) {
            const RayRows rows = rowsOf(bundle, point.rays[static_cast<std::size_t>(i)], point.at);
            by.block<3, 6>(3 * i, 0) = rows.byPhoto;
            by.block<3, 1>(3 * i, 6) = rows.byLenses;
            byPoint.middleRows<3>(3 * i) = rows.byPoint;
        }
        // What the point cannot take upon itself is left to the poses.
        const Eigen::MatrixX3d taken = byPoint * (byPoint.transpose() * byPoint).inverse();
        const Eigen::MatrixXd left =
            Eigen::MatrixXd::Identity(3 * rays, 3 * rays) - taken * byPoint.transpose();
        for (Eigen::Index i = 0; i < rays; ++i) {
            const Eigen::Index atI = 6 * point.rays[static_cast<std::size_t>(i)].photo;
            for (Eigen::Index j = 0; j < rays; ++j) {
                const Eigen::Index atJ = 6 * point.rays[static_cast<std::size_t>(j)].photo;
                const Eigen::Matrix<double, 7, 7> both = by.middleRows<3>(3 * i).transpose() *
                                                         left.block<3, 3>(3 * i, 3 * j) *
                                                         by.middleRows<3>(3 * j);
                normal.block<6, 6>(atI, atJ) += both.topLeftCorner<6, 6>();
                normal.block<6, 1>(atI, last) += both.topRightCorner<6, 1>();
                normal.block<1, 6>(last, atJ) += both.bottomLeftCorner<1, 6>();
                normal(last, last) += both(6, 6);
            }
        }
    }
    return normal;
}

/// Seven orthonormal motions that no picture tells: of all photos together.
Eigen::MatrixXd commonMotions(const Bundle& bundle) {
    const auto last = static_cast<Eigen::Index>(6 * bundle.photos.size());
    Eigen::MatrixXd motions = Eigen::MatrixXd::Zero(last + 1, 7);
    for (std::size_t i = 0; i < bundle.photos.size(); ++i) {
        const auto at = static_cast<Eigen::Index>(6 * i);
        motions.block<3, 3>(at + 3, 0) = Eigen::Matrix3d::Identity();
        motions.block<3, 3>(at, 3) = Eigen::Matrix3d::Identity();
        motions.block<3, 3>(at + 3, 3) = -skew(bundle.photos[i].positionM);
        motions.block<3, 1>(at + 3, 6) = bundle.photos[i].positionM;
        motions(last, 6) = bundle.photos[i].lenses.aheadM;
    }
    return motions.householderQr().householderQ() * Eigen::MatrixXd::Identity(last + 1, 7);
}

/// Of all poses and, last, of how far the lenses stand ahead, when all are moved, turned and scaled together.
Eigen::MatrixXd covarianceOf(const Bundle& bundle, bool solvesLenses) {
    Eigen::MatrixXd normal = poseNormal(bundle);
    const Eigen::MatrixXd motions = commonMotions(bundle);
    const Eigen::Index last = normal.rows() - 1;
    const double weight = normal.topLeftCorner(last, last).diagonal().mean();
    if (!solvesLenses) {
        normal.row(last).setZero();
        normal.col(last).setZero();
        normal(last, last) = weight;
    }
    normal += weight * motions * motions.transpose();
    normal.diagonal().array() += 1e-12 * weight;
    return normal.llt().solve(Eigen::MatrixXd::Identity(last + 1, last + 1)) -
           motions * motions.transpose() / weight;
}

double largestSigma(const Eigen::Matrix3d& covariance) {
    const double largest =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance, Eigen::EigenvaluesOnly).eigenvalues()[2];
    return std::sqrt(std::max(0., largest));
}

} // namespace

double lensSigma(const Bundle& bundle) {
    const Eigen::MatrixXd covariance = covarianceOf(bundle, true);
    return std::sqrt(std::max(0.0, covariance(covariance.rows() - 1, covariance.cols() - 1)));
}

std::vector<BundleSigma> bundleSigmas(const Bundle& bundle) {
    const Eigen::MatrixXd covariance =
        covarianceOf(bundle, !bundle.photos.empty() && bundle.photos.front().lenses.aheadM != 0);
    std::vector<BundleSigma> sigmas;
    for (std::size_t i = 0; i < bundle.photos.size(); ++i) {
        const auto at = static_cast<Eigen::Index>(6 * i);
        sigmas.push_back({largestSigma(covariance.block<3, 3>(at, at)),
                          largestSigma(covariance.block<3, 3>(at + 3, at + 3))});
    }
    return sigmas;
}

} // namespace spherewalk::align
