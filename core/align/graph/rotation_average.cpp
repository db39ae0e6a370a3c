// SPDX-License-Identifier: GPL-3.0-or-later
#include "rotation_average.h"

#include "fixed_random.h"
#include "so3.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numeric>

namespace spherewalk::align {

namespace {

constexpr int kTrees = 3;
constexpr double kToleranceRad = 0.035; // pairs of a room agree within fractions of a degree
constexpr double kLeastAngleRad = 1e-3; // below it the sum of angles is rounded off

using Rotations = std::vector<Eigen::Quaterniond>;

std::size_t at(std::span<const int> indexOf, int photo) {
    return static_cast<std::size_t>(indexOf[static_cast<std::size_t>(photo)]);
}

// The tree of the edges that most can be said for; chance moves equals (and more, in other trees).
Rotations treeRotations(const Component& component, std::span<const int> indexOf, int tree) {
    FixedRandom random(0x7EE00000ULL + static_cast<std::uint64_t>(tree));
    std::vector<std::pair<double, const GraphEdge*>> sorted;
    for (const GraphEdge& edge : component.edges) {
        const double trust = (edge.closed + 0.5) / (edge.triangles + 1);
        const double chance = tree == 0 ? 1 : 0.2 + random.uniform();
        sorted.emplace_back(edge.weight * trust * trust * chance, &edge);
    }
    std::ranges::stable_sort(sorted, std::greater<>(), [](const auto& entry) { return entry.first; });
    const std::size_t count = component.photos.size();
    std::vector<std::vector<const GraphEdge*>> neighbours(count);
    std::vector<std::size_t> root(count);
    std::iota(root.begin(), root.end(), std::size_t(0));
    const auto rootOf = [&](std::size_t node) {
        while (root[node] != node) {
            node = root[node] = root[root[node]];
        }
        return node;
    };
    for (const auto& [trust, edge] : sorted) {
        const std::size_t a = at(indexOf, edge->a);
        const std::size_t b = at(indexOf, edge->b);
        if (rootOf(a) != rootOf(b)) {
            root[rootOf(a)] = rootOf(b);
            neighbours[a].push_back(edge);
            neighbours[b].push_back(edge);
        }
    }
    Rotations rotations(count, Eigen::Quaterniond::Identity());
    std::vector<bool> isSet(count, false);
    std::vector<std::size_t> open = {0};
    isSet[0] = true;
    while (!open.empty()) {
        const std::size_t node = open.back();
        open.pop_back();
        for (const GraphEdge* edge : neighbours[node]) {
            const std::size_t a = at(indexOf, edge->a);
            const std::size_t b = at(indexOf, edge->b);
            const std::size_t other = a == node ? b : a;
            if (!isSet[other]) {
                rotations[other] =
                    a == node ? rotations[a] * edge->aFromB : rotations[b] * edge->aFromB.conjugate();
                isSet[other] = true;
                open.push_back(other);
            }
        }
    }
    return rotations;
}

enum class Norm { Angles, Bounded };

double weightOf(double angle, Norm norm) {
    if (norm == Norm::Angles) {
        return 1 / std::max(angle, kLeastAngleRad);
    }
    const double root = 1 / (1 + angle * angle / (kToleranceRad * kToleranceRad));
    return std::max(root * root, 1e-6); // never nothing: the graph must stay connected
}

// One step of least squares with the norm's weights; the first photo stays.
void averageOnce(const Component& component, std::span<const int> indexOf, Norm norm, Rotations& rotations) {
    const auto count = static_cast<Eigen::Index>(rotations.size());
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(count, 3);
    entries.emplace_back(0, 0, 1.0);
    for (const GraphEdge& edge : component.edges) {
        const auto a = static_cast<Eigen::Index>(at(indexOf, edge.a));
        const auto b = static_cast<Eigen::Index>(at(indexOf, edge.b));
        const Eigen::Vector3d left = disagreement(edge, rotations, indexOf);
        const double weight = edge.weight * weightOf(left.norm(), norm);
        entries.emplace_back(a, a, weight);
        entries.emplace_back(b, b, weight);
        entries.emplace_back(a, b, -weight);
        entries.emplace_back(b, a, -weight);
        right.row(a) -= weight * left.transpose();
        right.row(b) += weight * left.transpose();
    }
    Eigen::SparseMatrix<double> matrix(count, count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(matrix);
    const Eigen::MatrixXd turns = factor.solve(right);
    if (factor.info() != Eigen::Success || !turns.allFinite()) {
        return;
    }
    for (Eigen::Index i = 0; i < count; ++i) {
        Eigen::Quaterniond& rotation = rotations[static_cast<std::size_t>(i)];
        rotation = (turn(turns.row(i).transpose()) * rotation).normalized();
    }
}

double costOf(const Component& component, std::span<const int> indexOf, const Rotations& rotations) {
    double cost = 0;
    for (const GraphEdge& edge : component.edges) {
        const double ratio = disagreement(edge, rotations, indexOf).norm() / kToleranceRad;
        cost += edge.weight * ratio * ratio / (1 + ratio * ratio);
    }
    return cost;
}

} // namespace

Eigen::Vector3d disagreement(const GraphEdge& edge, std::span<const Eigen::Quaterniond> rootFromPhoto,
                             std::span<const int> indexOf) {
    return turnVector(rootFromPhoto[at(indexOf, edge.a)] * edge.aFromB *
                      rootFromPhoto[at(indexOf, edge.b)].conjugate());
}

std::vector<Eigen::Quaterniond> averagedRotations(const Component& component, std::span<const int> indexOf) {
    Rotations best;
    double bestCost = 0;
    for (int tree = 0; tree < kTrees; ++tree) {
        Rotations rotations = treeRotations(component, indexOf, tree);
        for (int round = 0; round < 8; ++round) {
            averageOnce(component, indexOf, Norm::Angles, rotations);
        }
        for (int round = 0; round < 6; ++round) {
            averageOnce(component, indexOf, Norm::Bounded, rotations);
        }
        const double cost = costOf(component, indexOf, rotations);
        if (best.empty() || cost < bestCost) {
            best = std::move(rotations);
            bestCost = cost;
        }
    }
    return best;
}

} // namespace spherewalk::align
