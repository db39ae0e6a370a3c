// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/align_survey.h"

#include "parts/report_parts.h"

#include "spherewalk/align/content_check.h"
#include "spherewalk/align/find_features.h"
#include "spherewalk/align/match_pairs.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/store/survey_store.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace spherewalk::jobs {

using SteadyClock = std::chrono::steady_clock;

namespace {

/// What says where photos stand to each other.
enum class PlacesBy {
    Tags,
    Pictures,         ///< Alone.
    PicturesNearTags, ///< Tags give the frame, and must agree.
};

align::Effort effortBy(PlacesBy by, const AlignOptions& options) {
    return by == PlacesBy::PicturesNearTags ? options.effort.value_or(align::Effort::Fine)
                                            : options.chosenEffort();
}

constexpr const char* kCacheFolder = "align-cache";

double secondsSince(SteadyClock::time_point begin) {
    return std::chrono::duration<double>(SteadyClock::now() - begin).count();
}

/// One run, step by step.
class AlignRun {
  public:
    AlignRun(const store::SurveyStore& store, const AlignOptions& options, PlacesBy by,
             ProgressSink& progress, std::stop_token stop)
        : m_store(store), m_options(options), m_by(by), m_progress(progress), m_stop(std::move(stop)) {}

    /// Empty if the pictures are asked where photos with tags stand, and do not say it.
    std::optional<AlignReport> run() {
        m_report.effort = effortBy(m_by, m_options);
        m_report.positionSigmaM = m_options.isFree ? 0 : m_options.positionSigmaM;
        readPhotos();
        findFeatures();
        findAprilTags();
        matchPhotos();
        if (!solve()) {
            return std::nullopt;
        }
        judge();
        return std::move(m_report);
    }

    PlacesSoFar places() {
        readPhotos();
        findFeatures();
        matchPhotos();
        PlacesSoFar result;
        std::ranges::transform(m_photos, std::back_inserter(result.photos), &store::PhotoRecord::id);
        result.places = freePlaces(false); // In a moment, while people walk.
        return result;
    }

  private:
    void readPhotos() {
        if (!m_options.isFree) {
            refuseUnknownPlaces(m_store);
        }
        m_photos = m_store.chosenPhotos();
        m_all.resize(m_photos.size());
        std::iota(m_all.begin(), m_all.end(), 0);
        if (m_photos.empty()) {
            throw Error(ErrorKind::InvalidInput,
                        text("There is nothing to align in ", m_store.folder().string(),
                             ": no station has a photo yet; capture or import some first."));
        }
        std::map<std::int64_t, store::StationRecord> stations;
        for (store::StationRecord& station : m_store.stations()) {
            m_planned.push_back(
                {station.name, station.station.positionM, station.station.placement, station.station.stop});
            stations.emplace(station.id, std::move(station));
        }
        if (m_options.isRecorded) {
            tellLeftOut(m_store, m_progress);
        }
        ProgressStep step(m_progress, 0, 0.02);
        for (const store::PhotoRecord& photo : m_photos) {
            throwIfStopped(m_stop);
            const store::StationRecord& station = stations.at(photo.station);
            m_priors.push_back(priorOf(m_store, photo, station, m_options.positionSigmaM, m_progress));
            AlignedPhoto& aligned = m_report.photos.emplace_back();
            aligned.photo = photo.id;
            aligned.file = photo.fileName;
            aligned.station = station.name;
            step.progress(static_cast<double>(m_priors.size()) / static_cast<double>(m_photos.size()),
                          "Reading what the photos say");
        }
    }

    std::vector<align::PhotoFile> filesOf(const std::vector<int>& photos) const {
        std::vector<align::PhotoFile> files;
        for (const int photo : photos) {
            const auto i = static_cast<std::size_t>(photo);
            // A new position tag changes the file, but none of its pixels.
            files.push_back(
                {m_store.photoFolder() / m_photos[i].fileName, m_priors[i].name, m_photos[i].cameraSha256});
        }
        return files;
    }

    align::FoundFeatures featuresOf(const std::vector<int>& photos, const align::FeatureOptions& features,
                                    ProgressSink& progress) const {
        align::FindOptions find;
        find.features = features;
        find.mask = readMask(m_options.mask);
        find.cacheFolder = m_cacheFolder;
        find.threads = m_options.threads;
        return align::findFeatures(filesOf(photos), find, progress, m_stop);
    }

    void findAprilTags() {
        if (m_options.tagSizeM > 0) {
            ProgressStep step(m_progress, 0.28, 0.4);
            m_aprilTags = align::findTags(filesOf(m_all), {m_cacheFolder, m_options.threads}, step, m_stop);
        }
    }

    void findFeatures() {
        const auto begin = SteadyClock::now();
        ProgressStep step(m_progress, 0.02, m_options.tagSizeM > 0 ? 0.28 : 0.4);
        m_features = featuresOf(m_all, m_effort.features, step);
        m_report.fromCache = m_features.fromCache;
        for (std::size_t i = 0; i < m_features.photos.size(); ++i) {
            m_report.features += static_cast<std::size_t>(m_features.photos[i].count());
            m_priors[i].seenVertical = m_features.photos[i].vertical;
        }
        m_report.featureSeconds = secondsSince(begin);
    }

    void matchPhotos() {
        const auto begin = SteadyClock::now();
        std::vector<Eigen::Vector3d> positions;
        std::ranges::transform(m_priors, std::back_inserter(positions), &align::PhotoPrior::positionM);
        ProgressStep step(m_progress, 0.4, 0.48);
        if (m_by != PlacesBy::Tags) {
            m_retrieval.threads = m_options.threads;
            m_alike = align::likeness(m_features.photos, m_retrieval, step, m_stop);
        }
        m_pairs = align::matchPairs(m_features.photos,
                                    m_alike ? align::likelyPairs(*m_alike, m_retrieval)
                                            : align::neighbours(positions, m_effort.neighbours),
                                    m_effort.match, m_options.threads, step, m_stop);
        align::joinTags(m_aprilTags, m_pairs);
        for (align::Features& features : m_features.photos) {
            m_bearings.push_back(std::move(features.bearings));
        }
        m_features.photos.clear();
        m_progress.progress(0.48, "Estimating how neighbours are turned to each other");
        m_estimates = estimates(m_pairs, m_effort.pair);
        lookWide();
        joinParts(positions);
        m_report.pairs = m_pairs.size();
        m_report.holdingPairs = static_cast<std::size_t>(
            std::ranges::count(m_estimates, align::PairVerdict::Constraint, &align::PairEstimate::verdict));
        m_report.matchSeconds = secondsSince(begin);
    }

    std::vector<align::PairEstimate> estimates(const std::vector<align::PhotoPair>& pairs,
                                               align::PairOptions options) const {
        options.threads = m_options.threads;
        for (const align::PhotoPrior& prior : m_priors) {
            options.ups.push_back(align::knownUp(prior));
        }
        std::vector<align::PairEstimate> made = align::estimatePairs(pairs, options);
        throwIfStopped(m_stop);
        return made;
    }

    /// Looks again at photos that share little with others, as real ones do that stand metres apart.
    void lookWide() {
        constexpr int kStrongShare = 40; // One in so many features.
        const auto loose = align::loosePairs(static_cast<int>(m_photos.size()), m_estimates,
                                             m_effort.features.most / kStrongShare);
        if (!loose.empty() && m_report.effort != align::Effort::Draft) {
            ProgressStep step(m_progress, 0.48, 0.76); // Takes as long as all before.
            matchAgain(loose, align::wideOptions(), step);
            m_report.pairsTriedAgain += loose.size();
        }
    }

    /// Looks again, with another effort, at pairs that would join parts of the survey: more first, then less,
    /// since more features make the second best match of each a better one. That takes seconds; to take
    /// photos between the parts takes a person.
    void joinParts(const std::vector<Eigen::Vector3d>& positions) {
        std::vector<align::Effort> efforts = {align::Effort::Normal, align::Effort::Fine,
                                              align::Effort::Exact};
        std::erase_if(efforts, [&](align::Effort effort) {
            return effort == m_report.effort || (m_alike && effort < m_report.effort);
        });
        std::stable_partition(efforts.begin(), efforts.end(),
                              [&](align::Effort effort) { return effort > m_report.effort; });
        double begin = 0.76;
        for (const align::Effort effort : efforts) {
            const align::EffortOptions other = align::optionsFor(effort);
            std::vector<std::pair<int, int>> apart =
                m_alike ? align::likelyBridges(*m_alike, m_estimates, m_retrieval)
                        : align::neighboursApart(positions, m_estimates, other.neighbours);
            std::erase_if(apart, [&](const auto& pair) {
                return std::min(m_bearings[static_cast<std::size_t>(pair.first)].size(),
                                m_bearings[static_cast<std::size_t>(pair.second)].size()) <
                       static_cast<std::size_t>(align::PairOptions().leastInliers); // They show nothing.
            });
            if (!apart.empty()) {
                ProgressStep step(m_progress, begin, begin + 0.03);
                begin += 0.03;
                matchAgain(apart, other, step);
                m_report.pairsTriedAgain += apart.size();
            }
        }
    }

    void matchAgain(const std::vector<std::pair<int, int>>& apart, const align::EffortOptions& effort,
                    ProgressSink& progress) {
        std::set<int> again;
        for (const auto& [a, b] : apart) {
            again.insert({a, b});
        }
        const std::vector<int> photos(again.begin(), again.end());
        std::vector<std::pair<int, int>> places = apart;
        for (auto& [a, b] : places) {
            a = static_cast<int>(std::ranges::lower_bound(photos, a) - photos.begin());
            b = static_cast<int>(std::ranges::lower_bound(photos, b) - photos.begin());
        }
        ProgressStep finding(progress, 0, 0.8);
        const align::FoundFeatures found = featuresOf(photos, effort.features, finding);
        ProgressStep matching(progress, 0.8, 1);
        std::vector<align::PhotoPair> pairs =
            align::matchPairs(found.photos, places, effort.match, m_options.threads, matching, m_stop);
        align::renumber(found.photos, photos, ++m_looks, m_bearings, pairs);
        align::joinTags(m_aprilTags, pairs);
        takeBetter(std::move(pairs), effort.pair);
    }

    /// Of a pair that was compared twice the estimate that holds counts, the later one if both do.
    void takeBetter(std::vector<align::PhotoPair> pairs, const align::PairOptions& options) {
        const std::vector<align::PairEstimate> made = estimates(pairs, options);
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            const auto present = std::ranges::find_if(m_pairs, [&](const align::PhotoPair& pair) {
                return pair.a == pairs[i].a && pair.b == pairs[i].b;
            });
            if (present == m_pairs.end()) {
                m_pairs.push_back(std::move(pairs[i]));
                m_estimates.push_back(made[i]);
            } else if (made[i].verdict == align::PairVerdict::Constraint) {
                m_estimates[static_cast<std::size_t>(present - m_pairs.begin())] = made[i];
                *present = std::move(pairs[i]);
            }
        }
    }

    bool solve() {
        const auto begin = SteadyClock::now();
        if (m_by == PlacesBy::Tags) {
            solveByTags();
        } else if (m_by == PlacesBy::Pictures) {
            solveFree();
        }
        const bool isSolved = m_by != PlacesBy::PicturesNearTags || solveNearTags();
        m_report.solveSeconds = secondsSince(begin);
        return isSolved;
    }

    void solveByTags() {
        if (m_options.checksPositions) {
            m_progress.progress(0.86, "Checking the positions");
            m_report.tagFrame = align::tagFrame(m_priors, m_estimates);
            tellOnePlace(align::photosAtOnePlace(m_priors, m_estimates), m_report);
            if (!m_report.tagFrame.isMirrored) { // Else most photos would seem to be swapped.
                correctPositions(m_estimates, m_planned, m_options.positionSigmaM, m_priors, m_report);
            }
        }
        throwIfStopped(m_stop);
        m_tagged = m_priors;
        solvePoses(0.87, 0.94);
        const auto frees = [&] {
            return m_options.checksPositions && !m_report.tagFrame.isMirrored &&
                   freeMoved(m_tagged, m_options.positionSigmaM, m_priors, m_report);
        };
        for (double from = 0.94; from < 0.98 && frees(); from += 0.02) { // one may hide another
            solvePoses(from, from + 0.02);
        }
        m_report.scaleSigma = scaleSigmaOf(m_tagged, m_report.alignment);
    }

    align::FreePlaces freePlaces(bool comparesPictures) {
        ProgressStep step(m_progress, 0.86, 0.9);
        align::FreeOptions options = freeOptions(m_store, m_options, m_report.photos);
        options.tags = m_aprilTags;
        options.picture = comparesPictures ? options.picture : nullptr;
        align::FreePlaces places = align::freePlaces(m_priors, m_pairs, m_estimates, options, step, m_stop);
        keepFrame(m_store, m_photos, places);
        return places;
    }

    void solveFree() {
        m_report.places = freePlaces(true);
        usePlaces(*m_report.places, m_priors, m_estimates);
        m_tagged = m_priors;
        solvePoses(0.9, 0.98);
        takePlaces(*m_report.places, m_priors, m_report);
    }

    /// Whether the pictures say where the photos stand, and most tags agree.
    bool solveNearTags() {
        m_tagged = m_priors;
        const align::FreePlaces places = freePlaces(true);
        const std::optional<FrameSigma> frame = usePlacesByTags(places, m_priors);
        if (frame) {
            m_report.scaleSigma = frame->scale;
            solvePoses(0.9, 0.98, frame);
            widenTurns(places, m_report);
        }
        return frame.has_value();
    }

    void solvePoses(double begin, double end, const std::optional<FrameSigma>& frame = {}) {
        align::SolveOptions options;
        options.model = m_options.model;
        options.threads = m_options.threads;
        options.areTagged = m_by == PlacesBy::Tags;
        if (frame) {
            options.placementSigmaM = frame->placeM;
            options.placementSigma = frame->heading;
        }
        const bool isAnyFree = std::ranges::any_of(
            m_report.photos, [](const AlignedPhoto& photo) { return photo.freeSigmaM > 0; });
        if ((isAnyFree || m_by != PlacesBy::Tags) && options.model == align::Model::Auto) {
            options.model = align::Model::Position;
        }
        ProgressStep step(m_progress, begin, end);
        m_report.alignment = align::solve(m_priors, m_pairs, m_estimates, options, step, m_stop);
        if (options.model != m_options.model) {
            m_report.alignment.reason =
                frame ? frame->text() : "Photos with wrong tags are solved with their places.";
        }
    }

    void judge() {
        m_progress.progress(0.98, "Looking for what moved");
        std::vector<std::optional<Rigid3>> solved;
        for (const align::SolvedPose& pose : m_report.alignment.photos) {
            solved.push_back(pose.isSolved ? std::optional(pose.roomFromPhoto) : std::nullopt);
        }
        const std::vector<std::vector<bool>> fitting = align::fittingMatches(solved, m_pairs);
        if (m_options.checksPositions && !m_options.isFree) {
            m_report.scale = align::scaleByFloor(solved, m_pairs, fitting);
            refineStretch(m_tagged, m_report);
        }
        const MaskImage mask = readMask(m_options.mask);
        const auto isSearched = [&](const Eigen::Vector3d& bearing) {
            return align::isSearched(m_effort.features, mask, bearing, Degrees(1));
        };
        for (const align::ChangedContent& changed :
             align::changedContent(solved, m_pairs, fitting, {m_options.threads, isSearched})) {
            AlignedPhoto& photo = m_report.photos.at(static_cast<std::size_t>(changed.photo));
            if (std::find(photo.flags.begin(), photo.flags.end(), changed.reason) == photo.flags.end()) {
                photo.flags.push_back(changed.reason);
            }
            propose(Cure::Retake, photo);
        }
        ProgressStep searching(m_progress, 0.98, 0.995);
        tellForeignThings(m_store.photoFolder(), {mask, m_options.threads}, m_report, searching, m_stop);
        giveVerdicts(m_tagged, m_report);
        tellTagFrame(m_report);
        placeAprilTags(m_aprilTags, m_options.tagSizeM, m_report);
        tellDamaged(m_features.unreadable, m_report);
    }

    const store::SurveyStore& m_store;
    const AlignOptions& m_options;
    PlacesBy m_by;
    ProgressSink& m_progress;
    std::stop_token m_stop;
    std::filesystem::path m_cacheFolder =
        m_options.cacheFolder.empty() ? m_store.folder() / kCacheFolder : m_options.cacheFolder;
    align::EffortOptions m_effort = align::optionsFor(effortBy(m_by, m_options));
    std::vector<store::PhotoRecord> m_photos;
    std::vector<int> m_all; ///< Indices of all photos.
    std::vector<align::PlannedPosition> m_planned;
    std::vector<align::PhotoPrior> m_priors; ///< one a photo, as all below
    std::vector<align::PhotoPrior> m_tagged; ///< with the places that fit
    align::FoundFeatures m_features;
    int m_looks = 0;                                      ///< Number of looks after the first.
    std::vector<std::vector<Eigen::Vector3f>> m_bearings; ///< Of all features so far, one list a photo.
    std::vector<align::TagSighting> m_aprilTags;
    align::RetrievalOptions m_retrieval;
    std::optional<align::Likeness> m_alike; ///< Of photos whose places are not known.
    std::vector<align::PhotoPair> m_pairs;
    std::vector<align::PairEstimate> m_estimates; ///< one a pair
    AlignReport m_report;
};

} // namespace

AlignReport alignSurvey(store::SurveyStore& store, const AlignOptions& options, ProgressSink& progress,
                        const std::stop_token& stop) {
    const auto begin = SteadyClock::now();
    const double looked = options.hasRoughTags() ? 0.6 : 0;
    EachWarningOnce once(progress);
    std::optional<AlignReport> report;
    if (options.hasRoughTags()) {
        ProgressStep step(once, 0, looked);
        report = AlignRun(store, options, PlacesBy::PicturesNearTags, step, stop).run();
    }
    if (!report) {
        ProgressStep step(once, looked, 1);
        const PlacesBy by = options.isFree ? PlacesBy::Pictures : PlacesBy::Tags;
        report = AlignRun(store, options, by, step, stop).run();
    }
    report->seconds = secondsSince(begin);
    throwIfStopped(stop);
    if (options.isRecorded) {
        recordSolution(store, options, *report, progress);
    }
    progress.progress(1, "Aligned");
    return std::move(*report);
}

PlacesSoFar placesSoFar(const store::SurveyStore& store, const AlignOptions& options, ProgressSink& progress,
                        const std::stop_token& stop) {
    return AlignRun(store, options, PlacesBy::Pictures, progress, stop).places();
}

} // namespace spherewalk::jobs
