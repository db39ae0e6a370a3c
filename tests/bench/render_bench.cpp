// SPDX-License-Identifier: Apache-2.0
// spherewalk_render_bench [--photo FILE.jpg] [--directions N] [--rounds N] [--field DEGREES of the fidelity
// table] [--clock wall|processor] Times views of 640 x 480 pixels against OpenCV in the same run, after
// checking that they show the same.
#include "fidelity.h"
#include "measured.h"
#include "pictures.h"
#include "reference_sampling.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/render/projection.h"

#include <hwy/targets.h>
#include <opencv2/imgproc.hpp>

#include <barrier>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <numbers>
#include <string>

#if defined(__linux__)
#include <sched.h>
#endif

namespace spherewalk::bench {

using Eigen::Vector2d;
using Eigen::Vector3d;
using render::Sampling;

namespace {

constexpr int kWidth = 640;
constexpr int kHeight = 480;
constexpr double kRadiusM = 2.5;

/// The camera turns and moves a little from frame to frame.
Rigid3 poseOf(int run, double pitchDeg) {
    return lookingTo(7.3 * run, pitchDeg, {0.1, 0.02 * (run % 5), 0});
}

struct Setting {
    double fieldDeg;
    double pitchDeg;
};

/// Maps as they are commonly built: trigonometry in double precision for each pixel, and nothing else that
/// could be left out.
void buildMaps(const Rigid3& pose, const CameraIntrinsics& k, const cv::Size& photo, cv::Mat& mapX,
               cv::Mat& mapY) {
    mapX.create(k.height, k.width, CV_32F);
    mapY.create(k.height, k.width, CV_32F);
    const Eigen::Matrix3d turn = pose.rotation.toRotationMatrix();
    const Vector3d from = pose.translation / kRadiusM;
    const double room = 1 - from.squaredNorm();
    const double perRadianX = photo.width / (2 * std::numbers::pi);
    const double perRadianY = photo.height / std::numbers::pi;
    const Vector3d step = turn.col(0) / k.fx;
    for (int y = 0; y < k.height; ++y) {
        const Vector3d first = turn * Vector3d(-k.cx / k.fx, (y - k.cy) / k.fy, 1);
        float* toX = mapX.ptr<float>(y);
        float* toY = mapY.ptr<float>(y);
        for (int x = 0; x < k.width; ++x) {
            const double rayX = first.x() + x * step.x();
            const double rayY = first.y() + x * step.y();
            const double rayZ = first.z() + x * step.z();
            const double square = rayX * rayX + rayY * rayY + rayZ * rayZ;
            const double along = from.x() * rayX + from.y() * rayY + from.z() * rayZ;
            const double t = (std::sqrt(along * along + square * room) - along) / square;
            const double dX = from.x() + t * rayX;
            const double dY = from.y() + t * rayY;
            const double dZ = from.z() + t * rayZ;
            toX[x] = static_cast<float>((std::numbers::pi - std::atan2(dY, dX)) * perRadianX - 0.5);
            toY[x] = static_cast<float>((std::numbers::pi / 2 - std::asin(dZ)) * perRadianY - 0.5);
        }
    }
}

/// A machine that does other things too would otherwise leave two threads on one processor.
void keepApart(WorkerPool& pool) {
#if defined(__linux__)
    const int count = pool.threads();
    std::barrier all(count);
    pool.run(count, count, [&](int, int worker) {
        all.arrive_and_wait(); // each worker has one
        cpu_set_t own;
        CPU_ZERO(&own);
        CPU_SET(static_cast<unsigned>(worker), &own);
        sched_setaffinity(0, sizeof own, &own);
    });
#endif
}

class Views {
  public:
    Views(const Source& source, const Setting& setting)
        : m_source(source),
          m_setting(setting),
          m_camera(CameraIntrinsics::pinhole(kWidth, kHeight, setting.fieldDeg * std::numbers::pi / 180)) {
        const int n =
            samplesPerAxis(Sampling::Footprint, render::minification(m_camera, source.picture.width()));
        m_single = render::RayTable(m_camera, 1);
        m_several = render::RayTable(m_camera, n);
        keepApart(m_pool);
    }

    const CameraModel& camera() const { return m_camera; }

    const RgbImage& ours(Sampling sampling, int threads, int run) {
        const render::PlaneView plane =
            (sampling == Sampling::Reduced ? m_source.half : m_source.plane).view();
        renderView(sampling == Sampling::Footprint ? m_several : m_single, poseOf(run, m_setting.pitchDeg),
                   {plane, {}, render::SceneKind::Sphere, kRadiusM}, sampling, m_pool, threads, m_workspace,
                   m_view);
        return m_view;
    }

    const cv::Mat& mapsAndRemap(int run) {
        const cv::Mat photo = asMat();
        buildMaps(poseOf(run, m_setting.pitchDeg), m_camera.intrinsics(), photo.size(), m_mapX, m_mapY);
        cv::remap(photo, m_theirs, m_mapX, m_mapY, cv::INTER_LINEAR, cv::BORDER_WRAP);
        return m_theirs;
    }

    /// As many ready maps as the poses that are used in turns.
    void prepareMaps(int count) {
        for (int run = 0; run < count; ++run) {
            buildMaps(poseOf(run, m_setting.pitchDeg), m_camera.intrinsics(), asMat().size(), m_mapX, m_mapY);
            auto& [whole, fraction] = m_fixed.emplace_back();
            cv::convertMaps(m_mapX, m_mapY, whole, fraction, CV_16SC2);
        }
    }

    void remapAlone(int run, int border) {
        const auto& [whole, fraction] = m_fixed[static_cast<std::size_t>(run) % m_fixed.size()];
        cv::remap(asMat(), m_theirs, whole, fraction, cv::INTER_LINEAR, border);
    }

    /// Mean difference to the exact reference, in grey levels.
    double difference(int run) {
        const RgbImage& view = ours(Sampling::Bilinear, 0, run);
        const EquirectSize size{m_source.picture.width(), m_source.picture.height()};
        const render::Projection projection(m_camera, poseOf(run, m_setting.pitchDeg), {}, size,
                                            render::SceneKind::Sphere, kRadiusM);
        double sum = 0;
        for (int i = 0; i < kWidth * kHeight; ++i) {
            const Vector2d pixel(i % kWidth, i / kWidth);
            const Vector3d expected = render::bilinear(m_source.picture, *projection.photoPixel(pixel));
            const std::uint8_t* rgb = view.at(i % kWidth, i / kWidth);
            sum += (expected - Vector3d(rgb[0], rgb[1], rgb[2])).cwiseAbs().sum() / (3.0 * kWidth * kHeight);
        }
        return sum;
    }

    double differenceToTheirs(int run) {
        const RgbImage& view = ours(Sampling::Bilinear, 0, run);
        const cv::Mat& theirs = mapsAndRemap(run);
        return cv::norm(theirs, cv::Mat(kHeight, kWidth, CV_8UC3, const_cast<std::uint8_t*>(view.at(0, 0))),
                        cv::NORM_L1) /
               (3.0 * kWidth * kHeight);
    }

  private:
    cv::Mat asMat() const {
        return {m_source.picture.height(), m_source.picture.width(), CV_8UC3,
                const_cast<std::uint8_t*>(m_source.picture.at(0, 0))};
    }

    const Source& m_source;
    Setting m_setting;
    CameraModel m_camera;
    render::RayTable m_single{m_camera, 1};
    render::RayTable m_several{m_camera, 1};
    WorkerPool m_pool;
    render::Workspace m_workspace;
    RgbImage m_view;
    cv::Mat m_mapX;
    cv::Mat m_mapY;
    cv::Mat m_theirs;
    std::vector<std::pair<cv::Mat, cv::Mat>> m_fixed;
};

void time(const Source& source, const Setting& setting, int rounds, Clock clock) {
    Views views(source, setting);
    const double own = views.difference(3);
    const double theirs = views.differenceToTheirs(3);
    std::printf("\nfield of view %.0f deg, pitch %.0f deg (minification %.2f); mean difference of bilinear "
                "to the exact "
                "reference %.3f, to OpenCV %.3f grey levels\n",
                setting.fieldDeg, setting.pitchDeg,
                render::minification(views.camera(), source.picture.width()), own, theirs);
    if (own > 0.5 || theirs > 1.5) {
        std::printf("  the views differ: nothing was timed\n");
        std::exit(1);
    }
    views.prepareMaps(20);
    Contest contest;
    contest.add("opencv maps + remap", [&](int run) { views.mapsAndRemap(run); });
    contest.add("opencv remap, wrapping", [&](int run) { views.remapAlone(run, cv::BORDER_WRAP); });
    contest.add("opencv remap, same map each time", [&](int) { views.remapAlone(0, cv::BORDER_CONSTANT); });
    contest.add("opencv remap", [&](int run) { views.remapAlone(run, cv::BORDER_CONSTANT); });
    for (const Sampling sampling : kRungs) {
        for (const int threads : {1, 2}) {
            contest.add(std::string(name(sampling)) + ", " + std::to_string(threads) + " thread" +
                            (threads > 1 ? "s" : ""),
                        [&views, sampling, threads](int run) { views.ours(sampling, threads, run); });
        }
    }
    contest.run(rounds, clock);
    contest.print();
    for (const auto& [what, value] :
         {std::pair{"medians", &Measured::medianMs}, {"least", &Measured::leastMs}}) {
        const auto of = [&](const char* entry) { return contest.of(entry).*value; };
        const double bilinear = of("bilinear, 1 thread");
        const double footprint = of("footprint, 1 thread");
        const double remap = of("opencv remap");
        const double sameMap = of("opencv remap, same map each time");
        std::printf(
            "  %s: bilinear %.1f x opencv maps + remap, %.2f x opencv remap, %.2f x with the same map; "
            "two threads %.2f x one; footprint %.2f x opencv remap, %.2f x with the same map\n",
            what, of("opencv maps + remap") / bilinear, remap / bilinear, sameMap / bilinear,
            bilinear / of("bilinear, 2 threads"), remap / footprint, sameMap / footprint);
    }
}

void printFidelity(const Source& source, double fieldDeg, int directions) {
    const CameraModel camera(CameraIntrinsics::pinhole(kWidth, kHeight, fieldDeg * std::numbers::pi / 180));
    const std::vector<Fidelity> rungs = fidelity(source, camera, directions);
    std::printf("  %3.0f deg (minification %.2f):", fieldDeg,
                render::minification(camera, source.picture.width()));
    for (std::size_t i = 0; i < kRungs.size(); ++i) {
        std::printf("  %s %.1f / %.1f", std::string(name(kRungs[i])).c_str(), rungs[i].meanDb,
                    rungs[i].worstDb);
    }
    const double ratio = render::minification(camera, source.picture.width());
    std::printf("  auto at 40 dB %s\n",
                std::string(name(render::chosenSampling(Sampling::Auto, ratio, 40))).c_str());
}

int run(const std::vector<std::string>& arguments) {
    int directions = 40;
    int rounds = 100;
    std::vector<double> fields{20, 30, 57, 70, 80, 90, 110};
    std::string photo;
    Clock clock = Clock::Wall;
    for (std::size_t i = 0; i + 1 < arguments.size(); i += 2) {
        const std::string& key = arguments[i];
        const std::string& value = arguments[i + 1];
        if (key == "--photo") {
            photo = value;
        } else if (key == "--directions") {
            directions = std::stoi(value);
        } else if (key == "--rounds") {
            rounds = std::stoi(value);
        } else if (key == "--field") {
            fields = {std::stod(value)};
        } else if (key == "--clock") {
            clock = value == "processor" ? Clock::Processor : Clock::Wall;
        } else {
            throw std::invalid_argument("unknown option " + key);
        }
    }
    RgbImage picture = photo.empty() ? detailedPanorama() : jpeg::decode(readFile(photo, 1 << 28), photo);
    render::PhotoPlane plane(picture);
    render::PhotoPlane half(jpeg::decode(jpeg::encode(picture, 98), "picture", 2));
    const Source source{std::move(picture), std::move(plane), std::move(half)};
    cv::setNumThreads(1);
    std::printf("%d x %d views of %s, %d x %d; build %s, %d processors, SIMD %s, OpenCV %s with one thread; "
                "medians of "
                "%d runs and their median deviation, %s\n",
                kWidth, kHeight, photo.empty() ? "a made-up panorama" : photo.c_str(), source.picture.width(),
                source.picture.height(), SPHEREWALK_BUILD_TYPE, hardwareThreads(),
                hwy::TargetName(hwy::SupportedTargets() & -hwy::SupportedTargets()), CV_VERSION, rounds,
                clock == Clock::Wall ? "wall clock" : "time of all processors together");
    if (rounds > 0) {
        for (const Setting& setting :
             {Setting{57, 0}, Setting{57, 80}, Setting{90, 0}, Setting{90, 40}, Setting{90, 80}}) {
            time(source, setting, rounds, clock);
        }
    }
    if (directions > 0) {
        std::printf("\nfidelity, mean / worst dB over %d directions with pitches to +-80 deg, against 8 x 8 "
                    "samples a pixel\n",
                    directions);
        for (const double field : fields) {
            printFidelity(source, field, directions);
        }
    }
    return 0;
}

} // namespace

} // namespace spherewalk::bench

int main(int count, char** values) {
    try {
        return spherewalk::bench::run({values + 1, values + count});
    } catch (const std::exception& error) {
        std::cerr << "spherewalk_render_bench: " << error.what() << "\n";
        return 1;
    }
}
