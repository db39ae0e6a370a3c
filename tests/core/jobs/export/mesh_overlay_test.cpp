// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "random.h"
#include "temporary_folder.h"

#include "spherewalk/base/file.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jobs/object_overlay.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace spherewalk::jobs {

namespace {

const CameraModel kCamera(CameraIntrinsics::pinhole(96, 72, 1.2));

std::shared_ptr<const ObjectMesh> cube() {
    return std::make_shared<const ObjectMesh>(ObjectMesh::cube());
}

/// A globe of so many meridians, of radius 1.
std::shared_ptr<const ObjectMesh> globe(int meridians) {
    std::vector<Eigen::Vector3f> vertices;
    std::vector<ObjectMesh::Triangle> triangles;
    const int rows = meridians / 2;
    for (int row = 0; row <= rows; ++row) {
        for (int column = 0; column < meridians; ++column) {
            const double lat = M_PI * row / rows;
            const double lon = 2 * M_PI * column / meridians;
            vertices.emplace_back(std::sin(lat) * std::cos(lon), std::sin(lat) * std::sin(lon),
                                  std::cos(lat));
            const auto at = [&](int r, int c) {
                return static_cast<std::uint32_t>(r * meridians + c % meridians);
            };
            if (row < rows) {
                triangles.push_back({at(row, column), at(row + 1, column), at(row, column + 1)});
                triangles.push_back({at(row, column + 1), at(row + 1, column), at(row + 1, column + 1)});
            }
        }
    }
    return std::make_shared<const ObjectMesh>(std::move(vertices), std::move(triangles));
}

int pixels(const render::Overlay& overlay) {
    const auto& depths = overlay.depth.values();
    return static_cast<int>(
        std::count_if(depths.begin(), depths.end(), [](float d) { return std::isfinite(d); }));
}

/// A camera at a place that looks at another, level.
Rigid3 lookingAt(const Eigen::Vector3d& from, const Eigen::Vector3d& at) {
    const Eigen::Vector3d to = at - from;
    return {rotation({Radians(std::atan2(to.y(), to.x())), Radians(std::atan2(-to.z(), to.head<2>().norm())),
                      Radians(0)}) *
                bodyFromOptical(),
            from};
}

class ObjFile : public testing::Test {
  protected:
    ObjectMesh read(const std::string& words) {
        writeFile(m_folder / "mesh.obj", bytesOf(words));
        return readObj(m_folder / "mesh.obj");
    }

    test::TemporaryFolder m_folder;
};

} // namespace

TEST(MeshOverlay, ACubeHasTheDepthOfItsNearestFace) {
    PlacedMesh box{cube(), {2, 0, 0}, 0.5, Radians(0)};
    const render::Overlay overlay = meshOverlay(box, kCamera, lookingAt({0, 0, 0.25}, {2, 0, 0.25}));
    EXPECT_NEAR(*overlay.depth.at(48, 36), 1.75, 1e-5);
    EXPECT_EQ(overlay.picture.at(48, 36)[3], 255);
    EXPECT_NEAR(pixels(overlay), std::pow(0.5 * kCamera.intrinsics().fx / 1.75, 2), 60);
    box.yaw = Radians(M_PI / 4); // an edge points to the camera
    EXPECT_NEAR(*meshOverlay(box, kCamera, lookingAt({0, 0, 0.25}, {2, 0, 0.25})).depth.at(48, 36),
                2 - 0.25 * std::sqrt(2), 0.015); // half a pixel beside the edge
}

TEST(MeshOverlay, AFineGlobeLooksAsTheBallDoes) {
    test::Random random(7);
    const auto mesh = globe(96);
    for (int i = 0; i < 12; ++i) {
        const Rigid3 pose{random.rotation(), 1000 * random.vector(3)}; // also far from the origin
        Ball ball;
        ball.centreM = pose * Eigen::Vector3d(0.2 * random.normal(), 0.1 * random.normal(), 1.5);
        const PlacedMesh object{mesh, ball.centreM - Eigen::Vector3d(0, 0, ball.radiusM), 2 * ball.radiusM,
                                Radians(random.normal())};
        const render::Overlay expected = ballOverlay(ball, kCamera, pose);
        const render::Overlay got = meshOverlay(object, kCamera, pose);
        int differ = 0;
        for (std::size_t k = 0; k < expected.depth.values().size(); ++k) {
            const float a = expected.depth.values()[k];
            const float b = got.depth.values()[k];
            differ += std::isfinite(a) != std::isfinite(b) ? 1 : 0;
            if (std::isfinite(a) && std::isfinite(b)) {
                ASSERT_NEAR(a, b, 0.03) << "seed " << random.seed();
            }
        }
        EXPECT_LE(differ, 20) << "seed " << random.seed() << " of " << pixels(expected); // at the rim
        EXPECT_GT(pixels(got), 100);
    }
}

TEST(MeshOverlay, HasNoCracksAtAnyLens) {
    CameraIntrinsics fisheye = CameraIntrinsics::pinhole(120, 120, 1);
    fisheye.fx = fisheye.fy = 40;
    fisheye.lens = LensModel::Equidistant;
    fisheye.distortion = {0, 0, 0, 0};
    const PlacedMesh object{globe(24), {0.6, 0, 0.1}, 0.8, Radians(0.3)};
    const render::Overlay overlay =
        meshOverlay(object, CameraModel(fisheye), lookingAt({0, 0, 0.5}, {1, 0, 0.5}));
    for (int y = 0; y < 120; ++y) { // a convex object has no hole in any row
        int changes = 0;
        for (int x = 1; x < 120; ++x) {
            changes +=
                std::isfinite(*overlay.depth.at(x, y)) != std::isfinite(*overlay.depth.at(x - 1, y)) ? 1 : 0;
        }
        ASSERT_LE(changes, 2) << "row " << y;
    }
    EXPECT_GT(pixels(overlay), 500);
}

TEST(MeshOverlay, IsEmptyBehindTheCameraAndInsideOfTheObject) {
    PlacedMesh box{cube(), {-2, 0, 0}, 0.5, Radians(0)};
    EXPECT_EQ(pixels(meshOverlay(box, kCamera, lookingAt({0, 0, 0.25}, {2, 0, 0.25}))), 0);
    box.footM = {0, 0, 0};
    EXPECT_EQ(pixels(meshOverlay(box, kCamera, lookingAt({0, 0, 0.25}, {2, 0, 0.25}))), 0);
}

TEST(MeshOverlay, RefusesWhatCannotStandInARoom) {
    for (const PlacedMesh& wrong : {PlacedMesh{}, PlacedMesh{cube(), {0, 0, 0}, 0, Radians(0)},
                                    PlacedMesh{cube(), {0, 0, 0}, -1, Radians(0)},
                                    PlacedMesh{cube(), {0, 0, std::nan("")}, 1, Radians(0)},
                                    PlacedMesh{cube(), {0, 0, 0}, 1, Radians(INFINITY)}}) {
        test::expectError(ErrorKind::InvalidInput, "size above zero",
                          [&] { meshOverlay(wrong, kCamera, {}); });
    }
}

TEST_F(ObjFile, IsReadWhateverItsFacesAreSpelledLike) {
    const ObjectMesh mesh =
        read("# a roof\r\nmtllib a.mtl\r\nv 0 0 0\r\nv 4 0 0 1.0\r\nv 4 2 0\r\nv 0 2 0\r\nvn 0 0 1\r\n"
             "v 2 1 1e0\r\nf 1/1/1 2//1 3 4/2\r\nf -5 -4 -1\r\n\tf 2 3 5\nf 3 4 5");
    EXPECT_EQ(mesh.triangles(), 5U);
    EXPECT_DOUBLE_EQ(mesh.longestSide(), 4);
    EXPECT_TRUE(mesh.sides().isApprox(Eigen::Vector3f(1, 0.5F, 0.25F)));
    ObjectMesh::Hit hit;
    ASSERT_TRUE(mesh.meets({0, 0, 3}, {0, 0, -1}, hit)); // it stands on the origin
    EXPECT_NEAR(hit.along, 2.75, 1e-6);
    EXPECT_GT(hit.normal.z(), 0);
    EXPECT_FALSE(mesh.meets({0, 0, 3}, {0, 0, 1}, hit));
}

TEST_F(ObjFile, ThatIsNoneIsRefusedInOneSentence) {
    const std::pair<std::string, const char*> wrongs[] = {
        {"", "no faces"},
        {"glTF\x02\x00\x00", "no faces"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\n", "no faces"},
        {"v 0 0 0\nv 1 0\nv 0 1 0\nf 1 2 3\n", "line 2"},
        {"v 0 0 0\nv 1 0 nan\nv 0 1 0\nf 1 2 3\n", "line 2"},
        {"v 0 0 0\nv 1 0 1e39\nv 0 1 0\nf 1 2 3\n", "line 2"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n", "line 4"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 0\n", "line 4"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -4\n", "line 4"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99999999999999999999\n", "line 4"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "vertex 4 of 3"},
        {"v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n", "the same"},
    };
    for (const auto& [words, sentence] : wrongs) {
        test::expectError(ErrorKind::Corrupt, sentence, [&, &words = words] { read(words); });
    }
    test::expectError(ErrorKind::NotFound, "nothing.obj", [&] { readObj(m_folder / "nothing.obj"); });
    test::expectError(ErrorKind::InvalidInput, m_folder.path().string(), [&] { readObj(m_folder.path()); });
}

TEST_F(ObjFile, WithNeedlesAndDoubledFacesIsNoTrouble) {
    const ObjectMesh mesh = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\nf 1 2 3\nf 1 2 3\nf 1 4 2\nf 1 1 1\n");
    ObjectMesh::Hit hit;
    EXPECT_TRUE(mesh.meets({-0.2, -0.2, 1}, {0, 0, -1}, hit));
    EXPECT_TRUE(hit.normal.allFinite());
}

TEST(ParsedObject, IsACubeOrAFileWithAPlace) {
    const PlacedMesh cube = parseObject(" cube 1 2.5 0 0.4 90 ");
    EXPECT_EQ(cube.category, "cube");
    EXPECT_EQ(cube.footM, Eigen::Vector3d(1, 2.5, 0));
    EXPECT_EQ(cube.sizeM, 0.4);
    EXPECT_NEAR(cube.yaw.value(), std::acos(0.), 1e-12);
    EXPECT_EQ(parseObject("cube 1 2 3 4").yaw.value(), 0) << "the heading may be left out";
    for (const char* wrong :
         {"", "cube", "cube 1 2 3", "1 2 3 4 5", "cube a b c d", "cube 1 2 0 0", "cube nan 2 0 1"}) {
        test::expectError(ErrorKind::InvalidInput, "", [&] { parseObject(wrong); });
    }
    test::expectError(ErrorKind::NotFound, "no chair.obj", [] { parseObject("no chair.obj 1 2 0 0.5 0"); });
}

} // namespace spherewalk::jobs
