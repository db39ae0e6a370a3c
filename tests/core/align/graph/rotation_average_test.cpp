// SPDX-License-Identifier: GPL-3.0-or-later
#include "graph/pose_graph.h"
#include "pairs/pair_geometry.h"
#include "random.h"

#include "spherewalk/geometry/rotation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace spherewalk::align {

using Eigen::Quaterniond;
using Eigen::Vector3d;

namespace {

/// A ring of photos with chords, whose edges err by so much.
struct PlantedGraph {
    Component component;
    std::vector<Quaterniond> roomFromPhoto;
    std::vector<int> indexOf;

    void add(int a, int b, const Vector3d& errorRad) {
        const Quaterniond& roomFromA = roomFromPhoto[static_cast<std::size_t>(a)];
        const Quaterniond& roomFromB = roomFromPhoto[static_cast<std::size_t>(b)];
        component.edges.push_back({static_cast<int>(component.edges.size()), a, b,
                                   roomFromA.conjugate() * turn(errorRad) * roomFromB});
    }

    std::vector<Quaterniond> averaged() const { return averagedRotations(component, indexOf); }

    /// The largest turn between a rotation and the planted one, once the first photo's agrees.
    double worstRad(const std::vector<Quaterniond>& found) const {
        const Quaterniond roomFromFound = roomFromPhoto[0] * found[0].conjugate();
        double worst = 0;
        for (std::size_t i = 0; i < found.size(); ++i) {
            worst = std::max(worst, angleBetween(roomFromFound * found[i], roomFromPhoto[i]).value());
        }
        return worst;
    }
};

PlantedGraph plantedGraph(int photos, int chords, double sigmaRad, test::Random& random) {
    PlantedGraph graph;
    for (int i = 0; i < photos; ++i) {
        graph.roomFromPhoto.push_back(random.rotation());
        graph.component.photos.push_back(i);
        graph.indexOf.push_back(i);
    }
    for (int i = 0; i < photos; ++i) {
        graph.add(i, (i + 1) % photos, random.vector(sigmaRad));
    }
    for (int i = 0; i < chords; ++i) {
        const int a = random.integer(0, photos - 1);
        graph.add(a, (a + random.integer(2, photos - 2)) % photos, random.vector(sigmaRad));
    }
    return graph;
}

/// A pair estimate for each two photos; all of them are right.
std::vector<PairEstimate> allPairs(const std::vector<Quaterniond>& roomFromPhoto) {
    std::vector<PairEstimate> estimates;
    const int count = static_cast<int>(roomFromPhoto.size());
    for (int a = 0; a < count; ++a) {
        for (int b = a + 1; b < count; ++b) {
            PairEstimate estimate;
            estimate.a = a;
            estimate.b = b;
            estimate.verdict = PairVerdict::Constraint;
            estimate.inliers = 200;
            estimate.aFromB = roomFromPhoto[static_cast<std::size_t>(a)].conjugate() *
                              roomFromPhoto[static_cast<std::size_t>(b)];
            estimates.push_back(estimate);
        }
    }
    return estimates;
}

std::vector<Quaterniond> anyRotations(int count, test::Random& random) {
    std::vector<Quaterniond> rotations;
    for (int i = 0; i < count; ++i) {
        rotations.push_back(random.rotation());
    }
    return rotations;
}

} // namespace

TEST(AveragedRotations, AreThePlantedOnesWhereNoEdgeErrs) {
    for (unsigned seed = 600; seed < 610; ++seed) {
        test::Random random(seed);
        const PlantedGraph graph = plantedGraph(random.integer(4, 30), 20, 0, random);
        EXPECT_LT(graph.worstRad(graph.averaged()), 1e-7) << "seed " << seed;
    }
}

TEST(AveragedRotations, AreBetterThanTheEdgesTheyAverage) {
    for (unsigned seed = 610; seed < 620; ++seed) {
        test::Random random(seed);
        const PlantedGraph graph = plantedGraph(20, 150, 0.01, random);
        EXPECT_LT(graph.worstRad(graph.averaged()), 0.02) << "seed " << seed;
    }
}

TEST(AveragedRotations, AreNotPulledByAFifthOfWrongEdges) {
    for (unsigned seed = 620; seed < 630; ++seed) {
        test::Random random(seed);
        PlantedGraph graph = plantedGraph(20, 120, 0.003, random);
        for (int i = 0; i < 28; ++i) {
            const int a = random.integer(0, 18);
            graph.add(a, random.integer(a + 1, 19), 2.5 * random.direction());
        }
        EXPECT_LT(graph.worstRad(graph.averaged()), 0.01) << "seed " << seed;
    }
}

TEST(AveragedRotations, DoNotDependOnWhichWayAnEdgeWasMade) {
    test::Random random(630);
    SCOPED_TRACE(random.seed());
    PlantedGraph graph = plantedGraph(12, 40, 0.01, random);
    const std::vector<Quaterniond> before = graph.averaged();
    for (GraphEdge& edge : graph.component.edges) {
        std::swap(edge.a, edge.b);
        edge.aFromB = edge.aFromB.conjugate();
    }
    const std::vector<Quaterniond> after = graph.averaged();
    for (std::size_t i = 0; i < before.size(); ++i) {
        EXPECT_LT(angleBetween(before[i], after[i]).value(), 1e-9) << "photo " << i;
    }
}

TEST(AveragedRotations, FindPhotosByTheirPlaceInTheComponent) {
    test::Random random(631);
    SCOPED_TRACE(random.seed());
    const PlantedGraph dense = plantedGraph(6, 10, 0.005, random);
    PlantedGraph sparse = dense;
    sparse.indexOf.assign(60, 0);
    for (int i = 0; i < 6; ++i) {
        sparse.component.photos[static_cast<std::size_t>(i)] = 10 * i + 3;
        sparse.indexOf[static_cast<std::size_t>(10 * i + 3)] = i;
    }
    for (GraphEdge& edge : sparse.component.edges) {
        edge.a = 10 * edge.a + 3;
        edge.b = 10 * edge.b + 3;
    }
    EXPECT_EQ(sparse.worstRad(sparse.averaged()), dense.worstRad(dense.averaged()));
}

TEST(Disagreement, IsTheErrorOfTheEdgeInTheComponentsFrame) {
    test::Random random(632);
    SCOPED_TRACE(random.seed());
    for (int i = 0; i < 100; ++i) {
        PlantedGraph graph = plantedGraph(3, 0, 0, random);
        const Vector3d errorRad = random.uniform(0, 3) * random.direction();
        graph.add(0, 2, errorRad);
        const Vector3d left = disagreement(graph.component.edges.back(), graph.roomFromPhoto, graph.indexOf);
        EXPECT_LT((left - errorRad).norm(), 1e-9);
    }
}

TEST(PoseGraph, CountsEveryTriangleOfACompleteGraphOnce) {
    test::Random random(633);
    SCOPED_TRACE(random.seed());
    for (int count = 2; count <= 9; ++count) {
        const PoseGraph graph = poseGraph(count, allPairs(anyRotations(count, random)));
        ASSERT_EQ(graph.components.size(), 1U);
        for (const GraphEdge& edge : graph.components[0].edges) {
            EXPECT_EQ(edge.triangles, count - 2);
            EXPECT_EQ(edge.closed, count - 2);
        }
        EXPECT_LT(graph.cycleErrorRad, 1e-7);
        EXPECT_TRUE(graph.contradicted.empty());
    }
}

TEST(PoseGraph, NamesThePairsThatTheOthersContradict) {
    for (unsigned seed = 634; seed < 644; ++seed) {
        test::Random random(seed);
        std::vector<PairEstimate> estimates = allPairs(anyRotations(10, random));
        std::vector<int> wrong;
        for (int i = random.integer(0, 8); i < static_cast<int>(estimates.size()); i += 11) {
            PairEstimate& estimate = estimates[static_cast<std::size_t>(i)];
            estimate.aFromB = turn(random.uniform(0.2, 3) * random.direction()) * estimate.aFromB;
            wrong.push_back(i);
        }
        EXPECT_EQ(poseGraph(10, estimates).contradicted, wrong) << "seed " << seed;
    }
}

TEST(PoseGraph, PassesOverWhatIsNoConstraintOrNoRotation) {
    test::Random random(644);
    SCOPED_TRACE(random.seed());
    std::vector<PairEstimate> estimates = allPairs(anyRotations(5, random));
    estimates[0].verdict = PairVerdict::TooFew;
    estimates[1].aFromB.w() = std::numeric_limits<double>::quiet_NaN();
    estimates[2].aFromB.coeffs() *= 2;
    estimates[3].b = estimates[3].a;
    const PoseGraph graph = poseGraph(5, estimates);
    ASSERT_EQ(graph.components.size(), 1U);
    const std::vector<GraphEdge>& edges = graph.components[0].edges;
    EXPECT_EQ(edges.size(), estimates.size() - 4);
    EXPECT_TRUE(std::ranges::all_of(edges, [](const GraphEdge& edge) { return edge.pair >= 4; }));
    EXPECT_TRUE(graph.contradicted.empty());
}

TEST(PoseGraph, KeepsAPhotoWithOneGoodNeighbourThoughWallsHideTheOthers) {
    const auto componentsWith = [](double share) {
        std::vector<PairEstimate> estimates(4);
        for (int i = 0; i < 4; ++i) {
            PairEstimate& estimate = estimates[static_cast<std::size_t>(i)];
            estimate.a = 0;
            estimate.b = i + 1;
        }
        estimates[0].verdict = PairVerdict::Constraint;
        estimates[0].inliers = 71;
        estimates[0].inlierShare = share;
        return poseGraph(5, estimates).components.size();
    };
    EXPECT_EQ(componentsWith(0.85), 1U);
    EXPECT_EQ(componentsWith(0.4), 0U); // so do mirror images
}

TEST(PoseGraph, OfNothingHasNoComponents) {
    EXPECT_TRUE(poseGraph(0, {}).components.empty());
    EXPECT_TRUE(poseGraph(7, {}).components.empty());
    EXPECT_EQ(poseGraph(7, {}).cycleErrorRad, 0);
}

TEST(SolvedSparse, IsThePlantedSolution) {
    test::Random random(645);
    SCOPED_TRACE(random.seed());
    for (int count = 1; count < 20; ++count) {
        const Eigen::MatrixXd root =
            Eigen::MatrixXd::NullaryExpr(count, count, [&] { return random.normal(); });
        const Eigen::MatrixXd matrix = root * root.transpose() + Eigen::MatrixXd::Identity(count, count);
        const Eigen::MatrixXd planted =
            Eigen::MatrixXd::NullaryExpr(count, 3, [&] { return random.normal(); });
        const auto solved = solvedSparse(matrix.sparseView(), matrix * planted);
        ASSERT_TRUE(solved);
        EXPECT_LT((*solved - planted).norm(), 1e-8);
    }
}

TEST(SolvedSparse, IsEmptyForAMatrixOfZeros) {
    EXPECT_FALSE(solvedSparse(Eigen::SparseMatrix<double>(4, 4), Eigen::MatrixXd::Ones(4, 1)));
}

} // namespace spherewalk::align
