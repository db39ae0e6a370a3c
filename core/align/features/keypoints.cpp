// SPDX-License-Identifier: GPL-3.0-or-later
#include "keypoints.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <opencv2/features2d.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <tuple>

namespace spherewalk::align {

namespace {

constexpr double kOrbStep = 1.2;
constexpr int kOrbLevels = 4; ///< corners are known to a pixel of their level: the coarser ones help no more
constexpr float kOrbCorner = 7.0F / 31; ///< a corner's diameter as a share of its descriptor's patch
constexpr double kRootScale = 512;      ///< the length of a RootSIFT descriptor; its values stay below 256

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

/// The picture's pixels, not copied.
cv::Mat matrixOf(const GreyImage& picture) {
    return {picture.height(), picture.width(), CV_8U, const_cast<std::uint8_t*>(picture.values().data())};
}

/// A coordinate of ORB's pyramid level, which OpenCV multiplies by the step and not by the true ratio of the
/// sizes, and not about the pixels' corners.
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

std::vector<Keypoint> KeypointDetector::find(const GreyImage& picture) const {
    std::vector<cv::KeyPoint> found;
    translated([&] { m_state->detector->detect(matrixOf(picture), found); });
    std::vector<Keypoint> keypoints;
    keypoints.reserve(found.size());
    for (const cv::KeyPoint& each : found) {
        Keypoint keypoint{each.pt.x, each.pt.y, each.size, each.response, each.angle,
                          each.pt.x, each.pt.y, each.size, each.octave,   each.class_id};
        if (m_state->kind == Detector::Sift) {
            keypoint.x -= 0.25; // it doubles the picture about the pixels' corners and halves about centres
            keypoint.y -= 0.25;
        } else if (m_state->kind == Detector::Orb) {
            keypoint.sizePx *= kOrbCorner;
            keypoint.x = fromOrbLevel(each.pt.x, each.octave, picture.width());
            keypoint.y = fromOrbLevel(each.pt.y, each.octave, picture.height());
        }
        keypoints.push_back(keypoint);
    }
    std::sort(keypoints.begin(), keypoints.end(), [](const Keypoint& a, const Keypoint& b) {
        return std::tie(a.y, a.x, a.sizePx, a.angleDeg, a.response) <
               std::tie(b.y, b.x, b.sizePx, b.angleDeg, b.response);
    });
    return keypoints;
}

std::vector<std::uint8_t> KeypointDetector::describe(const GreyImage& picture,
                                                     const std::vector<Keypoint>& keypoints) const {
    std::vector<cv::KeyPoint> asked;
    for (const Keypoint& each : keypoints) {
        // What is asked for may come back in another order and not whole; the response is passed through.
        asked.emplace_back(each.rawX, each.rawY, each.rawSizePx, each.angleDeg,
                           static_cast<float>(asked.size()), each.octave, each.level);
    }
    cv::Mat rows;
    translated([&] { m_state->detector->compute(matrixOf(picture), asked, rows); });
    const auto bytes = static_cast<std::size_t>(descriptorBytes());
    std::vector<std::uint8_t> descriptors(keypoints.size() * bytes);
    for (std::size_t i = 0; i < asked.size(); ++i) {
        std::uint8_t* to = descriptors.data() + static_cast<std::size_t>(asked[i].response) * bytes;
        std::memcpy(to, rows.ptr(static_cast<int>(i)), std::min(bytes, static_cast<std::size_t>(rows.cols)));
        if (m_state->kind == Detector::Sift) {
            toRoots(to, static_cast<int>(bytes));
        }
    }
    return descriptors;
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

} // namespace spherewalk::align
