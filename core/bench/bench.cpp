// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/measure/bench.h"

#include "cold_cell.h"
#include "decode_bench.h"
#include "effort.h"
#include "extras_bench.h"
#include "fidelity.h"
#include "machine.h"
#include "opencv_views.h"
#include "photo_row.h"
#include "scene_bench.h"
#include "view_bench.h"
#include "walk_bench.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace spherewalk::measure {

namespace {

constexpr int kMostCopies = 10000;
constexpr double kSteepDeg = 80;

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
        m_report.walkedPast = {m_walked->info().photos.size(), walkLengthM(*m_walked), m_copies.has_value()};
    }

    void measureMemory() {
        ProgressStep step(m_progress, 0.05, 0.15);
        m_report.residence.photos =
            lookAllRound(m_walked, static_cast<std::size_t>(m_effort.photosAllRound), step, m_stop);
        m_report.residence.peakBytes = peakResidentBytes();
    }

    void measurePhoto() {
        const Subject subject(m_dataset);
        describe(subject);
        ProgressStep decoding(m_progress, 0.15, 0.2);
        append(measureDecoding(subject, m_options.peers, m_effort.decodeRounds, decoding, m_stop));
        ProgressStep cold(m_progress, 0.2, 0.25);
        ColdCells cells = measureColdCells(m_walked, m_effort.coldViews, cold, m_stop);
        append(std::move(cells.rows));
        m_report.coldFilesDropped = cells.filesDropped;
        measureViewsOf(subject);
        measureFidelityOf(subject);
    }

    void describe(const Subject& subject) {
        const render::DatasetPhoto& photo = subject.photo();
        const CameraModel camera = standardCamera(90);
        m_report.measurand = {
            m_dataset->info().name, m_dataset->info().photos.size(), photo.width,    photo.height,
            photo.sizeBytes,        !photo.restartIndex.empty(),     camera.width(), camera.height()};
    }

    void measureViewsOf(const Subject& subject) {
        double begin = 0.25;
        for (const ViewSetting& setting : {ViewSetting{90, 0}, ViewSetting{90, kSteepDeg}, ViewSetting{57, 0},
                                           ViewSetting{57, kSteepDeg}}) {
            ProgressStep step(m_progress, begin, begin + 0.04);
            append(measureViews(subject, setting, m_options.peers, m_effort.viewRounds, step, m_stop));
            begin += 0.04;
        }
        ProgressStep step(m_progress, 0.41, 0.42);
        append(measureExtras(subject, m_effort.viewRounds, step, m_stop));
        append(measureScenes(subject, m_effort.viewRounds, step, m_stop));
    }

    void measureFidelityOf(const Subject& subject) {
        m_report.directions = m_effort.directions;
        const std::size_t count = m_options.fieldsDeg.size();
        for (std::size_t i = 0; i < count; ++i) {
            const double share = 0.23 / static_cast<double>(count);
            ProgressStep step(m_progress, 0.42 + share * static_cast<double>(i),
                              0.42 + share * static_cast<double>(i + 1));
            for (const RungFidelity& rung :
                 measureFidelity(subject, m_options.fieldsDeg[i], {m_effort.directions, m_effort.pixelStep},
                                 step, m_stop)) {
                m_report.fidelity.push_back(rung);
            }
        }
    }

    void measureSearches() {
        double begin = 0.65;
        for (const render::LatticeSearch search : render::kLatticeSearches) {
            ProgressStep step(m_progress, begin, begin + 0.025);
            m_report.lattice.push_back(
                {search, render::searchLattice(search, m_effort.latticeEvery, step, m_stop)});
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

const BenchRow* BenchReport::find(const std::string& name, int threads, const std::string& peer) const {
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const BenchRow& row) {
        return row.name == name && row.threads == threads &&
               (peer.empty() || (row.peer && row.peer->name == peer));
    });
    return found == rows.end() ? nullptr : &*found;
}

} // namespace spherewalk::measure
