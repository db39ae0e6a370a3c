// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/align/foreign_check.h"

#include "check/sight.h"

#include "spherewalk/base/parallel.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <numbers>
#include <numeric>
#include <utility>

namespace spherewalk::align {

namespace {

constexpr double kLeastBaselineM = 0.08;
constexpr double kMostBaselineM = 3;
constexpr double kBestBaselineM = 0.45; ///< Less says little of distances, more is hidden more often.
constexpr std::size_t kSectors = 6;
constexpr std::size_t kMostWitnesses = 10;
constexpr double kLeastPart = 0.002; ///< Of the sphere. Reflections and rims are smaller.
constexpr double kMostPart = 0.15;   ///< Of the sphere. A grown-up 45 cm from the lens covers 13 %.

double distanceM(const SightPhoto& a, const SightPhoto& b) {
    return (a.roomFromPhoto->translation - b.roomFromPhoto->translation).norm();
}

bool isUsable(const SightPhoto& photo) {
    return photo.roomFromPhoto && !photo.picture.empty();
}

/// In each direction the photo whose distance tells most, and then the others whose distances do: at the rim
/// of a survey few directions have any.
std::vector<int> neighboursOf(std::size_t photo, std::span<const SightPhoto> photos) {
    if (!isUsable(photos[photo])) {
        return {};
    }
    std::vector<int> neighbours;
    for (std::size_t other = 0; other < photos.size(); ++other) {
        if (other == photo || !isUsable(photos[other])) {
            continue;
        }
        const double away = distanceM(photos[photo], photos[other]);
        if (away >= kLeastBaselineM && away <= kMostBaselineM) {
            neighbours.push_back(static_cast<int>(other));
        }
    }
    std::ranges::stable_sort(neighbours, {}, [&](int other) {
        return std::abs(
            std::log(distanceM(photos[photo], photos[static_cast<std::size_t>(other)]) / kBestBaselineM));
    });
    std::array<bool, kSectors> isCovered{};
    std::vector<int> chosen;
    std::vector<int> others;
    for (const int other : neighbours) {
        const Eigen::Vector3d to = photos[static_cast<std::size_t>(other)].roomFromPhoto->translation -
                                   photos[photo].roomFromPhoto->translation;
        const double turn = std::atan2(to.y(), to.x()) / (2 * std::numbers::pi) + 0.5;
        const auto sector = static_cast<std::size_t>(turn * kSectors) % kSectors;
        (std::exchange(isCovered[sector], true) ? others : chosen).push_back(other);
    }
    others.resize(std::min(others.size(), kSectors - chosen.size()));
    chosen.insert(chosen.end(), others.begin(), others.end());
    return chosen;
}

/// The nearest photos, whose distances say what is seen through.
std::vector<int> witnessesOf(std::size_t photo, std::span<const SightPhoto> photos,
                             std::span<const PhotoSight> sights) {
    std::vector<int> near;
    for (std::size_t other = 0; other < photos.size(); ++other) {
        if (other != photo && !sights[other].empty() &&
            distanceM(photos[photo], photos[other]) <= kMostBaselineM) {
            near.push_back(static_cast<int>(other));
        }
    }
    std::ranges::stable_sort(near, {}, [&](int other) {
        return distanceM(photos[photo], photos[static_cast<std::size_t>(other)]);
    });
    near.resize(std::min(near.size(), kMostWitnesses));
    return near;
}

double weightOf(int row) {
    return std::cos(std::numbers::pi / 2 - std::numbers::pi * (row + kSightTop + 0.5) / kSightRowsOfSphere);
}

/// Takes away what the mask does not want searched.
void leaveOut(const MaskImage& mask, cv::Mat& foreign) {
    for (int row = 0; row < kSightRows && !mask.empty(); ++row) {
        for (int column = 0; column < kSightColumns; ++column) {
            const int x = (2 * column + 1) * mask.width() / (2 * kSightColumns);
            const int y = (2 * (row + kSightTop) + 1) * mask.height() / (2 * kSightRowsOfSphere);
            if (*mask.at(x, y) == 0) {
                foreign.at<std::uint8_t>(row, column) = 0;
            }
        }
    }
}

/// The same picture, in which nothing fits what is foreign, and a cell about it.
SoftPicture without(const cv::Mat& foreign, SoftPicture picture) {
    cv::Mat wide;
    cv::dilate(foreign, wide, cv::Mat::ones(3, 3, CV_8U));
    for (int y = 0; y < kSightWidth / 2; ++y) {
        const int row = y * kSightRowsOfSphere / (kSightWidth / 2) - kSightTop;
        for (int x = 0; x < kSightWidth && row >= 0 && row < kSightRows; ++x) {
            if (wide.at<std::uint8_t>(row, x * kSightColumns / kSightWidth) != 0) {
                picture[static_cast<std::size_t>(y * kSightWidth + x)] = {0, 0, 0xFFFFFF, 0};
            }
        }
    }
    return picture;
}

/// The connected areas that are large enough, the largest first. An area across the seam counts once.
std::vector<ForeignThing> areasIn(int photo, const cv::Mat& foreign) {
    cv::Mat twice;
    cv::hconcat(foreign, foreign, twice);
    cv::morphologyEx(twice, twice, cv::MORPH_OPEN, cv::Mat::ones(3, 3, CV_8U));
    cv::Mat labels;
    const int count = cv::connectedComponents(twice, labels, 8);
    std::vector<double> areas(static_cast<std::size_t>(count), 0);
    std::vector<int> left(areas.size(), 2 * kSightColumns);
    std::vector<Eigen::Vector3d> sums(areas.size(), Eigen::Vector3d::Zero());
    for (int row = 0; row < labels.rows; ++row) {
        for (int x = 0; x < labels.cols; ++x) {
            const auto label = static_cast<std::size_t>(labels.at<int>(row, x));
            areas[label] += weightOf(row);
            left[label] = std::min(left[label], x);
            sums[label] += weightOf(row) * sightDirection(row, x % kSightColumns).cast<double>();
        }
    }
    const double sphere = 2.0 * kSightColumns * kSightRowsOfSphere / std::numbers::pi;
    std::vector<ForeignThing> things;
    for (std::size_t label = 1; label < areas.size(); ++label) {
        // The second copy of the picture repeats what begins in the first one.
        const bool isRepeated = left[label] == 0 || left[label] >= kSightColumns;
        if (areas[label] / sphere >= kLeastPart && (!isRepeated || left[label] == kSightColumns)) {
            things.push_back({photo, sums[label].normalized(), areas[label] / sphere});
        }
    }
    std::ranges::stable_sort(things, std::greater(), &ForeignThing::part);
    return things;
}

double partOf(const std::vector<ForeignThing>& things) {
    return std::accumulate(things.begin(), things.end(), 0.0,
                           [](double sum, const ForeignThing& thing) { return sum + thing.part; });
}

/// 255 where cells are at least so foreign.
cv::Mat maskOf(const std::vector<Foreign>& cells, Foreign least) {
    cv::Mat mask(kSightRows, kSightColumns, CV_8U);
    std::ranges::transform(cells, mask.begin<std::uint8_t>(),
                           [&](Foreign cell) { return static_cast<std::uint8_t>(cell >= least ? 255 : 0); });
    return mask;
}

/// Where photos of a survey show what others see through.
class ForeignSearch {
  public:
    ForeignSearch(std::span<const SightPhoto> photos, const ForeignCheckOptions& options,
                  const std::stop_token& stop)
        : m_photos(photos),
          m_options(options),
          m_stop(stop),
          m_sights(photos.size()),
          m_observers(photos.size()),
          m_foreign(photos.size()),
          m_isAlone(photos.size(), 0) {
        for (std::size_t i = 0; i < photos.size(); ++i) {
            m_neighbours.push_back(neighboursOf(i, photos));
        }
        m_pictures = softened(photos, gainsOf(photos, m_neighbours, options.threads, stop));
    }

    ForeignCheck run(ProgressSink& progress) {
        std::vector<std::size_t> all(m_photos.size());
        std::iota(all.begin(), all.end(), std::size_t{0});
        lookFrom(all);
        progress.progress(0.6, "Looking for what stands where other photos look through");
        searchIn(all);
        progress.progress(0.8, "Looking for what stands where other photos look through");
        const std::vector<std::size_t> doubted = doubtedByWhatIsForeign();
        lookFrom(doubted);
        searchIn(doubted);
        ForeignCheck result;
        for (const std::size_t i : all) {
            result.isJudged.push_back(!m_sights[i].empty() && m_isAlone[i] == 0);
            std::ranges::move(things(i), std::back_inserter(result.things));
        }
        return result;
    }

  private:
    void forEach(const std::vector<std::size_t>& photos, const std::function<void(std::size_t)>& work) const {
        parallelFor(static_cast<int>(photos.size()), 1, m_options.threads, [&](int begin, int end) {
            for (int i = begin; i < end; ++i) {
                throwIfStopped(m_stop);
                work(photos[static_cast<std::size_t>(i)]);
            }
        });
    }

    /// Learns how far away things are.
    void lookFrom(const std::vector<std::size_t>& photos) {
        forEach(photos, [&](std::size_t i) {
            m_sights[i] = sightOf(static_cast<int>(i), m_photos, m_pictures, m_neighbours[i]);
            if (!m_sights[i].empty()) {
                m_observers[i] = observer(m_photos[i], m_sights[i]);
            }
        });
    }

    void searchIn(const std::vector<std::size_t>& photos) {
        forEach(photos, [&](std::size_t i) {
            std::vector<const Observer*> witnesses;
            for (const int other : witnessesOf(i, m_photos, m_sights)) {
                witnesses.push_back(&m_observers[static_cast<std::size_t>(other)]);
            }
            if (!m_sights[i].empty()) {
                const std::vector<Foreign> cells = foreignCells(m_photos[i], m_sights[i], witnesses);
                m_foreign[i] = maskOf(cells, Foreign::Yes);
                leaveOut(m_options.mask, m_foreign[i]);
                cv::Mat alone = maskOf(cells, Foreign::Unwitnessed);
                leaveOut(m_options.mask, alone);
                m_isAlone[i] = partOf(areasIn(static_cast<int>(i), alone)) > kMostPart ? 1 : 0;
            }
        });
    }

    std::vector<ForeignThing> things(std::size_t photo) const {
        return m_sights[photo].empty() || m_isAlone[photo] != 0
                   ? std::vector<ForeignThing>()
                   : areasIn(static_cast<int>(photo), m_foreign[photo]);
    }

    /// What is foreign in one photo explains nothing in another: somebody may have kept still for both. It is
    /// taken out of the pictures. Returned are the photos without anything foreign that had it to go by.
    std::vector<std::size_t> doubtedByWhatIsForeign() {
        std::vector<bool> hasThings;
        for (std::size_t i = 0; i < m_photos.size(); ++i) {
            hasThings.push_back(!things(i).empty());
            if (hasThings[i]) {
                m_pictures[i] = without(m_foreign[i], std::move(m_pictures[i]));
            }
        }
        std::vector<std::size_t> doubted;
        for (std::size_t i = 0; i < m_photos.size(); ++i) {
            const bool hasDoubtful = std::ranges::any_of(
                m_neighbours[i], [&](int other) { return hasThings[static_cast<std::size_t>(other)]; });
            if (hasDoubtful && !hasThings[i]) {
                doubted.push_back(i);
            }
        }
        return doubted;
    }

    std::span<const SightPhoto> m_photos;
    const ForeignCheckOptions& m_options;
    std::stop_token m_stop;
    std::vector<std::vector<int>> m_neighbours;
    std::vector<SoftPicture> m_pictures;
    std::vector<PhotoSight> m_sights;
    std::vector<Observer> m_observers;
    std::vector<cv::Mat> m_foreign;
    std::vector<std::uint8_t> m_isAlone; ///< 1 where no other photo sees what this one does: behind a wall.
};

} // namespace

ForeignCheck foreignThings(std::span<const SightPhoto> photos, const ForeignCheckOptions& options,
                           ProgressSink& progress, const std::stop_token& stop) {
    return ForeignSearch(photos, options, stop).run(progress);
}

} // namespace spherewalk::align
