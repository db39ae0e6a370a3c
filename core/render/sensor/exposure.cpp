// SPDX-License-Identifier: Apache-2.0
#include "sensor/effects.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::render {

namespace {

constexpr int kStepsAStop = 16;

/// 2^(steps / 16). Whole powers of two are exact; the rest is rounded to single precision, so that the last
/// bit of the C library does not count.
double factorOf(int steps) {
    const int whole = static_cast<int>(std::floor(static_cast<double>(steps) / kStepsAStop));
    const double part = static_cast<double>(steps - whole * kStepsAStop) / kStepsAStop;
    return std::ldexp(static_cast<double>(static_cast<float>(std::exp2(part))), whole);
}

double stepsOf(double factor) {
    return kStepsAStop * std::log2(factor);
}

/// The integral of the share of a view whose neighbours are a step of 1 away, from -infinity to t: of the
/// triangle from -1 to 1.
double triangleUpTo(double t) {
    if (t <= -1) {
        return 0;
    }
    if (t >= 1) {
        return 1;
    }
    return t < 0 ? 0.5 * (t + 1) * (t + 1) : 1 - 0.5 * (1 - t) * (1 - t);
}

/// The mean share of a view in a row that is exposed from `begin` to `end`. Units: steps after the view.
double meanShare(double begin, double end) {
    constexpr double kInstant = 1e-6;
    return end - begin < kInstant ? std::max(0.0, 1 - std::abs(0.5 * (begin + end)))
                                  : (triangleUpTo(end) - triangleUpTo(begin)) / (end - begin);
}

/// How far things in the middle of the picture a metre away move between two poses.
double motionPx(const Rigid3& from, const Rigid3& to, double focalPx) {
    return focalPx *
           (from.rotation.angularDistance(to.rotation) + (to.translation - from.translation).norm());
}

} // namespace

RowTiming::RowTiming(int rows, double timeS, double exposureS, double lineDelayS, double stepS) {
    const double lastS = (rows - 1) * lineDelayS; // after the frame's time
    if (exposureS <= 0 && lastS <= 0) {
        m_times = {timeS};
        m_shares.assign(static_cast<std::size_t>(rows), kOne);
        return;
    }
    const int before = static_cast<int>(std::ceil(0.5 * exposureS / stepS));
    const int after = static_cast<int>(std::ceil((lastS + 0.5 * exposureS) / stepS));
    m_main = static_cast<std::size_t>(before);
    for (int view = -before; view <= after; ++view) {
        m_times.push_back(timeS + view * stepS);
    }
    m_shares.resize(static_cast<std::size_t>(rows) * m_times.size());
    for (int row = 0; row < rows; ++row) {
        std::uint32_t* shares = m_shares.data() + static_cast<std::size_t>(row) * m_times.size();
        std::uint32_t rest = kOne;
        for (std::size_t view = 0; view < m_times.size(); ++view) {
            const double middle = row * lineDelayS / stepS - (static_cast<double>(view) - before);
            const double half = 0.5 * exposureS / stepS;
            const double share = meanShare(middle - half, middle + half);
            shares[view] = std::min(rest, static_cast<std::uint32_t>(std::lround(share * kOne)));
            rest -= shares[view];
        }
        *std::max_element(shares, shares + m_times.size()) += rest; // of rounding
    }
}

std::pair<double, double> viewStep(const Sensor::PoseAt& poseAt, const CameraIntrinsics& camera, double timeS,
                                   double exposureS, const ShutterModel& shutter) {
    constexpr int kPieces = 8;
    const double focalPx = std::max(camera.fx, camera.fy);
    const double lengthS = exposureS + (camera.height - 1) * shutter.lineDelayS;
    const double beginS = timeS - 0.5 * exposureS;
    double mostPx = 0; // in the fastest piece
    Rigid3 last = poseAt(beginS);
    for (int piece = 1; piece <= kPieces; ++piece) {
        const Rigid3 next = poseAt(beginS + lengthS * piece / kPieces);
        mostPx = std::max(mostPx, motionPx(last, next, focalPx));
        last = next;
    }
    const double lengthPx = kPieces * mostPx;
    // Up to two views more stand beyond the ends, where a step is no whole part of them.
    const double steps = std::clamp(std::ceil(lengthPx), 1.0, shutter.mostViews - 3.0);
    return {lengthS / steps, lengthPx / steps};
}

ExposureControl::ExposureControl(const ExposureModel& model)
    : m_model(model), m_referenceS(model.referenceTimeS > 0 ? model.referenceTimeS : model.timeS) {
    if (m_model.automatic) {
        m_referenceS = m_referenceS > 0 ? m_referenceS : m_model.automatic->mostTimeS;
        follow(m_model.automatic->target, 1); // into the range
    }
}

double ExposureControl::timeFactor() const {
    if (m_model.automatic) {
        return factorOf(m_timeSteps);
    }
    return m_referenceS > 0 && m_model.timeS > 0 ? m_model.timeS / m_referenceS : 1;
}

double ExposureControl::timeS() const {
    return m_model.automatic ? m_referenceS * factorOf(m_timeSteps) : m_model.timeS;
}

double ExposureControl::gainFactor() const {
    return m_model.automatic ? factorOf(m_gainSteps)
                             : static_cast<double>(static_cast<float>(std::pow(10, m_model.gainDb / 20)));
}

double ExposureControl::gainDb() const {
    return m_model.automatic ? 20 * std::log10(factorOf(m_gainSteps)) : m_model.gainDb;
}

bool ExposureControl::follow(double meanLight, double response) {
    if (!m_model.automatic) {
        return false;
    }
    constexpr double kDarkest = 1e-4; // more is never missing at a time
    const AutoExposure& limits = *m_model.automatic;
    const int leastTime = static_cast<int>(std::ceil(stepsOf(limits.leastTimeS / m_referenceS)));
    const int mostTime =
        std::max(leastTime, static_cast<int>(std::floor(stepsOf(limits.mostTimeS / m_referenceS))));
    const int mostGain = static_cast<int>(std::floor(stepsOf(std::pow(10, limits.mostGainDb / 20))));
    const double missing = response * stepsOf(limits.target / std::max(meanLight, kDarkest));
    const int wanted = m_timeSteps + m_gainSteps + static_cast<int>(std::lround(missing));
    const int time = std::clamp(wanted, leastTime, mostTime);
    const int gain = std::clamp(wanted - time, 0, mostGain);
    const bool isChange = time != m_timeSteps || gain != m_gainSteps;
    m_timeSteps = time;
    m_gainSteps = gain;
    return isChange;
}

} // namespace spherewalk::render
