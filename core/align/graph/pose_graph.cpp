// SPDX-License-Identifier: GPL-3.0-or-later
#include "graph/pose_graph.h"

#include "pairs/disjoint_sets.h"

#include "spherewalk/align/match_pairs.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/statistics.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

namespace spherewalk::align {

namespace {

constexpr double kClosedRad = 0.035;       // Largest turn around a triangle of right pairs.
constexpr double kContradictedRad = 0.052; // Farther from the average a pair is wrong.
constexpr int kRounds = 3;

std::vector<GraphEdge> edgesOf(std::span<const PairEstimate> estimates) {
    std::vector<GraphEdge> edges;
    for (std::size_t i = 0; i < estimates.size(); ++i) {
        const PairEstimate& estimate = estimates[i];
        const bool isRotation = std::abs(estimate.aFromB.norm() - 1) < 0.01; // NaN fails too.
        if (estimate.verdict == PairVerdict::Constraint && isRotation && estimate.a != estimate.b) {
            edges.push_back({static_cast<int>(i), estimate.a, estimate.b, estimate.aFromB.normalized(),
                             std::min(estimate.inliers, 300) / 300.0});
        }
    }
    return edges;
}

void checkPhotos(int photos, std::span<const PairEstimate> estimates) {
    for (const PairEstimate& estimate : estimates) {
        if (std::min(estimate.a, estimate.b) < 0 || std::max(estimate.a, estimate.b) >= photos) {
            throw Error(ErrorKind::InvalidInput, text("A pair names the photos ", estimate.a, " and ",
                                                      estimate.b, ", but there are ", photos, " photos."));
        }
    }
}

struct Side {
    std::size_t edge;
    int other;
};

// The rotation from the other end to this one, whichever way the edge was made.
Eigen::Quaterniond fromTo(const GraphEdge& edge, int from) {
    return edge.a == from ? edge.aFromB : edge.aFromB.conjugate();
}

// Counts every edge's triangles and those that close. Returns the turns that are left around them.
std::vector<double> closeTriangles(int photos, std::vector<GraphEdge>& edges) {
    std::vector<std::vector<Side>> sides(static_cast<std::size_t>(photos));
    std::map<std::pair<int, int>, std::size_t> edgeOf;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const auto [low, high] = std::minmax(edges[i].a, edges[i].b);
        sides[static_cast<std::size_t>(low)].push_back(
            {i, high}); // Only upwards, so that every triangle counts once.
        edgeOf[{low, high}] = i;
    }
    std::vector<double> left;
    for (int first = 0; first < photos; ++first) {
        const std::vector<Side>& from = sides[static_cast<std::size_t>(first)];
        for (std::size_t i = 0; i < from.size(); ++i) {
            for (std::size_t j = i + 1; j < from.size(); ++j) {
                const auto [low, high] = std::minmax(from[i].other, from[j].other);
                const auto third = edgeOf.find({low, high});
                if (third == edgeOf.end()) {
                    continue;
                }
                const Eigen::Quaterniond around = fromTo(edges[from[i].edge], first) *
                                                  fromTo(edges[third->second], from[i].other) *
                                                  fromTo(edges[from[j].edge], from[j].other);
                left.push_back(angleBetween(around, Eigen::Quaterniond::Identity()).value());
                for (const std::size_t edge : {from[i].edge, from[j].edge, third->second}) {
                    ++edges[edge].triangles;
                    edges[edge].closed += left.back() < kClosedRad ? 1 : 0;
                }
            }
        }
    }
    return left;
}

std::vector<Component> componentsOf(int photos, const std::vector<GraphEdge>& edges) {
    DisjointSets sets(static_cast<std::size_t>(photos));
    for (const GraphEdge& edge : edges) {
        const auto [first, second] = std::minmax({sets.of(edge.a), sets.of(edge.b)});
        sets.join(second, first);
    }
    std::map<int, Component> byFirst;
    for (const GraphEdge& edge : edges) {
        byFirst[sets.of(edge.a)].edges.push_back(edge);
    }
    for (int photo = 0; photo < photos; ++photo) {
        const auto component = byFirst.find(sets.of(photo));
        if (component != byFirst.end()) {
            component->second.photos.push_back(photo);
        }
    }
    std::vector<Component> components;
    for (auto& [photo, component] : byFirst) {
        components.push_back(std::move(component));
    }
    std::ranges::stable_sort(components, std::greater<>(),
                             [](const Component& component) { return component.photos.size(); });
    return components;
}

// Whether so many of a pair's matches agree that chance does not explain them. A place that is built alike
// may.
bool isBeyondChance(const PairEstimate& estimate) {
    constexpr int kInliers = 50;
    constexpr double kShare = 0.7;
    return estimate.inliers >= kInliers && estimate.inlierShare >= kShare;
}

// Whether a photo was compared with many others, of which few agree, none in a triangle and none beyond
// chance. It may be a mirror image, or a photo of another room. Photos behind a wall agree with none, either.
std::vector<bool> unconfirmed(int photos, std::span<const PairEstimate> estimates,
                              const std::vector<GraphEdge>& edges, const std::vector<bool>& confirmed) {
    std::vector<int> compared(static_cast<std::size_t>(photos), 0);
    std::vector<int> agreeing(static_cast<std::size_t>(photos), 0);
    std::vector<bool> isConfirmed = confirmed;
    isConfirmed.resize(static_cast<std::size_t>(photos), false);
    for (const PairEstimate& estimate : estimates) {
        ++compared[static_cast<std::size_t>(estimate.a)];
        ++compared[static_cast<std::size_t>(estimate.b)];
    }
    for (const GraphEdge& edge : edges) {
        for (const int photo : {edge.a, edge.b}) {
            const auto at = static_cast<std::size_t>(photo);
            ++agreeing[at];
            isConfirmed[at] = isConfirmed[at] || edge.closed > 0 ||
                              isBeyondChance(estimates[static_cast<std::size_t>(edge.pair)]);
        }
    }
    std::vector<bool> found;
    for (std::size_t i = 0; i < compared.size(); ++i) {
        found.push_back(compared[i] >= 4 && 2 * agreeing[i] < compared[i] && !isConfirmed[i]);
    }
    return found;
}

} // namespace

PoseGraph poseGraph(int photos, std::span<const PairEstimate> estimates, int leastClosed,
                    const std::vector<bool>& confirmed) {
    checkPhotos(photos, estimates);
    PoseGraph graph;
    std::vector<GraphEdge> edges = edgesOf(estimates);
    graph.cycleErrorRad = median(closeTriangles(photos, edges));
    const std::vector<bool> isUnconfirmed = unconfirmed(photos, estimates, edges, confirmed);
    // A pair that none of its many triangles supports would drag its photos along in the average.
    std::erase_if(edges, [&](const GraphEdge& edge) {
        const bool isAlone = edge.closed < leastClosed || (edge.triangles >= 3 && edge.closed == 0) ||
                             isUnconfirmed[static_cast<std::size_t>(edge.a)] ||
                             isUnconfirmed[static_cast<std::size_t>(edge.b)];
        if (isAlone) {
            graph.contradicted.push_back(edge.pair);
        }
        return isAlone;
    });
    std::vector<int> indexOf(static_cast<std::size_t>(photos), 0);
    for (int round = 0; round < kRounds; ++round) {
        graph.components = componentsOf(photos, edges);
        std::vector<GraphEdge> kept;
        for (Component& component : graph.components) {
            for (std::size_t i = 0; i < component.photos.size(); ++i) {
                indexOf[static_cast<std::size_t>(component.photos[i])] = static_cast<int>(i);
            }
            component.componentFromPhoto = averagedRotations(component, indexOf);
            for (GraphEdge& edge : component.edges) {
                edge.residualRad = disagreement(edge, component.componentFromPhoto, indexOf).norm();
                if (edge.residualRad < kContradictedRad) {
                    kept.push_back(edge);
                } else {
                    graph.contradicted.push_back(edge.pair);
                }
            }
        }
        if (kept.size() == edges.size()) {
            break;
        }
        edges = std::move(kept);
    }
    std::ranges::sort(graph.contradicted);
    return graph;
}

std::vector<std::pair<int, int>> neighboursApart(std::span<const Eigen::Vector3d> positionsM,
                                                 std::span<const PairEstimate> estimates,
                                                 const NeighbourOptions& options) {
    constexpr int kJoining = 20; // Inliers of a pair that joins two parts by itself.
    DisjointSets parts(positionsM.size());
    for (const Component& component : poseGraph(static_cast<int>(positionsM.size()), estimates).components) {
        for (const GraphEdge& edge : component.edges) {
            if (edge.closed > 0 || estimates[static_cast<std::size_t>(edge.pair)].inliers >= kJoining) {
                parts.join(edge.a, edge.b);
            }
        }
    }
    std::vector<std::pair<int, int>> apart = neighbours(positionsM, options);
    std::erase_if(apart, [&](const auto& pair) { return parts.of(pair.first) == parts.of(pair.second); });
    return apart;
}

std::string namesOf(std::span<const int> photos, std::span<const PhotoPrior> priors) {
    constexpr std::size_t kNamed = 5;
    std::string names;
    for (std::size_t i = 0; i < std::min(photos.size(), kNamed); ++i) {
        names += text(i == 0 ? "" : ", ", printable(priors[static_cast<std::size_t>(photos[i])].name, 40));
    }
    return photos.size() > kNamed ? text(names, " and ", photos.size() - kNamed, " more") : names;
}

std::optional<Eigen::MatrixXd> solvedSparse(const Eigen::SparseMatrix<double>& matrix,
                                            const Eigen::MatrixXd& right) {
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(matrix);
    if (factor.info() != Eigen::Success) {
        return std::nullopt;
    }
    return Eigen::MatrixXd(factor.solve(right));
}

} // namespace spherewalk::align
