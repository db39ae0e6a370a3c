// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/measure_report.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace spherewalk::jobs {

namespace {

constexpr double kAboutAsFast = 1.1;
constexpr std::size_t kLeastPlaces = 40; ///< of a photo, for a scene model of its own

std::string wordsOf(const Rung& rung) {
    return text("scene model ", name(rung.scene), " with sampling ", name(rung.sampling));
}

std::string pxText(double px) {
    return text(fixed(px, px < 10 ? 2 : 1), " px");
}

/// The cheapest of those within the tolerance.
std::optional<std::size_t> cheapest(const MeasureReport& report, double tolerancePx) {
    std::vector<std::size_t> within;
    double leastMs = HUGE_VAL;
    for (std::size_t i = 0; i < report.rungs.size(); ++i) {
        const Rung& rung = report.rungs[i];
        if (rung.errorPx && *rung.errorPx <= tolerancePx) {
            within.push_back(i);
            leastMs = std::min(leastMs, rung.renderMs);
        }
    }
    std::erase_if(within, [&](std::size_t i) { return report.rungs[i].renderMs > kAboutAsFast * leastMs; });
    const auto best = std::min_element(within.begin(), within.end(), [&](std::size_t a, std::size_t b) {
        const Rung& ra = report.rungs[a];
        const Rung& rb = report.rungs[b];
        return ra.bytes != rb.bytes ? ra.bytes < rb.bytes : ra.renderMs < rb.renderMs;
    });
    return best == within.end() ? std::nullopt : std::optional(*best);
}

std::optional<std::size_t> mostExact(const MeasureReport& report) {
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < report.rungs.size(); ++i) {
        const std::optional<double>& errorPx = report.rungs[i].errorPx;
        if (errorPx && (!best || *errorPx < *report.rungs[*best].errorPx)) {
            best = i;
        }
    }
    return best;
}

const Rung& withSampling(const MeasureReport& report, render::SceneKind scene, render::Sampling sampling) {
    return *std::find_if(report.rungs.begin(), report.rungs.end(),
                         [&](const Rung& rung) { return rung.scene == scene && rung.sampling == sampling; });
}

/// A scene model and its errors with the chosen sampling.
struct Cheaper {
    const SceneLikeness* scene = nullptr;
    double renderMs = 0;
    double ratio = 1; ///< by which the chosen sampling's errors are greater than those found
};

std::vector<Cheaper> cheaperThan(const MeasureReport& report, const Rung& chosen) {
    std::vector<Cheaper> result;
    for (const SceneLikeness& scene : report.scenes) {
        const Rung& rung = withSampling(report, scene.scene, chosen.sampling);
        const double errorPx = scene.errorPx(report.places).value_or(0);
        if (rung.renderMs * kAboutAsFast < chosen.renderMs && rung.errorPx && errorPx > 0) {
            result.push_back({&scene, rung.renderMs, *rung.errorPx / errorPx});
        }
    }
    std::stable_sort(result.begin(), result.end(),
                     [](const Cheaper& a, const Cheaper& b) { return a.renderMs < b.renderMs; });
    return result;
}

/// Gives photos about which a cheaper scene model is within the tolerance that one.
void choosePhotoScenes(const MeasureReport& report, Choice& choice) {
    const Rung& rung = report.rungs[*choice.rung];
    const std::vector<Cheaper> cheaper = cheaperThan(report, rung);
    std::vector<std::optional<render::SceneKind>> scenes(report.photos);
    std::vector<double> ms(report.photos, rung.renderMs);
    std::size_t given = 0;
    for (const Cheaper& one : cheaper) {
        for (const PhotoError& photo : one.scene->photos) {
            if (!scenes[photo.photo] && photo.p95Px && photo.places >= kLeastPlaces &&
                *photo.p95Px * one.ratio <= choice.tolerancePx) {
                scenes[photo.photo] = one.scene->scene;
                ms[photo.photo] = one.renderMs;
                ++given;
            }
        }
    }
    choice.meanRenderMs = std::accumulate(ms.begin(), ms.end(), 0.0) / static_cast<double>(ms.size());
    if (given == 0) {
        return;
    }
    choice.photoScenes = std::move(scenes);
    choice.reason += text(" About ", given, " of ", report.photos,
                          " photos a cheaper scene model is enough: with it there, a view takes ",
                          fixed(choice.meanRenderMs, 1), " ms on average.");
}

std::string reasonWithin(const MeasureReport& report, const Choice& choice) {
    const Rung& rung = report.rungs[*choice.rung];
    std::string reason = text(report.isLeaveOneOut ? "The" : "On the robot's pictures the",
                              " cheapest that holds ", pxText(choice.tolerancePx), " is the ", wordsOf(rung),
                              ": 95 of 100 places are displaced by at most ", pxText(*rung.errorPx), ", in ",
                              fixed(rung.renderMs, 1), " ms a view.");
    const Rung* below = nullptr; // the best of what would be cheaper
    for (const Rung& other : report.rungs) {
        if (other.renderMs < rung.renderMs && other.errorPx && *other.errorPx > choice.tolerancePx &&
            (below == nullptr || *other.errorPx < *below->errorPx)) {
            below = &other;
        }
    }
    return below == nullptr ? reason
                            : text(reason, " The best of what is cheaper, the ", wordsOf(*below), " (",
                                   fixed(below->renderMs, 1), " ms), reaches ", pxText(*below->errorPx), ".");
}

} // namespace

Choice chosen(const MeasureReport& report, double tolerancePx) {
    Choice choice;
    choice.tolerancePx = tolerancePx;
    choice.rung = cheapest(report, tolerancePx);
    if (choice.rung) {
        choice.isWithin = true;
        choice.reason = reasonWithin(report, choice);
        choosePhotoScenes(report, choice);
        return choice;
    }
    choice.rung = mostExact(report);
    if (!choice.rung) {
        choice.reason = "Nothing could be compared: the pictures have too little in common with the views.";
        return choice;
    }
    const Rung& best = report.rungs[*choice.rung];
    choice.meanRenderMs = best.renderMs;
    choice.reason =
        text(report.isLeaveOneOut ? "No" : "On the robot's pictures no", " option of this dataset holds ",
             pxText(tolerancePx), "; the best, the ", wordsOf(best), ", reaches ", pxText(*best.errorPx),
             " in 95 of 100 places. Take photos closer together",
             report.scenes.back().scene == render::SceneKind::Depth
                 ? "."
                 : ", or export the dataset with a richer scene model.");
    return choice;
}

std::optional<render::ViewChoice> viewChoice(const MeasureReport& report) {
    if (!report.choice.rung) {
        return std::nullopt;
    }
    const Rung& rung = report.rungs[*report.choice.rung];
    return render::ViewChoice{rung.scene,    rung.sampling,  report.choice.tolerancePx,
                              *rung.errorPx, report.focalPx, report.choice.reason};
}

} // namespace spherewalk::jobs
