// SPDX-License-Identifier: GPL-3.0-or-later
// spherewalk_gazebo_pace TOPIC LENGTH [SECONDS] [overlay]: stands in for Gazebo at the speed of real time,
// beside a spherewalk-gz that runs with --poses /pace/pose --frame camera --image TOPIC/image --rate 30. The
// camera moves at 1 m/s to and fro between x = 0 and LENGTH and turns. With "overlay", also the pictures of a
// colour camera, a depth camera and a segmentation camera come, as /pace/colour/image, /pace/depth/image,
// /pace/labels/image, with an object on a tenth of the picture. Prints one row of a table: the rate, and the
// milliseconds from publishing a pose to having the whole picture.
#include "messages.h"
#include "published_camera.h"

#include "spherewalk/base/text.h"

#include <chrono>
#include <cmath>
#include <functional>
#include <iostream>
#include <map>
#include <mutex>
#include <string>
#include <thread>

namespace {

namespace gz = spherewalk::gazebo::msgs;
using spherewalk::gazebo::transport::Node;
using Clock = std::chrono::steady_clock;
using spherewalk::simulator::Stamp;

constexpr int kWidth = 640;
constexpr int kHeight = 480;
constexpr double kSpeed = 1; ///< m/s
constexpr auto kStep = std::chrono::milliseconds(4);
constexpr int kRate = 30;

/// The pictures of the object's cameras, of any stamp.
struct Pictures {
    Pictures() {
        fill(colour, gz::RGB_INT8);
        fill(depth, gz::R_FLOAT32);
        fill(labels, gz::RGB_INT8);
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                const bool isObject = std::abs(x - kWidth / 2) < 100 && std::abs(y - kHeight / 2) < 75;
                const float metres = isObject ? 0.5F : 3;
                colour.mutable_data()->append(3, isObject ? '\x50' : '\x00');
                depth.mutable_data()->append(reinterpret_cast<const char*>(&metres), sizeof metres);
                labels.mutable_data()->append(3, isObject ? '\x0a' : '\x01');
            }
        }
    }

    static void fill(gz::Image& image, gz::PixelFormatType format) {
        image.set_width(kWidth);
        image.set_height(kHeight);
        image.set_pixel_format_type(format);
    }

    gz::Image colour;
    gz::Image depth;
    gz::Image labels;
};

/// When poses went out and their pictures came back. Threads: any.
class Stopwatch {
  public:
    void sent(Stamp stamp) {
        const std::scoped_lock lock(m_mutex);
        m_sent[stamp] = Clock::now();
    }

    void received(Stamp stamp) {
        const std::scoped_lock lock(m_mutex);
        if (const auto sent = m_sent.find(stamp); sent != m_sent.end()) {
            m_latencies.add(Clock::now() - sent->second);
            ++m_frames;
        }
    }

    /// What was before does not count.
    void restart() {
        const std::scoped_lock lock(m_mutex);
        m_sent.clear();
        m_latencies = {};
        m_frames = 0;
    }

    std::string row(double seconds) {
        const std::scoped_lock lock(m_mutex);
        const auto ms = [this](double share) { return spherewalk::fixed(m_latencies.quantile(share), 1); };
        return spherewalk::text("| ", spherewalk::fixed(m_frames / seconds, 2), " | ", ms(0.5), " | ",
                                ms(0.99), " | ", ms(1), " |");
    }

  private:
    std::mutex m_mutex;
    std::map<Stamp, Clock::time_point> m_sent;
    spherewalk::gazebo::Latencies m_latencies;
    int m_frames = 0;
};

void setStamp(gz::Header& header, Stamp stamp) {
    spherewalk::gazebo::setHeader(header, stamp, "camera", 0);
}

gz::Pose poseAt(double seconds, double length, Stamp stamp) {
    const double way = std::fmod(kSpeed * seconds, 2 * length);
    gz::Pose pose;
    setStamp(*pose.mutable_header(), stamp);
    pose.set_name("camera");
    pose.mutable_position()->set_x(way < length ? way : 2 * length - way);
    const double yaw = 0.5 * std::sin(0.7 * seconds);
    pose.mutable_orientation()->set_w(std::cos(yaw / 2));
    pose.mutable_orientation()->set_z(std::sin(yaw / 2));
    return pose;
}

/// Whether this step is the first at or after a multiple of 1/rate.
bool isDue(Stamp stamp) {
    const auto slot = [](Stamp at) { return (at.count() * kRate + 30'000) / 1'000'000'000; };
    return stamp.count() == 0 || slot(stamp) > slot(stamp - kStep);
}

void play(const std::string& topic, double length, double seconds, bool withOverlay) {
    Stopwatch stopwatch;
    Pictures pictures;
    Node node;
    auto poses = node.Advertise<gz::Pose>("/pace/pose");
    auto colour = node.Advertise<gz::Image>("/pace/colour/image");
    auto depth = node.Advertise<gz::Image>("/pace/depth/image");
    auto labels = node.Advertise<gz::Image>("/pace/labels/image");
    std::function<void(const gz::Image&)> take = [&](const gz::Image& image) {
        stopwatch.received(spherewalk::gazebo::stampOf(image.header()));
    };
    node.Subscribe(topic + "/image", take);
    constexpr double kWarmUpS = 3;
    bool isWarm = false;
    const auto begin = Clock::now();
    for (Stamp stamp{}; std::chrono::duration<double>(stamp).count() < kWarmUpS + seconds; stamp += kStep) {
        std::this_thread::sleep_until(begin + stamp);
        const double now = std::chrono::duration<double>(stamp).count();
        if (!isWarm && now >= kWarmUpS) {
            stopwatch.restart();
            isWarm = true;
        }
        stopwatch.sent(stamp);
        poses.Publish(poseAt(now, length, stamp));
        if (withOverlay && isDue(stamp)) {
            for (auto* each : {&pictures.colour, &pictures.depth, &pictures.labels}) {
                setStamp(*each->mutable_header(), stamp);
            }
            colour.Publish(pictures.colour);
            depth.Publish(pictures.depth);
            labels.Publish(pictures.labels);
        }
    }
    std::this_thread::sleep_for(std::chrono::seconds(1));
    node.Unsubscribe(topic + "/image");
    std::cout << stopwatch.row(seconds) << "\n";
}

} // namespace

int main(int count, char** values) {
    if (count < 3) {
        std::cerr << "spherewalk_gazebo_pace TOPIC LENGTH [SECONDS] [overlay]\n";
        return 2;
    }
    play(values[1], std::stod(values[2]), count > 3 ? std::stod(values[3]) : 30,
         count > 4 && std::string(values[4]) == "overlay");
    std::cout.flush();
    spherewalk::gazebo::endProgram(0);
}
