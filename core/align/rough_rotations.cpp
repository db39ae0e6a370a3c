// SPDX-License-Identifier: GPL-3.0-or-later
#include "rough_rotations.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace spherewalk::align {

namespace {

constexpr double kUnused = std::numeric_limits<double>::infinity();
constexpr Radians kClosed = Degrees(1.5); ///< a triangle that closes so well confirms its pairs
constexpr double kLossScaleRad = 0.003;   ///< about what a good pair is off by
constexpr double kFirstLossScaleRad = 0.03;
constexpr int kRounds = 12;

struct Link {
    int a = 0;
    int b = 0;
    int estimate = 0;
    Eigen::Quaterniond aFromB;
    int closedTriangles = 0;
};

bool isUsable(const PairEstimate& estimate) {
    const double norm = estimate.aFromB.norm();
    return estimate.verdict == PairVerdict::Constraint && estimate.a != estimate.b &&
           std::abs(norm - 1) < 0.01;
}

std::vector<Link> usableLinks(int photos, std::span<const PairEstimate> estimates) {
    std::vector<Link> links;
    for (std::size_t i = 0; i < estimates.size(); ++i) {
        const PairEstimate& estimate = estimates[i];
        if (std::min(estimate.a, estimate.b) < 0 || std::max(estimate.a, estimate.b) >= photos) {
            throw Error(ErrorKind::InvalidInput, text("A pair names the photos ", estimate.a, " and ",
                                                      estimate.b, ", but there are ", photos, " photos."));
        }
        if (isUsable(estimate)) {
            links.push_back({estimate.a, estimate.b, static_cast<int>(i), estimate.aFromB.normalized(), 0});
        }
    }
    return links;
}

/// The links at one photo, sorted by the photo at the other end.
struct Neighbour {
    int photo = 0;
    int link = 0;

    auto operator<=>(const Neighbour&) const = default;
};

std::vector<std::vector<Neighbour>> neighbours(int photos, std::span<const Link> links) {
    std::vector<std::vector<Neighbour>> all(static_cast<std::size_t>(photos));
    for (int i = 0; const Link& link : links) {
        all[static_cast<std::size_t>(link.a)].push_back({link.b, i});
        all[static_cast<std::size_t>(link.b)].push_back({link.a, i});
        ++i;
    }
    for (std::vector<Neighbour>& some : all) {
        std::ranges::sort(some);
    }
    return all;
}

/// The link's rotation that takes the coordinates of the photo at its other end to those of this one.
Eigen::Quaterniond thisFromOther(const Link& link, int photo) {
    return link.a == photo ? link.aFromB : link.aFromB.conjugate();
}

int closedTriangles(const Link& link, std::span<const Link> links,
                    const std::vector<std::vector<Neighbour>>& around) {
    const std::vector<Neighbour>& ofA = around[static_cast<std::size_t>(link.a)];
    const std::vector<Neighbour>& ofB = around[static_cast<std::size_t>(link.b)];
    int closed = 0;
    for (std::size_t i = 0, j = 0; i < ofA.size() && j < ofB.size();) {
        if (ofA[i].photo != ofB[j].photo) {
            ++(ofA[i].photo < ofB[j].photo ? i : j);
            continue;
        }
        const Link& toA = links[static_cast<std::size_t>(ofA[i].link)];
        const Link& toB = links[static_cast<std::size_t>(ofB[j].link)];
        const Eigen::Quaterniond around3 =
            thisFromOther(toA, link.a) * thisFromOther(toB, link.b).conjugate();
        closed +=
            ofA[i].photo != link.a && ofA[i].photo != link.b && angleBetween(around3, link.aFromB) < kClosed
                ? 1
                : 0;
        ++i;
        ++j;
    }
    return closed;
}

int root(std::vector<int>& parent, int photo) {
    while (parent[static_cast<std::size_t>(photo)] != photo) {
        int& up = parent[static_cast<std::size_t>(photo)];
        up = parent[static_cast<std::size_t>(up)];
        photo = up;
    }
    return photo;
}

/// The links of the tree that the most triangles confirm.
std::vector<int> spanningTree(int photos, std::span<const Link> links) {
    std::vector<int> order(links.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, std::greater(),
                             [&](int i) { return links[static_cast<std::size_t>(i)].closedTriangles; });
    std::vector<int> parent(static_cast<std::size_t>(photos));
    std::iota(parent.begin(), parent.end(), 0);
    std::vector<int> tree;
    for (const int i : order) {
        const Link& link = links[static_cast<std::size_t>(i)];
        const int a = root(parent, link.a);
        const int b = root(parent, link.b);
        if (a != b) {
            parent[static_cast<std::size_t>(b)] = a;
            tree.push_back(i);
        }
    }
    return tree;
}

/// Chains the tree's rotations from the first photo of each part.
void startAtTree(std::span<const Link> links, const std::vector<std::vector<Neighbour>>& treeAround,
                 RoughRotations& result) {
    for (std::size_t first = 0; first < result.part.size(); ++first) {
        if (result.part[first] >= 0 || treeAround[first].empty()) {
            continue;
        }
        std::vector<int> queue = {static_cast<int>(first)};
        result.part[first] = result.parts;
        for (std::size_t next = 0; next < queue.size(); ++next) {
            const auto photo = static_cast<std::size_t>(queue[next]);
            for (const Neighbour& neighbour : treeAround[photo]) {
                const auto other = static_cast<std::size_t>(neighbour.photo);
                if (result.part[other] >= 0) {
                    continue;
                }
                result.part[other] = result.parts;
                result.partFromPhoto[other] =
                    result.partFromPhoto[photo] *
                    thisFromOther(links[static_cast<std::size_t>(neighbour.link)], queue[next]);
                queue.push_back(neighbour.photo);
            }
        }
        ++result.parts;
    }
}

/// The turn, in the part's frame, by which b's rotation differs from what the link says.
Eigen::Vector3d misfit(const Link& link, const RoughRotations& result) {
    const Eigen::Quaterniond& partFromA = result.partFromPhoto[static_cast<std::size_t>(link.a)];
    const Eigen::Quaterniond& partFromB = result.partFromPhoto[static_cast<std::size_t>(link.b)];
    const Eigen::AngleAxisd turn(partFromA * link.aFromB * partFromB.conjugate());
    const double angle = turn.angle() > EIGEN_PI ? turn.angle() - 2 * EIGEN_PI : turn.angle();
    return angle * turn.axis();
}

/// One step of iteratively reweighted averaging: all small turns at once, by the weighted graph's Laplacian.
void improve(std::span<const Link> links, double lossScaleRad, RoughRotations& result) {
    const auto photos = static_cast<Eigen::Index>(result.part.size());
    // A weak pull to where each photo is fixes each part's frame and keeps the matrix regular.
    Eigen::VectorXd diagonal = Eigen::VectorXd::Constant(photos, 1e-6);
    Eigen::MatrixX3d right = Eigen::MatrixX3d::Zero(photos, 3);
    std::vector<Eigen::Triplet<double>> entries;
    for (const Link& link : links) {
        const Eigen::Vector3d turn = misfit(link, result);
        const double ratio = turn.squaredNorm() / (lossScaleRad * lossScaleRad);
        const double weight = 1 / ((1 + ratio) * (1 + ratio)); // Geman and McClure's
        diagonal[link.a] += weight;
        diagonal[link.b] += weight;
        entries.emplace_back(link.a, link.b, -weight);
        entries.emplace_back(link.b, link.a, -weight);
        right.row(link.b) += weight * turn.transpose();
        right.row(link.a) -= weight * turn.transpose();
    }
    for (int i = 0; i < photos; ++i) {
        entries.emplace_back(i, i, diagonal[i]);
    }
    Eigen::SparseMatrix<double> laplacian(photos, photos);
    laplacian.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(laplacian);
    const Eigen::MatrixX3d turns = solver.solve(right);
    if (solver.info() != Eigen::Success || !turns.allFinite()) {
        return; // what was reached so far is good enough to look at baselines
    }
    for (Eigen::Index i = 0; i < photos; ++i) {
        const Eigen::Vector3d turn = turns.row(i);
        Eigen::Quaterniond& partFromPhoto = result.partFromPhoto[static_cast<std::size_t>(i)];
        partFromPhoto =
            (Eigen::AngleAxisd(turn.norm(), turn.stableNormalized()) * partFromPhoto).normalized();
    }
}

} // namespace

RoughRotations roughRotations(int photos, std::span<const PairEstimate> estimates) {
    std::vector<Link> links = usableLinks(photos, estimates);
    const std::vector<std::vector<Neighbour>> around = neighbours(photos, links);
    for (Link& link : links) {
        link.closedTriangles = closedTriangles(link, links, around);
    }
    std::erase_if(links, [](const Link& link) { return link.closedTriangles == 0; });

    RoughRotations result;
    result.partFromPhoto.assign(static_cast<std::size_t>(photos), Eigen::Quaterniond::Identity());
    result.part.assign(static_cast<std::size_t>(photos), -1);
    result.residualRad.assign(estimates.size(), kUnused);
    std::vector<Link> tree;
    for (const int i : spanningTree(photos, links)) {
        tree.push_back(links[static_cast<std::size_t>(i)]);
    }
    startAtTree(tree, neighbours(photos, tree), result);
    double lossScaleRad = kFirstLossScaleRad; // the tree's chains drift: no good pair may count as wrong yet
    for (int round = 0; round < kRounds && !links.empty(); ++round) {
        improve(links, lossScaleRad, result);
        lossScaleRad = std::max(kLossScaleRad, lossScaleRad * 0.7);
    }
    for (const Link& link : links) {
        result.residualRad[static_cast<std::size_t>(link.estimate)] = misfit(link, result).norm();
    }
    return result;
}

} // namespace spherewalk::align
