// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/measure_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>

namespace spherewalk::jobs {

namespace {

constexpr double kAboutAsCheap = 1.1;
constexpr std::size_t kLeastPlaces = 40; ///< of a photo, for a scene model of its own
constexpr double kMostStoredPx = 1e6;    ///< what dataset.json takes

std::string wordsOf(const Rung& rung) {
    return text("scene model ", name(rung.scene), " with sampling ", name(rung.sampling));
}

std::string pxText(double px) {
    return text(fixed(px, px < 10 ? 2 : 1), " px");
}

std::vector<Looks> looksIn(const SceneLikeness& scene) {
    std::vector<Looks> looks;
    for (const ViewLikeness& view : scene.views) {
        looks.push_back(view.looks);
    }
    return looks;
}

/// The rungs of scene models that are not passed over.
std::vector<std::size_t> openRungs(const MeasureReport& report, const std::vector<PassedOver>& passed) {
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < report.rungs.size(); ++i) {
        if (std::none_of(passed.begin(), passed.end(),
                         [&](const PassedOver& one) { return one.scene == report.rungs[i].scene; })) {
            open.push_back(i);
        }
    }
    return open;
}

/// The cheapest of those within the tolerance.
std::optional<std::size_t> cheapest(const MeasureReport& report, const std::vector<std::size_t>& open,
                                    double tolerancePx) {
    std::vector<std::size_t> within;
    double least = HUGE_VAL;
    for (const std::size_t i : open) {
        const Rung& rung = report.rungs[i];
        if (rung.errorPx && *rung.errorPx <= tolerancePx) {
            within.push_back(i);
            least = std::min(least, rung.cost());
        }
    }
    std::erase_if(within, [&](std::size_t i) { return report.rungs[i].cost() > kAboutAsCheap * least; });
    const auto best = std::min_element(within.begin(), within.end(), [&](std::size_t a, std::size_t b) {
        const Rung& ra = report.rungs[a];
        const Rung& rb = report.rungs[b];
        return ra.bytes != rb.bytes ? ra.bytes < rb.bytes : *ra.errorPx < *rb.errorPx;
    });
    return best == within.end() ? std::nullopt : std::optional(*best);
}

const SceneLikeness& sceneOf(const MeasureReport& report, const Rung& rung) {
    return *std::find_if(report.scenes.begin(), report.scenes.end(),
                         [&](const SceneLikeness& one) { return one.scene == rung.scene; });
}

/// The one with the least error. Where all are endless, looks decide, with the sampling that was looked at.
std::optional<std::size_t> mostExact(const MeasureReport& report, const std::vector<std::size_t>& open) {
    const auto rank = [&](const Rung& rung) {
        const SceneLikeness& scene = sceneOf(report, rung);
        return std::tuple(*rung.errorPx, -scene.looks.mean.ssim, rung.sampling != scene.sampling,
                          rung.cost());
    };
    std::optional<std::size_t> best;
    for (const std::size_t i : open) {
        if (report.rungs[i].errorPx && (!best || rank(report.rungs[i]) < rank(report.rungs[*best]))) {
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
    double cost = 0;
    double renderMs = 0;
    double ratio = 1; ///< by which the chosen sampling's errors are greater than those found
};

std::vector<Cheaper> cheaperThan(const MeasureReport& report, const Rung& chosen,
                                 const std::vector<PassedOver>& passed) {
    std::vector<Cheaper> result;
    for (const SceneLikeness& scene : report.scenes) {
        const Rung& rung = withSampling(report, scene.scene, chosen.sampling);
        const double errorPx = scene.errorPx(report.places).value_or(0);
        const bool isOpen = std::none_of(passed.begin(), passed.end(),
                                         [&](const PassedOver& one) { return one.scene == scene.scene; });
        if (isOpen && rung.cost() * kAboutAsCheap < chosen.cost() && rung.errorPx && errorPx > 0) {
            const double ratio = std::isfinite(errorPx) ? *rung.errorPx / errorPx : 1;
            result.push_back({&scene, rung.cost(), rung.renderMs, ratio});
        }
    }
    std::stable_sort(result.begin(), result.end(),
                     [](const Cheaper& a, const Cheaper& b) { return a.cost < b.cost; });
    return result;
}

/// Gives photos about which a cheaper scene model is within the tolerance that one.
void choosePhotoScenes(const MeasureReport& report, Choice& choice) {
    const Rung& rung = report.rungs[*choice.rung];
    const std::vector<Cheaper> cheaper = cheaperThan(report, rung, choice.passedOver);
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

/// "reaches 3.2 px", or why there is no such number.
std::string reachWords(const Rung& rung) {
    return std::isfinite(*rung.errorPx) ? text("reaches ", pxText(*rung.errorPx))
                                        : "misses more than 5 of 100 places";
}

std::string reasonWithin(const MeasureReport& report, const Choice& choice) {
    const Rung& rung = report.rungs[*choice.rung];
    std::string reason = text(report.isLeaveOneOut ? "The" : "On the robot's pictures the",
                              " cheapest that holds ", pxText(choice.tolerancePx), " is the ", wordsOf(rung),
                              ": 95 of 100 places are displaced by at most ", pxText(*rung.errorPx), ", in ",
                              fixed(rung.renderMs, 1), " ms a view.");
    const Rung* below = nullptr; // the best of what would be cheaper
    for (const std::size_t i : openRungs(report, choice.passedOver)) {
        const Rung& other = report.rungs[i];
        if (other.cost() < rung.cost() && other.errorPx && *other.errorPx > choice.tolerancePx &&
            (below == nullptr || *other.errorPx < *below->errorPx)) {
            below = &other;
        }
    }
    return below == nullptr ? reason
                            : text(reason, " The best of what is cheaper, the ", wordsOf(*below), " (",
                                   fixed(below->renderMs, 1), " ms), ", reachWords(*below), ".");
}

/// "1.2 +- 0.3" with a unit before.
std::string worseWords(const PairedDifference& worse, double times, int digits) {
    return text(fixed(times * worse.mean, digits), " (the margin is ", fixed(times * worse.margin, digits),
                ")");
}

/// Why a scene model is not chosen.
std::string passedOverWords(const PassedOver& passed) {
    const LooksBeside& looks = passed.looks;
    std::string how;
    if (looks.ssim.isWorse()) {
        how = text("its SSIM is lower by ", worseWords(looks.ssim, 1, 3));
    }
    if (looks.falseEdges.isWorse()) {
        how += text(how.empty() ? "" : ", and ", "its false edges are more by ",
                    worseWords(looks.falseEdges, 100, 1), " percent");
    }
    return text(" The scene model ", name(passed.scene), " is not chosen, because its views look worse than ",
                "those of the cheaper ", name(passed.than), ": in the same ", looks.views, " views ", how,
                ".");
}

} // namespace

double nominalCost(render::SceneKind scene, render::Sampling sampling) {
    // What surfaces add, and the samplings, as resources/docs/figures.md has them.
    constexpr std::array kOfScene{0.0, 0.0, 0.7, 1.5, 7.0}; // none, sphere, room, depth, blend
    constexpr std::array kOfSampling{1.05, 1.0, 0.95, 2.4,
                                     2.6}; // nearest, bilinear, reduced, footprint, bicubic
    return kOfScene.at(static_cast<std::size_t>(scene)) + kOfSampling.at(static_cast<std::size_t>(sampling));
}

std::vector<PassedOver> passedOver(const MeasureReport& report) {
    std::vector<PassedOver> result;
    for (std::size_t i = 0; i < report.scenes.size(); ++i) {
        std::optional<PassedOver> worst;
        for (std::size_t cheaper = 0; cheaper < i; ++cheaper) {
            const auto looks = looksBeside(looksIn(report.scenes[i]), looksIn(report.scenes[cheaper]));
            if (looks && looks->isWorse() && (!worst || looks->ssim.mean > worst->looks.ssim.mean)) {
                worst = {report.scenes[i].scene, report.scenes[cheaper].scene, *looks};
            }
        }
        if (worst) {
            result.push_back(*worst);
        }
    }
    return result;
}

namespace {

void choose(const MeasureReport& report, Choice& choice) {
    const std::vector<std::size_t> open = openRungs(report, choice.passedOver);
    choice.rung = cheapest(report, open, choice.tolerancePx);
    if (choice.rung) {
        choice.isWithin = true;
        choice.reason = reasonWithin(report, choice);
        choosePhotoScenes(report, choice);
        return;
    }
    choice.rung = mostExact(report, open);
    if (!choice.rung) {
        choice.reason = "Nothing could be compared: the pictures have too little in common with the views.";
        return;
    }
    const Rung& best = report.rungs[*choice.rung];
    choice.meanRenderMs = best.renderMs;
    choice.reason =
        text(report.isLeaveOneOut ? "No" : "On the robot's pictures no", " option of this dataset holds ",
             pxText(choice.tolerancePx), " in 95 of 100 places; the best, the ", wordsOf(best), ", ",
             reachWords(best), ". Take photos closer together",
             render::usesDepths(report.scenes.back().scene)
                 ? "."
                 : ", or export the dataset with a richer scene model.");
}

} // namespace

Choice chosen(const MeasureReport& report, double tolerancePx) {
    Choice choice;
    choice.tolerancePx = tolerancePx;
    choice.passedOver = passedOver(report);
    choose(report, choice);
    for (const PassedOver& passed : choice.passedOver) {
        choice.reason += passedOverWords(passed);
    }
    return choice;
}

std::optional<render::ViewChoice> viewChoice(const MeasureReport& report) {
    if (!report.choice.rung) {
        return std::nullopt;
    }
    const Rung& rung = report.rungs[*report.choice.rung];
    return render::ViewChoice{rung.scene,
                              rung.sampling,
                              report.choice.tolerancePx,
                              std::min(*rung.errorPx, kMostStoredPx),
                              report.focalPx,
                              report.choice.reason};
}

} // namespace spherewalk::jobs
