// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture/photo_judge.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/base/text.h"
#include "spherewalk/survey/plan.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <set>
#include <utility>

namespace spherewalk::jobs {

namespace {

constexpr std::size_t kMostSketches = 1000; ///< 55 kB each
/// Photos by hand follow each other about so far apart. It is taken for a little more, so that nothing is
/// asked of them that needs to know it better.
constexpr double kFollowingM = 1.2 * survey::kStepByHandM;
static_assert(kFollowingM < photo::kNeighbourhoodM && kFollowingM > photo::kContentNeighbourhoodM);

photo::ExpectedSettings expectedBy(const std::optional<survey::CaptureProfile>& profile) {
    photo::ExpectedSettings expected;
    if (profile) {
        expected.iso = profile->iso;
        expected.exposureS = profile->shutterS;
        expected.width = profile->photoWidth;
        expected.hasFixedWhiteBalance =
            profile->whiteBalance != survey::WhiteBalance::Auto || profile->colourTemperatureK.has_value();
    }
    return expected;
}

bool isUsable(const store::SurveyStore& store, std::int64_t photo) {
    const auto verdict = store.verdict(photo);
    return !verdict || verdict->quality != survey::Quality::Failed ||
           store.review(photo).decision == store::Decision::Accepted;
}

} // namespace

store::PhotoVerdict recordOf(std::int64_t photo, const photo::Verdict& verdict) {
    Json findings = Json::array();
    for (const photo::Finding& finding : verdict.findings) {
        findings.push_back({{"flaw", name(finding.flaw)},
                            {"quality", name(finding.quality)},
                            {"sentence", finding.sentence}});
    }
    return {photo, verdict.quality(), findings.dump()};
}

PhotoJudge::PhotoJudge(SharedStore& store) : m_store(store) {
    store.use([this](const store::SurveyStore& open) {
        m_expected = expectedBy(open.captureProfile());
        m_folder = open.photoFolder();
    });
}

std::vector<PhotoJudge::Near> PhotoJudge::neighbours(const store::PhotoRecord& of) const {
    return m_store.use([&](const store::SurveyStore& store) {
        std::set<std::int64_t> unknown; // stations
        for (const store::StationRecord& station : store.stations()) {
            if (!station.isPlaceKnown) {
                unknown.insert(station.id);
            }
        }
        const bool isByHand = unknown.contains(of.station);
        std::vector<Near> all;
        for (store::PhotoRecord& other : store.keptPhotos()) {
            if (other.station != of.station && unknown.contains(other.station) == isByHand) {
                const double distanceM = isByHand
                                             ? kFollowingM * static_cast<double>(std::abs(other.id - of.id))
                                             : (other.positionM - of.positionM).norm();
                all.push_back({std::move(other), distanceM});
            }
        }
        std::ranges::stable_sort(all, {}, &Near::distanceM);
        std::vector<Near> near;
        for (Near& other : all) {
            if (near.size() < photo::kMostNeighbours + photo::kMostAround &&
                isUsable(store, other.photo.id)) {
                near.push_back(std::move(other));
            }
        }
        return near;
    });
}

bool PhotoJudge::isEarly(const std::vector<Near>& beside) {
    return beside.size() < 2 || beside.front().distanceM > photo::kNeighbourhoodM;
}

std::shared_ptr<const photo::Sketch> PhotoJudge::keep(std::int64_t photo, photo::Sketch sketch) {
    const auto kept = std::make_shared<const photo::Sketch>(std::move(sketch));
    m_sketches.insert_or_assign(photo, kept);
    if (m_sketches.size() > kMostSketches) {
        m_sketches.erase(m_sketches.begin()); // of the photo that came first
    }
    return kept;
}

std::shared_ptr<const photo::Sketch> PhotoJudge::sketchOf(const store::PhotoRecord& photo) {
    if (const auto found = m_sketches.find(photo.id); found != m_sketches.end()) {
        return found->second;
    }
    try {
        const Bytes jpeg = readFile(m_folder / photo.fileName);
        return keep(photo.id, photo::sketch(jpeg, photo::readMetadata(jpeg, photo.fileName), photo.fileName));
    } catch (const Error&) { // its own verdict, and the check of the survey, tell of it
        return nullptr;
    }
}

std::optional<PhotoJudge::Standing> PhotoJudge::standingOf(const store::PhotoRecord& photo) const {
    try {
        return Standing{photo, photo::viewBand(readFile(m_folder / photo.fileName), photo.fileName)};
    } catch (const Error&) { // as in sketchOf()
        return std::nullopt;
    }
}

void PhotoJudge::tellIfUnmoved(Standing standing, photo::Verdict& verdict) {
    constexpr double kStepM = 0.05;
    std::optional<store::PhotoRecord> last;
    for (store::PhotoRecord& other :
         m_store.use([](const store::SurveyStore& store) { return store.photos(); })) {
        if (other.id < standing.photo.id && (!last || other.id > last->id)) {
            last = std::move(other);
        }
    }
    if (last && (!m_latest || m_latest->photo.id != last->id)) {
        m_latest = standingOf(*last);
    }
    const std::optional<Standing> before = std::exchange(m_latest, std::move(standing));
    const bool isPlaced = m_store.use(
        [&](const store::SurveyStore& store) { return store.station(m_latest->photo.station).isPlaceKnown; });
    const bool isElsewhere = isPlaced && last && before && before->photo.station != m_latest->photo.station &&
                             (before->photo.positionM - m_latest->photo.positionM).norm() > kStepM;
    if (isElsewhere && photo::isSameView(m_latest->band, before->band).value_or(false)) {
        verdict.findings.push_back({photo::Flaw::Unmoved, survey::Quality::Doubtful,
                                    text("It shows the same as ", before->photo.fileName,
                                         ", from the same place: the camera was not moved in between; retake "
                                         "the one whose station is wrong.")});
    }
}

photo::JudgedPhoto PhotoJudge::judged(const store::PhotoRecord& photo,
                                      std::span<const photo::Neighbour> near) const {
    try {
        return photo::judgeJpeg(readFile(m_folder / photo.fileName), photo.fileName, m_expected, near);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::NotFound) {
            throw;
        }
        return {{{{photo::Flaw::Damaged, survey::Quality::Failed, error.sentence()}}},
                std::nullopt,
                std::nullopt};
    }
}

photo::JudgedPhoto PhotoJudge::judgedBeside(const store::PhotoRecord& photo, const std::vector<Near>& beside,
                                            const std::stop_token& stop) {
    std::vector<std::shared_ptr<const photo::Sketch>> sketches;
    std::vector<photo::Neighbour> near;
    for (const auto& [other, distanceM] : beside) {
        throwIfStopped(stop);
        if (auto sketch = sketchOf(other)) {
            near.push_back({sketch.get(), distanceM, other.fileName});
            sketches.push_back(std::move(sketch));
        }
    }
    throwIfStopped(stop);
    photo::JudgedPhoto result = judged(photo, near);
    if (result.sketch) {
        keep(photo.id, std::move(*result.sketch));
    }
    return result;
}

/// Judges those photos again that were judged too early, and are no longer alone.
void PhotoJudge::judgeEarlyAgain(const std::vector<Near>& photos, const std::stop_token& stop) {
    for (const Near& near : photos) {
        const store::PhotoRecord& record = near.photo;
        const auto early = m_early.find(record.id);
        if (early == m_early.end()) {
            continue;
        }
        const std::vector<Near> beside = neighbours(record);
        if (isEarly(beside)) {
            continue;
        }
        photo::Verdict verdict = judgedBeside(record, beside, stop).verdict;
        std::ranges::copy_if(early->second.findings, std::back_inserter(verdict.findings),
                             [](const photo::Finding& finding) { // That is known of the photo before it.
                                 return finding.flaw == photo::Flaw::Unmoved;
                             });
        m_store.use([&](store::SurveyStore& store) { store.setVerdict(recordOf(record.id, verdict)); });
        m_again.push_back({record, std::move(early->second), std::move(verdict)});
        m_early.erase(early);
    }
}

photo::Verdict PhotoJudge::judge(std::int64_t id, const std::stop_token& stop) {
    const std::scoped_lock lock(m_mutex);
    const store::PhotoRecord record =
        m_store.use([&](const store::SurveyStore& store) { return store.photo(id); });
    const std::vector<Near> beside = neighbours(record);
    photo::JudgedPhoto result = judgedBeside(record, beside, stop);
    if (result.sketch) {
        tellIfUnmoved({record, std::move(*result.band)}, result.verdict);
    }
    m_store.use([&](store::SurveyStore& store) { store.setVerdict(recordOf(id, result.verdict)); });
    if (isEarly(beside)) {
        m_early.insert_or_assign(id, result.verdict);
    }
    judgeEarlyAgain(beside, stop);
    return result.verdict;
}

std::vector<PhotoJudge::Again> PhotoJudge::takeAgain() {
    const std::scoped_lock lock(m_mutex);
    return std::exchange(m_again, {});
}

} // namespace spherewalk::jobs
