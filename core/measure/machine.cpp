// SPDX-License-Identifier: GPL-3.0-or-later
#include "machine.h"

#include "contest.h"

#include "spherewalk/base/parallel.h"
#include "spherewalk/base/text.h"
#include "spherewalk/render/simd_target.h"

#include <fstream>
#include <string_view>
#include <sys/resource.h>
#include <sys/utsname.h>

namespace spherewalk::measure {

namespace {

/// What follows the colon of the first line of the file that begins with the key; "" if there is none.
std::string lineOf(const char* file, std::string_view key) {
    std::ifstream lines(file);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t colon = line.find(':');
        if (line.starts_with(key) && colon != std::string::npos) {
            const std::size_t begin = line.find_first_not_of(" \t", colon + 1);
            return begin == std::string::npos ? "" : line.substr(begin);
        }
    }
    return "";
}

std::string processorName() {
    const std::string name = lineOf("/proc/cpuinfo", "model name");
    utsname system{};
    return !name.empty() ? printable(name) : ::uname(&system) == 0 ? system.machine : "unknown";
}

double twoThreadGain(const std::stop_token& stop) {
    const auto arithmetic = [](int, int) {
        volatile double value = 1;
        for (int i = 0; i < 1'500'000; ++i) {
            value = value * 1.0000001;
        }
    };
    Contest contest;
    for (const int threads : {1, 2}) {
        contest.add(std::to_string(threads), [=](int) { parallelFor(2, 1, threads, arithmetic); });
    }
    contest.run(7, 1, noProgress(), "", stop);
    return contest.of("1").medianMs / contest.of("2").medianMs;
}

std::string compilerName() {
#if defined(__clang__)
    return "clang " __clang_version__;
#elif defined(__GNUC__)
    return "GCC " __VERSION__;
#else
    return "unknown";
#endif
}

} // namespace

Machine thisMachine(const std::stop_token& stop) {
    Machine machine;
    machine.processor = processorName();
    machine.threads = hardwareThreads();
    machine.simd = render::simdTarget();
    machine.buildType = SPHEREWALK_BUILD_TYPE;
    machine.compiler = compilerName();
    machine.version = SPHEREWALK_VERSION;
    machine.twoThreadGain = twoThreadGain(stop);
    return machine;
}

std::uint64_t peakResidentBytes() {
    // getrusage() counts what this process was before it became this program, too.
    const std::string line = lineOf("/proc/self/status", "VmHWM");
    if (const auto kilobytes = parseNumber(line.substr(0, line.find(' ')))) {
        return static_cast<std::uint64_t>(*kilobytes) * 1024;
    }
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

} // namespace spherewalk::measure
