// SPDX-License-Identifier: GPL-3.0-or-later
#include "features/keypoints.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <opencv2/features2d.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <numbers>
#include <numeric>
#include <tuple>
#include <unordered_map>

namespace spherewalk::align {

namespace {

constexpr double kOrbStep = 1.2;
constexpr int kOrbLevels = 4; ///< A corner is known to a pixel of its level, so coarser levels help no more.
constexpr float kOrbCorner = 7.0F / 31; ///< A corner's diameter as a share of its descriptor's patch.
constexpr double kRootScale = 512;      ///< The length of a RootSIFT descriptor; its values stay below 256.

template <class Work>
auto translated(const Work& work) {
    try {
        return work();
    } catch (const cv::Exception& failure) {
        throw Error(ErrorKind::Internal, "Could not look for features in a photo: OpenCV failed.",
                    failure.what());
    }
}

cv::Ptr<cv::Feature2D> made(const FeatureOptions& options) {
    switch (options.detector) {
    case Detector::Sift:
        return cv::SIFT::create(0, 3, options.leastContrast, 10, 1.6, CV_8U);
    case Detector::Akaze:
        return cv::AKAZE::create(cv::AKAZE::DESCRIPTOR_MLDB, 0, 3, 0.0003F, 3, 3);
    case Detector::Orb:
        break;
    }
    return cv::ORB::create(3 * options.most, static_cast<float>(kOrbStep), kOrbLevels, 24, 0, 2,
                           cv::ORB::HARRIS_SCORE, 31, 8);
}

/// The true coordinate of a corner on a level of ORB's pyramid. OpenCV multiplies by the step instead of the
/// true ratio of the sizes, and not about the pixels' corners.
double fromOrbLevel(double coordinate, int octave, int size) {
    const double step = std::pow(kOrbStep, octave);
    const double ratio = size / std::round(size / step);
    return (coordinate / step + 0.5) * ratio - 0.5;
}

void toRoots(std::uint8_t* values, int count) {
    int sum = 0;
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    for (int i = 0; i < count && sum > 0; ++i) {
        const double root = kRootScale * std::sqrt(static_cast<double>(values[i]) / sum);
        values[i] = static_cast<std::uint8_t>(std::min(255.0, std::round(root)));
    }
}

} // namespace

cv::Mat matrixOf(const GreyImage& picture) {
    return {picture.height(), picture.width(), CV_8U, const_cast<std::uint8_t*>(picture.values().data())};
}

struct KeypointDetector::State {
    Detector kind;
    cv::Ptr<cv::Feature2D> detector;
};

KeypointDetector::KeypointDetector(const FeatureOptions& options)
    : m_state(new State{options.detector, translated([&] { return made(options); })}) {
}

KeypointDetector::~KeypointDetector() = default;

int KeypointDetector::descriptorBytes() const {
    switch (m_state->kind) {
    case Detector::Sift:
        return 128;
    case Detector::Akaze:
        return 64; // 61, filled up
    case Detector::Orb:
        break;
    }
    return 32;
}

DescribedKeypoints KeypointDetector::find(const GreyImage& picture) const {
    std::vector<cv::KeyPoint> found;
    cv::Mat rows;
    translated([&] { m_state->detector->detectAndCompute(matrixOf(picture), cv::noArray(), found, rows); });
    const auto bytes = static_cast<std::size_t>(descriptorBytes());
    DescribedKeypoints result;
    result.keypoints.reserve(found.size());
    result.descriptors.resize(found.size() * bytes);
    for (const cv::KeyPoint& each : found) {
        const auto row = static_cast<int>(result.keypoints.size());
        Keypoint keypoint{each.pt.x, each.pt.y, each.size, each.response, each.angle, each.octave, row};
        if (m_state->kind == Detector::Sift) {
            keypoint.x -= 0.25; // It doubles the picture about pixel corners and halves about centres.
            keypoint.y -= 0.25;
        } else if (m_state->kind == Detector::Orb) {
            keypoint.sizePx *= kOrbCorner;
            keypoint.x = fromOrbLevel(each.pt.x, each.octave, picture.width());
            keypoint.y = fromOrbLevel(each.pt.y, each.octave, picture.height());
        }
        result.keypoints.push_back(keypoint);
        std::uint8_t* to = result.descriptors.data() + static_cast<std::size_t>(row) * bytes;
        std::memcpy(to, rows.ptr(row), std::min(bytes, static_cast<std::size_t>(rows.cols)));
        if (m_state->kind == Detector::Sift) {
            toRoots(to, static_cast<int>(bytes));
        }
    }
    std::ranges::sort(result.keypoints, {}, [](const Keypoint& each) {
        return std::tie(each.y, each.x, each.sizePx, each.angleDeg, each.response);
    });
    return result;
}

double KeypointDetector::sigmaPx(const Keypoint& keypoint) const {
    switch (m_state->kind) {
    case Detector::Sift:
    case Detector::Akaze:
        return 0.03 * keypoint.sizePx;
    case Detector::Orb:
        break;
    }
    return 0.35 * std::pow(kOrbStep, keypoint.octave);
}

namespace {

constexpr int kElevationBands = 18; ///< Number of bands from pole to pole.

/// The region of the sphere that holds the bearing. Regions are about equally large: bands of elevation, each
/// cut into as many pieces as its length asks for.
int regionOf(const Eigen::Vector3d& bearing) {
    const double elevation = std::asin(std::clamp(bearing.z(), -1.0, 1.0));
    const int band = std::clamp(static_cast<int>((elevation / std::numbers::pi + 0.5) * kElevationBands), 0,
                                kElevationBands - 1);
    const double middle = ((band + 0.5) / kElevationBands - 0.5) * std::numbers::pi;
    const int pieces = std::max(1, static_cast<int>(std::lround(2 * kElevationBands * std::cos(middle))));
    const double turn = (std::atan2(bearing.y(), bearing.x()) / std::numbers::pi + 1) / 2;
    return band * 2 * kElevationBands + std::clamp(static_cast<int>(turn * pieces), 0, pieces - 1);
}

/// The bearings kept so far, found again by their place on the sphere.
class Neighbourhood {
  public:
    explicit Neighbourhood(double reachRad) : m_perUnit(1 / std::max(reachRad, 1e-5)) {}

    /// The least number of those within reach; -1 if there are none.
    int firstNear(const Eigen::Vector3d& bearing, double reachRad) const {
        const Eigen::Vector3i middle = cell(bearing);
        int first = -1;
        for (int i = 0; i < 27; ++i) {
            const Eigen::Vector3i offset(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
            const auto [begin, end] = m_kept.equal_range(key(middle + offset));
            for (auto kept = begin; kept != end; ++kept) {
                const auto& [number, place] = kept->second;
                if ((place - bearing).squaredNorm() < reachRad * reachRad) {
                    first = first < 0 ? number : std::min(first, number);
                }
            }
        }
        return first;
    }

    void add(int number, const Eigen::Vector3d& bearing) {
        m_kept.emplace(key(cell(bearing)), std::pair(number, bearing));
    }

  private:
    Eigen::Vector3i cell(const Eigen::Vector3d& bearing) const {
        return (bearing * m_perUnit).array().floor().cast<int>();
    }

    static std::int64_t key(const Eigen::Vector3i& at) {
        return (static_cast<std::int64_t>(at.x()) << 40) + (static_cast<std::int64_t>(at.y()) << 20) + at.z();
    }

    double m_perUnit;
    std::unordered_multimap<std::int64_t, std::pair<int, Eigen::Vector3d>> m_kept;
};

} // namespace

std::vector<int> evenSelection(const std::vector<Spot>& spots, int most) {
    std::vector<int> byStrength(spots.size());
    std::iota(byStrength.begin(), byStrength.end(), 0);
    const auto spot = [&](int i) -> const Spot& { return spots[static_cast<std::size_t>(i)]; };
    std::stable_sort(byStrength.begin(), byStrength.end(),
                     [&](int a, int b) { return spot(a).response > spot(b).response; });
    double widest = 0;
    for (const Spot& each : spots) {
        widest = std::max(widest, each.ownRad);
    }
    Neighbourhood kept(widest);
    std::map<int, int> roundOf;               // The next round of each region.
    std::map<int, std::vector<int>> byRounds; // Members of each round, the strongest first.
    for (const int i : byStrength) {
        if (kept.firstNear(spot(i).bearing, spot(i).ownRad) < 0) {
            kept.add(i, spot(i).bearing);
            byRounds[roundOf[regionOf(spot(i).bearing)]++].push_back(i);
        }
    }
    std::vector<int> selected;
    for (const auto& [round, members] : byRounds) {
        selected.insert(selected.end(), members.begin(), members.end());
    }
    selected.resize(std::min(selected.size(), static_cast<std::size_t>(most)));
    return selected;
}

std::vector<int> firstNear(const std::vector<Eigen::Vector3f>& bearings, double reachRad) {
    Neighbourhood firsts(reachRad);
    std::vector<int> found;
    for (const Eigen::Vector3f& each : bearings) {
        const auto index = static_cast<int>(found.size());
        const Eigen::Vector3d bearing = each.cast<double>();
        const int first = firsts.firstNear(bearing, reachRad);
        if (first < 0) {
            firsts.add(index, bearing);
        }
        found.push_back(first < 0 ? index : first);
    }
    return found;
}

} // namespace spherewalk::align
