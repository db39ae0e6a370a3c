// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench_photo.h"
#include "contest.h"
#include "measurements.h"
#include "opencv_views.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace spherewalk::bench {

using render::Sampling;

namespace {

constexpr int kPoses = 50; // in turns
constexpr int kMostInARow = 10;
// Two roundings to whole grey levels differ by a quarter of one on average.
constexpr double kMostToExact = 0.5;
// OpenCV's fixed point has 1/32 pixel.
constexpr double kMostToOpenCv = 1.5;

std::string entryName(Sampling sampling, int threads) {
    return text(name(sampling), " ", threads);
}

class ViewBench {
  public:
    ViewBench(const BenchPhoto& photo, const ViewSetting& setting, bool peers)
        : m_photo(photo), m_setting(setting), m_camera(standardCamera(setting.fieldDeg)) {
        if (peers) {
            m_openCv.emplace(photo.picture(), m_camera, photo.radiusM());
        }
    }

    /// Renders everything once, so that all of it is in memory, and compares.
    void prepare(const std::stop_token& stop) {
        for (int run = 0; run < kPoses; ++run) {
            throwIfStopped(stop);
            ours(Sampling::Bilinear, 1, run);
            ours(Sampling::Reduced, 1, run);
            if (m_openCv) {
                m_openCv->keepMaps(poseOf(run));
            }
        }
        verify(stop);
        m_isTiming = true;
    }

    const RgbImage& ours(Sampling sampling, int threads, int run) {
        render::ViewOptions options;
        options.scene = m_photo.scene();
        options.sampling = sampling;
        options.threads = threads;
        m_photo.renderer().render(m_camera, m_photo.roomFromCamera(poseOf(run)), options, m_view);
        if (m_isTiming) {
            m_parts[entryName(sampling, threads)].add(m_view.report);
            if (m_view.report.isLate) {
                throw Error(
                    ErrorKind::Internal,
                    "A part of the photo left the memory while views were timed; please report this.");
            }
        }
        return m_view.picture;
    }

    ViewParts parts(Sampling sampling, int threads) const {
        return m_parts.at(entryName(sampling, threads)).median();
    }

    void addPeers(Contest& contest) {
        contest.add(kMapsAndRemap, [this](int run) { m_openCv->mapsAndRemap(poseOf(run)); });
        contest.add(kRemap, [this](int run) { m_openCv->remap(run); });
        contest.add(kRemapSameMap, [this](int) { m_openCv->remap(0); });
    }

  private:
    Rigid3 poseOf(int run) const {
        const int pose = run % kPoses;
        const Eigen::Vector3d aside(0.1, 0.02 * (pose % 5), 0);
        const double share = std::min(1.0, 0.9 * m_photo.freeM() / 0.13);
        return lookingTo(7.3 * pose, m_setting.pitchDeg, share * aside);
    }

    void verify(const std::stop_token& stop) {
        constexpr int kRun = 3;
        render::ViewOptions exact;
        exact.scene = m_photo.scene();
        exact.exact = true;
        const render::View expected =
            m_photo.renderer().render(m_camera, m_photo.roomFromCamera(poseOf(kRun)), exact);
        const std::string where =
            text("the view at ", m_setting.fieldDeg, " degrees, pitched by ", m_setting.pitchDeg);
        requireAlike(ours(Sampling::Bilinear, 1, kRun), expected.picture, kMostToExact,
                     text(where, ", compared with the exact one,"));
        if (m_openCv) {
            requireAlike(m_view.picture, m_openCv->mapsAndRemap(poseOf(kRun)), kMostToOpenCv,
                         text(where, ", compared with OpenCV's,"));
            requireAlike(m_openCv->remap(kRun), m_openCv->mapsAndRemap(poseOf(kRun)), kMostToOpenCv,
                         text(where, ", OpenCV's own with ready maps,"));
        }
        for (const Sampling sampling : kRungs) {
            throwIfStopped(stop);
            const RgbImage alone = ours(sampling, 1, kRun);
            requireSame(ours(sampling, 2, kRun), alone,
                        text(where, ", sampled ", name(sampling), " by two threads,"));
        }
    }

    const BenchPhoto& m_photo;
    ViewSetting m_setting;
    CameraModel m_camera;
    std::optional<OpenCvViews> m_openCv;
    render::View m_view;
    bool m_isTiming = false;
    std::map<std::string, PartsOfViews> m_parts;
};

bool isComparedWithOpenCv(Sampling sampling) {
    return sampling == Sampling::Bilinear || sampling == Sampling::Footprint;
}

BenchRow rowOf(const ViewBench& views, const Contest& contest, const ViewSetting& setting, Sampling sampling,
               int threads) {
    BenchRow row;
    row.name = viewRowName(sampling, setting);
    row.threads = threads;
    row.own = contest.of(entryName(sampling, threads));
    row.view = setting;
    row.parts = views.parts(sampling, threads);
    return row;
}

void addAgainst(const char* peer, const Measured& theirs, BenchRow own, std::vector<BenchRow>& rows) {
    own.peer = {peer, theirs.medianMs};
    rows.push_back(std::move(own));
}

} // namespace

std::string viewRowName(Sampling sampling, const ViewSetting& setting) {
    return text("view.", name(sampling), setting.fieldDeg == 90 ? "" : text(".", setting.fieldDeg),
                setting.pitchDeg == 0 ? "" : ".steep");
}

std::vector<BenchRow> measureViews(const BenchPhoto& photo, const ViewSetting& setting, bool peers,
                                   int rounds, ProgressSink& progress, const std::stop_token& stop) {
    ViewBench views(photo, setting, peers);
    views.prepare(stop);
    Contest contest;
    const int threads = std::min(2, hardwareThreads());
    if (peers) {
        views.addPeers(contest);
    }
    for (const Sampling sampling : kRungs) {
        for (int count = 1; count <= threads; ++count) {
            contest.add(entryName(sampling, count),
                        [&views, sampling, count](int run) { views.ours(sampling, count, run); });
        }
    }
    contest.run(rounds, std::clamp(rounds / 4, 1, kMostInARow), progress,
                text("Timing views at ", setting.fieldDeg, " degrees"), stop);
    std::vector<BenchRow> rows;
    for (const Sampling sampling : kRungs) {
        const BenchRow one = rowOf(views, contest, setting, sampling, 1);
        if (peers && isComparedWithOpenCv(sampling)) {
            for (const char* peer : {kMapsAndRemap, kRemap, kRemapSameMap}) {
                addAgainst(peer, contest.of(peer), one, rows);
            }
        } else {
            rows.push_back(one);
        }
        if (threads > 1) {
            addAgainst(kOneThread, one.own, rowOf(views, contest, setting, sampling, 2), rows);
        }
    }
    return rows;
}

} // namespace spherewalk::bench
