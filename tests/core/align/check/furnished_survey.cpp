// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/furnished_survey.h"

#include "spherewalk/geometry/rotation.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::align {

using test::Random;

namespace {

constexpr double kChairHalfM = 0.25;
constexpr double kBearingSigmaRad = 0.0008;
constexpr double kDetected = 0.7; ///< chance that a photo's detector finds a visible thing
constexpr double kMatched = 0.7;  ///< chance that a match is found between two photos that have it
constexpr double kWrong = 0.2;    ///< wrong matches for each right one

Eigen::Vector3d pointOn(const Box& box, Random& random) {
    Eigen::Vector3d pM;
    for (int axis = 0; axis < 3; ++axis) {
        pM[axis] = random.uniform(box.min()[axis], box.max()[axis]);
    }
    const int axis = random.integer(0, 2);
    pM[axis] = random.uniform(0, 1) < 0.5 ? box.min()[axis] : box.max()[axis];
    return pM;
}

double areaM2(const Box& box) {
    const Eigen::Vector3d size = box.sizes();
    return 2 * (size.x() * size.y() + size.y() * size.z() + size.z() * size.x());
}

/// Whether the box hides the point from the camera; its own surface does not hide itself.
bool hides(const Box& box, const Eigen::Vector3d& cameraM, const Eigen::Vector3d& pM) {
    const Eigen::Vector3d way = pM - cameraM;
    double from = 0;
    double to = 0.9999;
    for (int axis = 0; axis < 3; ++axis) {
        const double one = (box.min()[axis] + 1e-4 - cameraM[axis]) / way[axis];
        const double other = (box.max()[axis] - 1e-4 - cameraM[axis]) / way[axis];
        from = std::max(from, std::min(one, other));
        to = std::min(to, std::max(one, other));
    }
    return from < to;
}

Box around(const Eigen::Vector3d& middleM, double halfM) {
    const Eigen::Vector3d half = Eigen::Vector3d::Constant(halfM);
    return {middleM - half, middleM + half};
}

} // namespace

FurnishedSurvey::FurnishedSurvey(const FurnishedOptions& options, Random& random)
    : m_neighboursM(options.neighboursM),
      m_boxes({Box(Eigen::Vector3d(0.2, 0.9, 0), Eigen::Vector3d(0.6, 1.6, 1.5)),
               Box(Eigen::Vector3d(1.2, 3.0, 0), Eigen::Vector3d(2.2, 3.5, 0.9))}) {
    const Box walls(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(4.2, 4.2, 2.6));
    for (int i = 0; i < options.pointsOnWalls; ++i) {
        m_pointsM.push_back(pointOn(walls, random));
    }
    for (const Box& box : m_boxes) {
        for (int i = 0; i < options.pointsPerM2 * areaM2(box); ++i) {
            m_pointsM.push_back(pointOn(box, random));
        }
    }
    const Box chair = around(Eigen::Vector3d::Zero(), kChairHalfM);
    for (int i = 0; i < options.pointsPerM2 * areaM2(chair); ++i) {
        m_chairPointsM.push_back(pointOn(chair, random));
    }
    for (int row = 0; row < options.rows; ++row) {
        for (int column = 0; column < options.columns; ++column) {
            const YawPitchRoll turn{Radians(random.uniform(-3.1, 3.1)), Radians(random.normal(0.01)),
                                    Radians(random.normal(0.01))};
            const Rigid3 truth{rotation(turn),
                               Eigen::Vector3d(1, 1, 1.2) + options.stepM * Eigen::Vector3d(column, row, 0)};
            m_truth.push_back(truth);
            roomFromPhoto.emplace_back(
                Rigid3{truth.rotation, truth.translation + random.vector(options.positionSigmaM)});
            chairAtM.emplace_back(chairM());
        }
    }
}

std::vector<FurnishedSurvey::Seen> FurnishedSurvey::seenBy(int photo, Random& random) const {
    const Rigid3& roomFromCamera = m_truth[static_cast<std::size_t>(photo)];
    const std::optional<Eigen::Vector3d>& chairM = chairAtM[static_cast<std::size_t>(photo)];
    std::vector<Box> boxes = m_boxes;
    std::vector<Eigen::Vector3d> pointsM = m_pointsM;
    if (chairM) {
        boxes.push_back(around(*chairM, kChairHalfM));
        for (const Eigen::Vector3d& pM : m_chairPointsM) {
            pointsM.emplace_back(*chairM + pM);
        }
    }
    std::vector<Seen> seen;
    for (int thing = 0; const Eigen::Vector3d& pM : pointsM) {
        const bool isHidden = std::ranges::any_of(
            boxes, [&](const Box& box) { return hides(box, roomFromCamera.translation, pM); });
        if (!isHidden && random.uniform(0, 1) < kDetected) {
            const Eigen::Vector3d exact = (roomFromCamera.inverse() * pM).normalized();
            seen.push_back({thing, (exact + random.vector(kBearingSigmaRad)).normalized()});
        }
        ++thing;
    }
    return seen;
}

void FurnishedSurvey::expose(Random& random) {
    std::vector<std::vector<Seen>> seen;
    for (int photo = 0; photo < static_cast<int>(m_truth.size()); ++photo) {
        seen.push_back(seenBy(photo, random));
    }
    pairs.clear();
    isInlier.clear();
    for (int b = 0; b < static_cast<int>(m_truth.size()); ++b) {
        for (int a = 0; a < b; ++a) {
            const double distanceM = (m_truth[static_cast<std::size_t>(a)].translation -
                                      m_truth[static_cast<std::size_t>(b)].translation)
                                         .norm();
            if (distanceM < m_neighboursM) {
                match(a, b, seen, random);
            }
        }
    }
}

void FurnishedSurvey::match(int a, int b, const std::vector<std::vector<Seen>>& seen, Random& random) {
    const std::vector<Seen>& ofA = seen[static_cast<std::size_t>(a)];
    const std::vector<Seen>& ofB = seen[static_cast<std::size_t>(b)];
    PhotoPair pair{a, b, {}};
    const auto add = [&](std::size_t inA, std::size_t inB) {
        pair.matches.push_back({ofA[inA].bearing, ofB[inB].bearing, kBearingSigmaRad, static_cast<int>(inA),
                                static_cast<int>(inB)});
    };
    for (std::size_t i = 0, j = 0; i < ofA.size() && j < ofB.size();) { // both in the order of things
        if (ofA[i].thing != ofB[j].thing) {
            ++(ofA[i].thing < ofB[j].thing ? i : j);
            continue;
        }
        if (random.uniform(0, 1) < kMatched) {
            add(i, j);
        } else if (random.uniform(0, 1) < kWrong) {
            add(i, static_cast<std::size_t>(random.integer(0, static_cast<int>(ofB.size()) - 1)));
        }
        ++i;
        ++j;
    }
    std::vector<bool> inliers;
    for (const Correspondence& match : pair.matches) {
        inliers.push_back(fits(a, b, match));
    }
    pairs.push_back(std::move(pair));
    isInlier.push_back(std::move(inliers));
}

bool FurnishedSurvey::fits(int a, int b, const Correspondence& match) const {
    const Rigid3 aFromB =
        roomFromPhoto[static_cast<std::size_t>(a)]->inverse() * *roomFromPhoto[static_cast<std::size_t>(b)];
    const Eigen::Vector3d inA = aFromB.rotation * match.inB;
    const Eigen::Vector3d normal = aFromB.translation.cross(match.inA).normalized();
    return std::abs(normal.dot(inA)) < 0.005 && match.inA.cross(inA).dot(normal) > -0.002;
}

} // namespace spherewalk::align
