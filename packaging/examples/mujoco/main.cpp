// SPDX-License-Identifier: Apache-2.0
// MuJoCo drives a robot among the walls of a room that was scanned; its camera sees the photos, with what
// MuJoCo renders laid over by depth.
#include "object_camera.h"
#include "room_world.h"
#include "simulation.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/trajectory.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/render/camera_info.h"
#include "spherewalk/render/light_probe.h"
#include "spherewalk/render/view_stream.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <utility>

namespace render = spherewalk::render;
using namespace mujoco_example;
using spherewalk::text;

namespace {

constexpr double kBallAheadM = 1.8;

struct Options {
    std::string dataset;
    std::string out;
    std::string camera;
    double seconds = 20;
    std::vector<double> start; ///< x, y, yaw in degrees
    std::vector<double> ball;  ///< x, y
    double table = 0;          ///< metres; 0 for none
    double ballRadius = WorldOptions().ballRadiusM;
    bool isLit = true;
};

spherewalk::CameraModel cameraOf(const Options& options) {
    return spherewalk::CameraModel(options.camera.empty()
                                       ? spherewalk::CameraIntrinsics::pinhole(640, 480, 1.2)
                                       : render::readCameraInfo(options.camera));
}

/// The robot on the spot of the photo in the middle, at whose height its camera is, and the ball a metre
/// ahead, unless they are somewhere else.
WorldOptions worldOf(const Options& options, const render::Dataset& dataset) {
    Eigen::Vector3d middle(0, 0, 0);
    for (const render::DatasetPhoto& photo : dataset.info().photos) {
        middle += photo.roomFromPhoto.translation / static_cast<double>(dataset.info().photos.size());
    }
    const auto& spot = dataset.info().photos[dataset.nearestPhoto(middle)].roomFromPhoto.translation;
    WorldOptions world;
    world.startM = options.start.empty() ? Eigen::Vector2d(spot.head<2>())
                                         : Eigen::Vector2d(options.start[0], options.start[1]);
    world.startYawRad =
        options.start.empty() ? 0 : spherewalk::Radians(spherewalk::Degrees(options.start[2])).value();
    world.lensHeightM = spot.z();
    const Eigen::Vector2d ahead(kBallAheadM * std::cos(world.startYawRad),
                                kBallAheadM * std::sin(world.startYawRad));
    world.ballM.head<2>() = options.ball.empty() ? Eigen::Vector2d(world.startM + ahead)
                                                 : Eigen::Vector2d(options.ball[0], options.ball[1]);
    world.ballRadiusM = options.ballRadius;
    world.tableM = options.table;
    world.ballM.z() = options.table + options.ballRadius;
    return world;
}

std::string frameName(std::size_t frame) {
    const std::string number = std::to_string(frame);
    return std::string(6 - std::min<std::size_t>(6, number.size()), '0') + number + ".jpg";
}

void write(const std::filesystem::path& file, spherewalk::ByteView bytes) {
    std::ofstream stream(file, std::ios::binary);
    stream << spherewalk::textOf(bytes);
    if (!stream.flush()) {
        throw std::runtime_error("Could not write " + file.string() + ".");
    }
}

/// Lights the objects as the photos show the light about the ball, once more whenever it has moved on.
class BallLight {
  public:
    explicit BallLight(render::Renderer renderer) : m_renderer(std::move(renderer)) {}

    void follow(const Simulation& simulation, ObjectRenderer& objects) {
        constexpr double kFarM = 0.3;
        constexpr int kWidth = 128; // a matt ball and a soft shadow need no more
        const Eigen::Vector3d ball = simulation.roomFromBody("ball").translation;
        if (!m_isLit || (ball - m_at).norm() > kFarM) {
            render::ProbeOptions options;
            options.width = kWidth;
            objects.light(render::lightProbe(m_renderer, ball, options));
            m_at = ball;
            m_isLit = true;
        }
    }

  private:
    render::Renderer m_renderer;
    Eigen::Vector3d m_at = Eigen::Vector3d::Zero();
    bool m_isLit = false;
};

void drive(const Options& options) {
    constexpr int kQuality = 92;
    const auto dataset = std::make_shared<const render::Dataset>(render::Dataset::open(options.dataset));
    const spherewalk::CameraModel camera = cameraOf(options);
    Simulation simulation(roomWorld(dataset->info(), objectCamera(camera), worldOf(options, *dataset)));
    ObjectRenderer objects(simulation, objectCamera(camera));
    const bool hasSurfaces = std::ranges::any_of(render::scenesOf(dataset->info()), render::hasSurfaces);
    const render::Renderer renderer(dataset);
    render::ViewStream stream(renderer, camera);
    BallLight light(renderer);
    BumpingDriver driver;

    std::filesystem::create_directories(options.out);
    const std::filesystem::path out = options.out;
    std::vector<spherewalk::TimedPose> poses;
    int bumps = 0;
    for (bool wasBumping = false; simulation.timeS() < options.seconds - 0.05;) {
        if (options.isLit) {
            light.follow(simulation, objects);
        }
        const render::Overlay overlay = objects.overlay(!hasSurfaces);
        render::ViewOptions view;
        view.overlays = {&overlay, 1};
        poses.push_back({simulation.timeS(), simulation.roomFromCamera()});
        const render::View seen = stream.next(poses.back().roomFromCamera, poses.back().timeS, view);
        spherewalk::writeFile(out / frameName(poses.size() - 1),
                              spherewalk::jpeg::encode(seen.picture, kQuality));
        driver.drive(simulation);
        const bool isBumping = simulation.isBumping();
        bumps += isBumping && !wasBumping ? 1 : 0;
        wasBumping = isBumping;
    }
    write(out / "poses.tum", spherewalk::bytesOf(spherewalk::tumText(poses)));
    std::cout << "Wrote " << poses.size() << " frames, 10 a second, and poses.tum to " << options.out
              << "; the robot bumped into something " << bumps << " times.\n";
}

} // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App app(
        "Drives a robot among the walls of a scanned room; its camera sees the photos, and MuJoCo's objects");
    app.add_option("dataset", options.dataset, "Folder of the dataset")->required();
    app.add_option("out", options.out, "Folder to write frames and poses.tum to")->required();
    app.add_option("--camera", options.camera, "The robot's camera: a ROS camera-info YAML");
    app.add_option("--seconds", options.seconds, "To drive")
        ->check(CLI::Range(0.1, 3600.0))
        ->capture_default_str();
    app.add_option("--start", options.start, "Where the robot begins: x y yaw, metres and degrees")
        ->expected(3);
    app.add_option("--ball", options.ball, "Where the ball lies: x y, metres")->expected(2);
    app.add_option("--ball-radius", options.ballRadius, "Metres")
        ->check(CLI::Range(0.01, 1.0))
        ->capture_default_str();
    app.add_option("--table", options.table,
                   "The ball lies on a table of this height that the photos show, metres")
        ->check(CLI::Range(0.0, 2.0));
    app.add_flag("!--no-light", options.isLit, "MuJoCo's own light, and no shadow");
    CLI11_PARSE(app, argc, argv);
    try {
        drive(options);
        return 0;
    } catch (const spherewalk::Error& error) {
        std::cerr << error.sentence() << '\n';
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
    }
    return 1;
}
