// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a rig of cameras keeps its pace: spherewalk_rig_pace DATASET RIG.yaml [SECONDS] [RATE]
// A robot drives along the photos at 1 m/s, turns, and its poses come every 4 ms in real time, as a simulator
// gives them. Each camera of the rig gives colour and depth. The program prints the pairs (one frame of each
// camera, with one stamp) that came of those that were due, and the time from a pose to the pictures of all
// cameras. The first second, in which the first photos are decoded, is left out.
#include "spherewalk/base/error.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/base/statistics.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/render/camera_info.h"
#include "spherewalk/simulator/simulated_camera.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <thread>
#include <vector>

using namespace spherewalk;

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kSpeedMps = 1;
constexpr double kTurnRad = 0.5; ///< To each side of the way.
constexpr auto kStep = std::chrono::milliseconds(4);

/// The way from photo to photo, there and back.
class Way {
  public:
    explicit Way(const render::DatasetInfo& info) {
        for (const render::DatasetPhoto& photo : info.photos) {
            const Eigen::Vector3d& at = photo.roomFromPhoto.translation;
            const double lengthM = m_places.empty() ? 0 : (at - m_places.back()).norm();
            if (m_places.empty() || lengthM > 0) {
                m_waysM.push_back(m_waysM.empty() ? 0 : m_waysM.back() + lengthM);
                m_places.push_back(at);
            }
        }
    }

    Eigen::Vector3d at(double wayM) const {
        const double lengthM = m_waysM.back();
        const double round = lengthM > 0 ? std::fmod(wayM, 2 * lengthM) : 0;
        const double along = round > lengthM ? 2 * lengthM - round : round;
        std::size_t i = 1;
        while (i + 1 < m_places.size() && m_waysM[i] < along) {
            ++i;
        }
        if (m_places.size() < 2) {
            return m_places.front();
        }
        const double share = (along - m_waysM[i - 1]) / (m_waysM[i] - m_waysM[i - 1]);
        return m_places[i - 1] + share * (m_places[i] - m_places[i - 1]);
    }

  private:
    std::vector<Eigen::Vector3d> m_places;
    std::vector<double> m_waysM; ///< from the first place
};

void measure(const render::Renderer& renderer, const std::vector<render::RigCamera>& rig, double seconds,
             double rateHz) {
    std::vector<simulator::MountedCamera> cameras;
    const std::vector<Rigid3> places = render::placesOnRig(rig, "that is measured");
    for (std::size_t i = 0; i < rig.size(); ++i) {
        cameras.push_back({CameraModel(rig[i].camera), places[i]});
    }
    simulator::CameraOptions options;
    options.wantsDepth = true;
    options.rateHz = rateHz;
    options.mounting.axes = simulator::CameraAxes::Optical; // the rig's frame looks along the link's x
    std::vector<double> latenciesMs;
    std::vector<double> renderMs;
    std::uint64_t unpaired = 0;
    simulator::Stamp stamp{};
    const auto take = [&](const simulator::Frame& frame) {
        unpaired += frame.index > 0 && frame.stamp != stamp ? 1 : 0;
        unpaired += frame.view.depth.empty() ? 1 : 0;
        stamp = frame.stamp;
        if (stamp < std::chrono::seconds(1)) {
            return;
        }
        renderMs.push_back(frame.view.report.renderMs);
        if (frame.index + 1 == rig.size()) {
            const std::chrono::duration<double, std::milli> latency = Clock::now() - frame.poseTakenAt;
            latenciesMs.push_back(latency.count());
        }
    };
    simulator::SimulatedCamera camera(renderer, cameras, options, take, [](const std::string& sentence) {
        std::fprintf(stderr, "%s\n", sentence.c_str());
    });
    camera.setListening(true);
    const Way way(renderer.dataset().info());
    const Clock::time_point begin = Clock::now();
    const std::clock_t begun = std::clock();
    simulator::Stamp now{};
    for (; now < std::chrono::duration<double>(seconds + 1); now += kStep) {
        std::this_thread::sleep_until(begin + now);
        const double timeS = std::chrono::duration<double>(now).count();
        camera.takePose(now,
                        {yawRotation(Radians(kTurnRad * std::sin(0.7 * timeS))), way.at(kSpeedMps * timeS)});
    }
    camera.waitUntilIdle();
    const double processorS = static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC;
    const double pairs = static_cast<double>(latenciesMs.size());
    std::printf(
        "%zu cameras, %d threads: %.0f of %.0f pairs, %.2f Hz; from pose to all pictures: median %.1f "
        "ms, 99 %% %.1f ms, worst %.1f ms; a view %.1f ms; the processor's time is %.0f %% of a core\n",
        rig.size(), hardwareThreads(), pairs, std::round(seconds * rateHz), pairs / seconds,
        quantile(latenciesMs, 0.5), quantile(latenciesMs, 0.99), quantile(latenciesMs, 1),
        quantile(renderMs, 0.5), 100 * processorS / (seconds + 1));
    if (unpaired > 0) {
        throw Error(ErrorKind::Internal,
                    "A camera's frame had another stamp than the first one's, or no depth.");
    }
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 3) {
        std::fprintf(stderr, "Usage: spherewalk_rig_pace DATASET RIG.yaml [SECONDS] [RATE]\n");
        return 2;
    }
    try {
        const render::Renderer renderer(
            std::make_shared<const render::Dataset>(render::Dataset::open(argv[1])));
        measure(renderer, render::readRig(argv[2]), argc > 3 ? std::atof(argv[3]) : 20,
                argc > 4 ? std::atof(argv[4]) : 30);
    } catch (const Error& error) {
        std::fprintf(stderr, "%s\n", error.sentence().c_str());
        return 1;
    }
    return 0;
}
