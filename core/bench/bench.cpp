// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/bench/bench.h"

#include "contest.h"
#include "measurements.h"
#include "opencv_views.h"
#include "walk_path.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/base/text.h"
#include "spherewalk/render/renderer.h"

#include <climits>

#include <algorithm>
#include <fstream>
#include <optional>
#include <string_view>
#include <sys/resource.h>
#include <sys/utsname.h>
#include <utility>

namespace spherewalk::bench {

namespace {

constexpr int kMostCopies = 10000;
constexpr double kSteepDeg = 80;

/// How often things are measured.
struct Effort {
    int viewRounds = 100;
    int decodeRounds = 15;
    int coldViews = 40;
    int directions = 40;  ///< Fidelity is measured in so many directions.
    int pixelStep = 1;    ///< Fidelity compares every pixelStep-th pixel along each axis.
    int latticeEvery = 1; ///< The lattice searches make every latticeEvery-th of their views.
    std::vector<double> speedsMS{1, 2, 5, 10, 15, 20};
    int walkViews = 90;
    int photosAllRound = INT_MAX;

    static Effort quick() { return {10, 3, 8, 4, 4, 11, {1, 5, 10}, 20, 12}; }
};

/// The steps of a run, each with its share of the time.
class Bench {
  public:
    Bench(std::shared_ptr<const render::Dataset> dataset, const BenchOptions& options, ProgressSink& progress,
          std::stop_token stop)
        : m_dataset(std::move(dataset)),
          m_options(options),
          m_effort(options.quick ? Effort::quick() : Effort{}),
          m_progress(progress),
          m_stop(std::move(stop)) {}

    BenchReport run() {
        m_report.quick = m_options.quick;
        m_report.machine = thisMachine(m_stop);
        m_report.machine.peerVersion = m_options.peers ? text("OpenCV ", OpenCvViews::version()) : "";
        preparePath();
        measureMemory(); // first, since it is the peak of all that was before
        measurePhoto();
        measureSearches();
        auto step = ProgressStep(m_progress, 0.75, 1);
        m_report.walk = measureWalks(m_walked, {m_effort.speedsMS, m_effort.walkViews}, step, m_stop);
        return std::move(m_report);
    }

  private:
    void preparePath() {
        m_walked = m_dataset;
        if (m_options.gridPhotos > 0) {
            ProgressStep step(m_progress, 0, 0.05);
            m_copies.emplace(*m_dataset, m_options.gridPhotos, step, m_stop);
            m_walked = m_copies->dataset();
        }
        m_report.walkedPast = {m_walked->info().photos.size(),
                               StationPath(serpentine(m_walked->info())).lengthM(), m_copies.has_value()};
    }

    void measureMemory() {
        ProgressStep step(m_progress, 0.05, 0.15);
        m_report.residence.photos =
            lookAllRound(m_walked, static_cast<std::size_t>(m_effort.photosAllRound), step, m_stop);
        m_report.residence.peakBytes = peakResidentBytes();
    }

    void measurePhoto() {
        const BenchPhoto photo(m_dataset);
        describe(photo);
        ProgressStep decoding(m_progress, 0.15, 0.2);
        append(measureDecoding(photo, m_options.peers, m_effort.decodeRounds, decoding, m_stop));
        ProgressStep cold(m_progress, 0.2, 0.25);
        ColdCells cells = measureColdCells(m_walked, m_effort.coldViews, cold, m_stop);
        append(std::move(cells.rows));
        m_report.coldFilesDropped = cells.filesDropped;
        measureViewsOf(photo);
        measureFidelityOf(photo);
    }

    void describe(const BenchPhoto& photo) {
        const render::DatasetPhoto& entry = photo.entry();
        const CameraModel camera = standardCamera(90);
        m_report.measurand = {
            m_dataset->info().name, m_dataset->info().photos.size(), entry.width,    entry.height,
            entry.sizeBytes,        !entry.restartIndex.empty(),     camera.width(), camera.height()};
    }

    void measureViewsOf(const BenchPhoto& photo) {
        double begin = 0.25;
        for (const ViewSetting& setting : {ViewSetting{90, 0}, ViewSetting{90, kSteepDeg}, ViewSetting{57, 0},
                                           ViewSetting{57, kSteepDeg}}) {
            ProgressStep step(m_progress, begin, begin + 0.04);
            append(measureViews(photo, setting, m_options.peers, m_effort.viewRounds, step, m_stop));
            begin += 0.04;
        }
        ProgressStep step(m_progress, 0.41, 0.42);
        append(measureExtras(photo, m_effort.viewRounds, step, m_stop));
        append(measureScenes(photo, m_effort.viewRounds, step, m_stop));
    }

    void measureFidelityOf(const BenchPhoto& photo) {
        m_report.directions = m_effort.directions;
        const std::size_t count = m_options.fieldsDeg.size();
        for (std::size_t i = 0; i < count; ++i) {
            const double share = 0.23 / static_cast<double>(count);
            ProgressStep step(m_progress, 0.42 + share * static_cast<double>(i),
                              0.42 + share * static_cast<double>(i + 1));
            for (const RungFidelity& rung :
                 measureFidelity(photo, m_options.fieldsDeg[i], {m_effort.directions, m_effort.pixelStep},
                                 step, m_stop)) {
                m_report.fidelity.push_back(rung);
            }
        }
    }

    void measureSearches() {
        double begin = 0.65;
        for (const LatticeSearch search : kLatticeSearches) {
            ProgressStep step(m_progress, begin, begin + 0.025);
            m_report.lattice.push_back({search, searchLattice(search, m_effort.latticeEvery, step, m_stop)});
            begin += 0.025;
        }
    }

    void append(std::vector<BenchRow> rows) {
        m_report.rows.insert(m_report.rows.end(), rows.begin(), rows.end());
    }

    std::shared_ptr<const render::Dataset> m_dataset;
    const BenchOptions& m_options;
    Effort m_effort;
    ProgressSink& m_progress;
    std::stop_token m_stop;
    std::optional<PhotoRow> m_copies;
    std::shared_ptr<const render::Dataset> m_walked; ///< the dataset, or the copies
    BenchReport m_report;
};

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

void BenchOptions::validate() const {
    if (gridPhotos < 0 || gridPhotos > kMostCopies) {
        throw Error(ErrorKind::InvalidInput, text("A walk can go past 1 to ", kMostCopies,
                                                  " copies of a photo, not ", gridPhotos, "."));
    }
    for (const double field : fieldsDeg) {
        if (!(field >= 1 && field <= 170)) {
            throw Error(ErrorKind::InvalidInput,
                        text("The errors of views can be measured at fields of view from 1 to 170 degrees, "
                             "not at ",
                             field, "."));
        }
    }
}

BenchReport bench(const std::shared_ptr<const render::Dataset>& dataset, const BenchOptions& options,
                  ProgressSink& progress, const std::stop_token& stop) {
    options.validate();
    return Bench(dataset, options, progress, stop).run();
}

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

} // namespace spherewalk::bench
