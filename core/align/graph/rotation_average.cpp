// SPDX-License-Identifier: GPL-3.0-or-later
#include "graph/pose_graph.h"
#include "pairs/disjoint_sets.h"
#include "pairs/pair_geometry.h"

#include "spherewalk/base/fixed_random.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>

namespace spherewalk::align {

namespace {

constexpr int kTrees = 3;
constexpr double kAverageToleranceRad = 0.035; // Right pairs agree within fractions of a degree.
constexpr double kLeastAngleRad = 1e-3;        // The sum of angles is rounded off below this angle.

using Rotations = std::vector<Eigen::Quaterniond>;

std::size_t placeOf(std::span<const int> indexOf, int photo) {
    return static_cast<std::size_t>(indexOf[static_cast<std::size_t>(photo)]);
}

// The rotations along a spanning tree of the best supported edges. Later trees differ by chance.
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
    DisjointSets joined(count);
    for (const auto& [trust, edge] : sorted) {
        const std::size_t a = placeOf(indexOf, edge->a);
        const std::size_t b = placeOf(indexOf, edge->b);
        if (joined.of(static_cast<int>(a)) != joined.of(static_cast<int>(b))) {
            joined.join(static_cast<int>(a), static_cast<int>(b));
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
            const std::size_t a = placeOf(indexOf, edge->a);
            const std::size_t b = placeOf(indexOf, edge->b);
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
    const double root = 1 / (1 + angle * angle / (kAverageToleranceRad * kAverageToleranceRad));
    return std::max(root * root, 1e-6); // The graph must stay connected, so no edge weighs 0.
}

// One step of least squares with the norm's weights; the first photo stays.
void averageOnce(const Component& component, std::span<const int> indexOf, Norm norm, Rotations& rotations) {
    const auto count = static_cast<Eigen::Index>(rotations.size());
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(count, 3);
    entries.emplace_back(0, 0, 1.0);
    for (const GraphEdge& edge : component.edges) {
        const auto a = static_cast<Eigen::Index>(placeOf(indexOf, edge.a));
        const auto b = static_cast<Eigen::Index>(placeOf(indexOf, edge.b));
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
    const std::optional<Eigen::MatrixXd> turns = solvedSparse(matrix, right);
    if (!turns || !turns->allFinite()) {
        return;
    }
    for (Eigen::Index i = 0; i < count; ++i) {
        Eigen::Quaterniond& rotation = rotations[static_cast<std::size_t>(i)];
        rotation = (turn(turns->row(i).transpose()) * rotation).normalized();
    }
}

double costOf(const Component& component, std::span<const int> indexOf, const Rotations& rotations) {
    double cost = 0;
    for (const GraphEdge& edge : component.edges) {
        const double ratio = disagreement(edge, rotations, indexOf).norm() / kAverageToleranceRad;
        cost += edge.weight * ratio * ratio / (1 + ratio * ratio);
    }
    return cost;
}

} // namespace

Eigen::Vector3d disagreement(const GraphEdge& edge, std::span<const Eigen::Quaterniond> componentFromPhoto,
                             std::span<const int> indexOf) {
    return turnVector(componentFromPhoto[placeOf(indexOf, edge.a)] * edge.aFromB *
                      componentFromPhoto[placeOf(indexOf, edge.b)].conjugate());
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
