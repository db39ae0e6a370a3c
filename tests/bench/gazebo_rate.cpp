// SPDX-License-Identifier: GPL-3.0-or-later
// spherewalk_gazebo_rate SECONDS TOPIC...: counts the pictures of topics while Gazebo runs. Prints of each
// topic the pictures a second of the clock, the simulation's seconds a second between the first picture and
// the last, and how many of the times that are due at 30 Hz had no picture.
#include "messages.h"

#include "spherewalk/base/text.h"

#include <chrono>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <list>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace {

namespace gz = spherewalk::gazebo::msgs;
using Clock = std::chrono::steady_clock;
using spherewalk::simulator::Stamp;

constexpr double kRateHz = 30;

struct Pictures {
    std::string topic;
    std::vector<std::pair<Clock::time_point, Stamp>> all;
};

double seconds(std::chrono::duration<double> duration) {
    return duration.count();
}

std::string row(const Pictures& of) {
    if (of.all.size() < 2) {
        return spherewalk::text(of.topic, ": fewer than two pictures");
    }
    const auto& [firstAt, first] = of.all.front();
    const auto& [lastAt, last] = of.all.back();
    const auto slot = [](Stamp stamp) { return static_cast<long>(seconds(stamp) * kRateHz + 1e-6); };
    const long due = slot(last) - slot(first) + 1;
    return spherewalk::text(
        of.topic, ": ", of.all.size(), " pictures, ",
        spherewalk::fixed(static_cast<double>(of.all.size() - 1) / seconds(lastAt - firstAt), 1),
        " a second; simulation ", spherewalk::fixed(seconds(last - first) / seconds(lastAt - firstAt), 2),
        "; ", due - static_cast<long>(of.all.size()), " of ", due, " left out");
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 3) {
        std::cerr << "spherewalk_gazebo_rate SECONDS TOPIC...\n";
        return 2;
    }
    std::mutex mutex;
    std::list<Pictures> pictures;
    spherewalk::gazebo::transport::Node node; // last: its callbacks use the others
    for (int i = 2; i < argc; ++i) {
        Pictures& of = pictures.emplace_back(Pictures{argv[i], {}});
        std::function<void(const gz::Image&)> count = [&](const gz::Image& image) {
            const std::scoped_lock lock(mutex);
            of.all.emplace_back(Clock::now(), spherewalk::gazebo::stampOf(image.header()));
        };
        node.Subscribe(of.topic, count);
    }
    std::this_thread::sleep_for(std::chrono::duration<double>(std::atof(argv[1])));
    const std::scoped_lock lock(mutex);
    for (const Pictures& of : pictures) {
        std::cout << row(of) << "\n";
    }
    std::cout.flush();
    spherewalk::gazebo::endProgram(0);
}
