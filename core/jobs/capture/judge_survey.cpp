// SPDX-License-Identifier: GPL-3.0-or-later

#include "spherewalk/jobs/judge_survey.h"

#include "capture/photo_judge.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

namespace spherewalk::jobs {

namespace {

constexpr double kSameHeightM = 0.1;
constexpr double kReachSteps = 1.5;

/// What stands about a photo, and what is to be done about it.
struct Standing {
    store::PhotoRecord photo;
    store::Review review;
    std::optional<store::PhotoVerdict> verdict;

    bool isRejected() const { return review.decision == store::Decision::Rejected; }

    bool isGood() const {
        return !isRejected() && (review.decision == store::Decision::Accepted || !verdict ||
                                 verdict->quality == survey::Quality::Good);
    }
};

std::vector<Standing> standings(const store::SurveyStore& store) {
    std::vector<Standing> result;
    for (store::PhotoRecord& photo : store.chosenPhotos()) {
        const std::int64_t id = photo.id;
        result.push_back({std::move(photo), store.review(id), store.verdict(id)});
    }
    return result;
}

std::string reason(const Standing& standing) {
    if (standing.isRejected()) {
        return standing.review.note.empty() ? "It was rejected." : standing.review.note;
    }
    return verdictOf(*standing.verdict).sentence();
}

/// Range: directions in radians.
bool leavesNoHalfEmpty(std::vector<double> directions) {
    constexpr double kSlack = 0.05; // stops are a little off their line
    if (directions.size() < 2) {
        return false;
    }
    std::ranges::sort(directions);
    double widest = directions.front() + 2 * std::numbers::pi - directions.back();
    for (std::size_t i = 1; i < directions.size(); ++i) {
        widest = std::max(widest, directions[i] - directions[i - 1]);
    }
    return widest <= std::numbers::pi + kSlack;
}

bool isSurrounded(const Standing& of, const std::vector<Standing>& all, double reachM) {
    std::vector<double> directions;
    for (const Standing& other : all) {
        const Eigen::Vector3d offset = other.photo.positionM - of.photo.positionM;
        const double distance = offset.head<2>().norm();
        const bool isElsewhere = other.photo.station != of.photo.station && distance > 1e-3;
        if (isElsewhere && other.isGood() && distance <= reachM && std::abs(offset.z()) <= kSameHeightM) {
            directions.push_back(std::atan2(offset.y(), offset.x()));
        }
    }
    return leavesNoHalfEmpty(std::move(directions));
}

} // namespace

photo::Verdict verdictOf(const store::PhotoVerdict& record) {
    const std::string source = text("the findings on photo ", static_cast<long long>(record.photo));
    const Json json = parseJson(record.findings, source);
    const JsonReader reader(json, source);
    photo::Verdict verdict;
    for (std::size_t i = 0; i < reader.arraySize(); ++i) {
        const JsonReader one = reader.element(i);
        try {
            verdict.findings.push_back({photo::flawNamed(one.string("flaw")),
                                        survey::qualityNamed(one.string("quality")), one.string("sentence")});
        } catch (const Error& error) {
            one.fail(error.sentence());
        }
    }
    return verdict;
}

JudgeReport judgeSurvey(store::SurveyStore& store, bool all, ProgressSink& progress,
                        const std::stop_token& stop) {
    std::vector<std::int64_t> photos;
    std::set<std::int64_t> judged;
    for (const store::PhotoVerdict& verdict : store.verdicts()) {
        judged.insert(verdict.photo);
    }
    for (const store::PhotoRecord& photo : store.photos()) {
        if (all || !judged.contains(photo.id)) {
            photos.push_back(photo.id);
        }
    }
    SharedStore shared(store);
    PhotoJudge judge(shared);
    JudgeReport report;
    for (const std::int64_t photo : photos) {
        throwIfStopped(stop);
        progress.progress(static_cast<double>(report.judged) / static_cast<double>(photos.size()),
                          text("Judging photo ", report.judged + 1, " of ", photos.size()));
        const photo::Verdict verdict = judge.judge(photo, stop);
        const survey::Quality quality = verdict.quality();
        report.notCompared += verdict.isCompared ? 0 : 1;
        report.contentNotCompared += verdict.isContentCompared ? 0 : 1;
        ++report.judged;
        ++(quality == survey::Quality::Good       ? report.good
           : quality == survey::Quality::Doubtful ? report.doubtful
                                                  : report.failed);
    }
    return report;
}

Json toJson(const JudgeReport& report) {
    return {{"judged", report.judged},
            {"good", report.good},
            {"doubtful", report.doubtful},
            {"failed", report.failed},
            {"not_compared", report.notCompared},
            {"content_not_compared", report.contentNotCompared}};
}

std::string notComparedText(int photos, int notCompared, int contentNotCompared) {
    std::string words;
    if (contentNotCompared > 0) {
        words = text("Persons were not looked for in ", contentNotCompared, " of ", photos,
                     " photos yet, because no three others stood within ",
                     fixed(100 * photo::kContentNeighbourhoodM, 0), " cm; align looks for them.");
    }
    if (notCompared > 0) {
        words += text(words.empty() ? "" : " ", "Light and colour of ", notCompared,
                      " photos were compared with none, because no other stood within ",
                      fixed(100 * photo::kNeighbourhoodM, 0), " cm.");
    }
    return words;
}

std::vector<Retake> retakes(const store::SurveyStore& store) {
    const std::vector<Standing> all = standings(store);
    const double reachM = kReachSteps * store.planOptions().stepM;
    std::vector<Retake> result;
    for (const Standing& standing : all) {
        if (standing.isGood()) {
            continue;
        }
        const bool isFailed = standing.isRejected() || standing.verdict->quality == survey::Quality::Failed;
        result.push_back({store.station(standing.photo.station), isFailed,
                          isSurrounded(standing, all, reachM), reason(standing)});
    }
    return result;
}

Json toJson(const std::vector<Retake>& retakes) {
    Json result = Json::array();
    for (const Retake& retake : retakes) {
        result.push_back({{"station", retake.station.name},
                          {"standing", retake.isFailed ? "failed" : "doubtful"},
                          {"leaves_hole", !retake.isSurrounded},
                          {"sentence", retake.sentence}});
    }
    return result;
}

} // namespace spherewalk::jobs
