// SPDX-License-Identifier: GPL-3.0-or-later
#include "random.h"
#include "temporary_folder.h"
#include "test_dataset.h"

#include "spherewalk/base/statistics.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jobs/walk.h"
#include "spherewalk/photo/picture_file.h"
#include "spherewalk/practice/practice_room.h"
#include "spherewalk/render/renderer.h"
#include "spherewalk/scene/depth_sweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <numbers>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

namespace spherewalk {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// What views said of their pixels, and what was true.
struct Stated {
    std::vector<double> stated;
    std::vector<double> found;
    std::vector<bool> isFlagged;
    std::vector<double> inViews; ///< Rank correlation inside each view.
    std::vector<double> ofViews; ///< What each view said of itself.
    std::vector<double> foundOfViews;

    /// The share of the pixels stated better than e that are worse than 2 e.
    double worse(double e) const {
        double all = 0;
        double bad = 0;
        for (std::size_t i = 0; i < found.size(); ++i) {
            all += stated[i] < e ? 1 : 0;
            bad += stated[i] < e && found[i] > 2 * e ? 1 : 0;
        }
        return all > 0 ? bad / all : 0;
    }

    double ratio() const {
        std::vector<double> ratios;
        for (std::size_t i = 0; i < found.size(); ++i) {
            ratios.push_back(stated[i] / std::max(found[i], 1e-3));
        }
        return median(ratios);
    }

    /// The share of the pixels off by more than 10 px that are flagged.
    double flaggedOfBad() const {
        double all = 0;
        double flagged = 0;
        for (std::size_t i = 0; i < found.size(); ++i) {
            all += found[i] > 10 ? 1 : 0;
            flagged += found[i] > 10 && isFlagged[i] ? 1 : 0;
        }
        return all > 0 ? flagged / all : 1;
    }
};

/// A block of photos of a practice room, 40 cm apart, with depths that are found in the photos.
class MeasuredTrust : public testing::TestWithParam<practice::RoomStyle> {
  protected:
    static constexpr int kPhotoWidth = 1024;
    static constexpr int kSide = 3;
    static constexpr double kStepM = 0.4;

    MeasuredTrust() {
        practice::PracticeRoomOptions options;
        options.style = GetParam();
        if (options.style == practice::RoomStyle::Flat) {
            options.sizeM = {8, 6, 2.6};
            m_corner = {1.6, 2.6};
        }
        m_room = std::make_unique<practice::PracticeRoom>(options);
        write();
    }

    /// The views between the photos, and what they are off.
    Stated views(render::SceneKind scene) {
        const render::Renderer renderer(
            std::make_shared<const render::Dataset>(render::Dataset::open(m_folder.path())));
        const CameraModel camera(CameraIntrinsics::pinhole(320, 240, 1.0));
        test::Random random(93);
        Stated result;
        for (int i = 0; i < 24; ++i) {
            const Vector3d place(m_corner.x() + random.uniform(-0.3, 0.3 + 2 * kStepM),
                                 m_corner.y() + random.uniform(-0.3, 0.3 + 2 * kStepM),
                                 random.uniform(0.8, 1.5));
            const Rigid3 pose{
                rotation({Radians(random.uniform(-3, 3)), Radians(random.uniform(-0.2, 0.4)), Radians(0)}) *
                    bodyFromOptical(),
                place};
            render::ViewOptions options;
            options.scene = scene;
            options.wantsDepth = options.wantsTrust = true;
            add(renderer.render(camera, pose, options), camera, pose, result);
        }
        return result;
    }

    /// Of a stereo pair that drives past the photos, 12 cm apart: the differences of the disparities that its
    /// pictures show and those that the left camera's depth says, where the picture has something to compare.
    /// Both are read from the files of a walk. Units: pixels.
    std::vector<double> disparityErrors(render::SceneKind scene) {
        const render::Renderer renderer(
            std::make_shared<const render::Dataset>(render::Dataset::open(m_folder.path())));
        const CameraIntrinsics camera = CameraIntrinsics::pinhole(320, 240, 1.0);
        constexpr double kBaselineM = 0.12;
        constexpr std::size_t kFrames = 16;
        std::vector<TimedPose> path;
        for (std::size_t i = 0; i < kFrames; ++i) {
            const double share = static_cast<double>(i) / kFrames;
            path.push_back({0.05 * static_cast<double>(i), // 1 m/s
                            {yawRotation(Radians(2 * std::numbers::pi * share)),
                             {m_corner.x() + 2 * kStepM * share, m_corner.y() + 1.3 * kStepM * share, 1.2}}});
        }
        const std::vector<render::RigCamera> rig{
            {"left", "left_optical", camera, Rigid3{bodyFromOptical(), {0, 0, 0}}},
            {"right", "right_optical", camera, Rigid3{bodyFromOptical(), {0, -kBaselineM, 0}}}};
        jobs::WalkOptions options;
        options.view.scene = scene;
        options.writesDepth = true;
        const std::filesystem::path out = m_folder / text("walk-", name(scene));
        jobs::walk(renderer, jobs::walkCameras(rig, path, "stereo"), options, out, noProgress(), {});
        std::vector<double> errors;
        for (std::size_t i = 0; i < kFrames; ++i) {
            const std::string file = text(i < 10 ? "00000" : "0000", i, ".png");
            const RgbImage left = photo::readPicture(out / "left" / file);
            const RgbImage right = photo::readPicture(out / "right" / file);
            const Image<std::uint16_t, 1> depthMm = photo::readPng16(out / "left/depth" / file);
            for (int y = 10; y < camera.height - 10; y += 5) {
                for (int x = 60; x < camera.width - 20; x += 5) {
                    const double said = camera.fx * kBaselineM / (0.001 * *depthMm.at(x, y));
                    const auto shown =
                        std::isfinite(said) ? shownDisparity(left, right, x, y, said) : std::nullopt;
                    if (shown) {
                        errors.push_back(std::abs(*shown - said));
                    }
                }
            }
        }
        return errors;
    }

  private:
    /// The disparity with the least squared difference of patches, within 8 pixels of a guess and finer than
    /// a pixel. Nothing where the left picture has no edge across the row, or no minimum is found.
    static std::optional<double> shownDisparity(const RgbImage& left, const RgbImage& right, int x, int y,
                                                double guess) {
        constexpr int kPatch = 4;
        constexpr int kReach = 8;
        const auto difference = [&](const RgbImage& other, int shift) {
            double sum = 0;
            for (int v = y - kPatch; v <= y + kPatch; ++v) {
                for (int u = x - kPatch; u <= x + kPatch; ++u) {
                    const double of = other.at(u - shift, v)[1] - left.at(u, v)[1];
                    sum += of * of;
                }
            }
            return sum;
        };
        constexpr double kEdge = 40 * (2 * kPatch + 1) * (2 * kPatch + 1); // 6 grey levels a pixel
        const int first = static_cast<int>(std::lround(guess)) - kReach;
        if (x - kPatch - first - 2 * kReach < 0 || x + kPatch - first >= left.width() ||
            difference(left, 1) < kEdge) {
            return std::nullopt;
        }
        std::vector<double> differences;
        for (int shift = first; shift <= first + 2 * kReach; ++shift) {
            differences.push_back(difference(right, shift));
        }
        const auto least = std::min_element(differences.begin(), differences.end());
        if (least == differences.begin() || std::next(least) == differences.end()) {
            return std::nullopt;
        }
        const double before = *std::prev(least);
        const double after = *std::next(least);
        const double part = 0.5 * (before - after) / std::max(before + after - 2 * *least, 1e-9);
        return first + static_cast<double>(std::distance(differences.begin(), least)) + part;
    }

    void write() {
        std::vector<Rigid3> poses;
        std::vector<RgbImage> pictures;
        for (int i = 0; i < kSide * kSide; ++i) {
            poses.push_back(
                {yawRotation(Radians(0.7 * i)),
                 {m_corner.x() + kStepM * (i % kSide), m_corner.y() + kStepM * (i / kSide), 1.2}});
            pictures.push_back(m_room->spherical(poses.back(), {kPhotoWidth, kPhotoWidth / 2}));
        }
        m_info = test::writeTestDataset(
            m_folder.path(), poses, [](const Vector3d&) { return Vector3d(9, 9, 9); }, kPhotoWidth, 2.0);
        const practice::RoomPlan plan = m_room->plan();
        m_info.ceilingM = plan.ceilingM;
        constexpr double kFitM = 0.008; // how exact a fitted room is
        m_info.roomShape = render::RoomShape{plan.outline, kFitM, plan.ceilingM - kFitM};
        for (Vector2d& corner : m_info.roomShape->outline) {
            corner += kFitM * (corner.array() > 1).cast<double>().matrix();
        }
        std::filesystem::create_directories(m_folder.path() / "depth");
        scene::SweepOptions options;
        options.width = 512;
        options.coarseWidth = 256;
        options.distances = 96;
        std::vector<std::vector<std::size_t>> neighbours;
        std::vector<scene::PhotoDepth> swept;
        for (std::size_t i = 0; i < poses.size(); ++i) {
            neighbours.push_back(scene::sweepNeighbours(poses, i, options));
            std::vector<scene::PosedPicture> others;
            for (const std::size_t other : neighbours.back()) {
                others.push_back({&pictures[other], poses[other]});
            }
            swept.push_back(scene::sweptDepth({&pictures[i], poses[i]}, others, options));
        }
        for (std::size_t i = 0; i < poses.size(); ++i) {
            std::vector<scene::PosedDepth> others;
            for (std::size_t k = 0; k < std::min<std::size_t>(4, neighbours[i].size()); ++k) {
                others.push_back({&swept[neighbours[i][k]], poses[neighbours[i][k]]});
            }
            scene::PhotoDepth depth = scene::agreeingDepth({&swept[i], poses[i]}, pictures[i], others);
            writePhoto(m_info.photos[i], pictures[i],
                       render::DepthMap(std::move(depth.inverseM), std::move(depth.sure)));
        }
        test::rewriteInfo(m_folder.path(), m_info);
    }

    void writePhoto(render::DatasetPhoto& photo, const RgbImage& picture, const render::DepthMap& depth) {
        const Bytes bytes = jpeg::encode(picture, 92);
        writeFile(m_folder.path() / photo.file, bytes);
        photo.sha256 = sha256Hex(bytes);
        photo.sizeBytes = bytes.size();
        photo.depth = "depth/" + std::filesystem::path(photo.file).stem().string() + ".pgm";
        writeFile(m_folder.path() / photo.depth, depth.serialised());
    }

    /// The displacement is that of the thing at its true distance, seen where the view has it.
    void add(const render::View& view, const CameraModel& camera, const Rigid3& pose, Stated& all) const {
        const DepthImage truth = m_room->viewDepth(camera, pose);
        const Vector3d offset =
            pose.rotation.conjugate() *
            (pose.translation - m_info.photos[view.report.photo].roomFromPhoto.translation);
        std::vector<double> stated;
        std::vector<double> found;
        for (int y = 1; y < camera.height(); y += 3) {
            for (int x = 1; x < camera.width(); x += 3) {
                const Vector3d ray = camera.ray(Vector2d(x, y)).value();
                const double inverse = view.depth.empty() ? 0 : ray.z() / *view.depth.at(x, y);
                const Vector3d across = offset - offset.dot(ray) * ray;
                constexpr double kSmall = 1e-4;
                const Vector2d moved =
                    (camera.project(ray + kSmall * across).value() - Vector2d(x, y)) / kSmall;
                found.push_back(moved.norm() * std::abs(inverse - ray.z() / *truth.at(x, y)));
                stated.push_back(*view.trust.errorPx.at(x, y));
                const std::uint8_t flags = *view.trust.flags.at(x, y);
                all.isFlagged.push_back(has(flags, render::PixelFlag::Filled) ||
                                        has(flags, render::PixelFlag::Unsure));
            }
        }
        all.stated.insert(all.stated.end(), stated.begin(), stated.end());
        all.found.insert(all.found.end(), found.begin(), found.end());
        all.inViews.push_back(rankCorrelation(stated, found).value_or(0));
        all.ofViews.push_back(view.report.parallaxPx);
        all.foundOfViews.push_back(median(found));
    }

    Vector2d m_corner{2.1, 1.6};
    std::unique_ptr<practice::PracticeRoom> m_room;
    test::TemporaryFolder m_folder;
    render::DatasetInfo m_info;
};

std::string nameOf(practice::RoomStyle style) {
    return style == practice::RoomStyle::Flat ? "Flat" : "Lively";
}

TEST_P(MeasuredTrust, IsWhatTheViewIsOff) {
    using render::SceneKind;
    std::cout << "room scene inside over ratio worse0.5 worse1 worse2 worse5 flagged_of_bad flagged\n";
    for (const SceneKind scene :
         {SceneKind::None, SceneKind::Sphere, SceneKind::Room, SceneKind::Depth, SceneKind::Blend}) {
        const Stated all = views(scene);
        const double inside = std::accumulate(all.inViews.begin(), all.inViews.end(), 0.0) /
                              static_cast<double>(all.inViews.size());
        const double over = rankCorrelation(all.ofViews, all.foundOfViews).value_or(0);
        std::cout << std::fixed << std::setprecision(3) << nameOf(GetParam()) << ' ' << name(scene) << ' '
                  << inside << ' ' << over << ' ' << all.ratio();
        for (const double e : {0.5, 1.0, 2.0, 5.0}) {
            std::cout << ' ' << all.worse(e);
            EXPECT_LT(all.worse(e), 0.2) << name(scene) << ' ' << e;
        }
        std::cout << ' ' << all.flaggedOfBad() << ' '
                  << static_cast<double>(std::count(all.isFlagged.begin(), all.isFlagged.end(), true)) /
                         static_cast<double>(all.isFlagged.size())
                  << '\n';
        // The room's planes and the depths are about equally exact on walls, so either may be stated.
        const bool isRoom = scene == SceneKind::Room;
        EXPECT_GT(inside, hasSurfaces(scene) ? 0.4 : 0.8) << name(scene);
        EXPECT_GT(over, hasSurfaces(scene) ? 0.5 : 0.9) << name(scene);
        EXPECT_GT(all.ratio(), 0.65) << name(scene);
        EXPECT_LT(all.ratio(), isRoom ? 2.5 : 1.5) << name(scene);
        EXPECT_GT(all.flaggedOfBad(), 0.85) << name(scene);
    }
}

TEST_P(MeasuredTrust, DepthAgreesWithTheDisparityOfAStereoPairThatWalks) {
    std::cout << "room scene pixels median p90\n";
    for (const render::SceneKind scene : {render::SceneKind::Depth, render::SceneKind::Blend}) {
        std::vector<double> errors = disparityErrors(scene);
        ASSERT_GT(errors.size(), 1000U) << name(scene);
        std::sort(errors.begin(), errors.end());
        std::cout << nameOf(GetParam()) << ' ' << name(scene) << ' ' << errors.size() << ' ' << median(errors)
                  << ' ' << errors[errors.size() * 9 / 10] << '\n';
        EXPECT_LT(median(errors), 0.5) << name(scene);
    }
}

INSTANTIATE_TEST_SUITE_P(Rooms, MeasuredTrust,
                         testing::Values(practice::RoomStyle::Lively, practice::RoomStyle::Flat),
                         [](const auto& tested) { return nameOf(tested.param); });

} // namespace
} // namespace spherewalk
