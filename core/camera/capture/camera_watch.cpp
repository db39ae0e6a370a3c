// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/camera/camera_watch.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace spherewalk::camera {

namespace {

constexpr double kLeastFall = 0.015; ///< Least fall of the charge before it foretells anything.
constexpr int kFewestPhotos = 5;

bool isCharging(const CameraState& state) {
    return state.batteryState == "charging" || state.batteryState == "charged";
}

} // namespace

void CameraWatch::say(std::vector<std::string>& sentences, const std::string& what, std::string sentence) {
    if (m_said.insert(what).second) {
        sentences.push_back(std::move(sentence));
    }
}

void CameraWatch::noteBattery(const CameraState& state) {
    if (!state.batteryFraction || isCharging(state)) {
        m_first.reset();
        return;
    }
    const Reading now{*state.batteryFraction, m_photos};
    if (!m_first || now.fraction > m_last.fraction) {
        m_first = now;
    }
    m_last = now;
}

std::vector<std::string> CameraWatch::look(const CameraState& state) {
    std::vector<std::string> sentences;
    for (const std::string& code : state.errors) {
        CameraTrouble trouble = describeCameraError(code);
        if (trouble.blocks) {
            throw Error(code == "NO_MEMORY" ? ErrorKind::Full : ErrorKind::Busy, trouble.sentence, code);
        }
        say(sentences, code, std::move(trouble.sentence));
    }
    if (state.isPluginRunning) {
        throw Error(ErrorKind::Busy,
                    "A plug-in runs on the camera; end it by the camera's mode button, then resume.");
    }
    noteBattery(state);
    const double battery = state.batteryFraction.value_or(1);
    const std::string percent = text(fixed(100 * battery, 0), " %");
    if (battery <= m_options.batteryMinimum && !isCharging(state)) {
        throw Error(ErrorKind::Busy,
                    text("The camera's battery is at ", percent, "; charge it before going on."));
    }
    if (battery <= m_options.batteryWarning) {
        say(sentences, "battery", text("The camera's battery is at ", percent, "; charge it soon."));
    }
    return sentences;
}

std::vector<std::string> CameraWatch::lookAtStorage(std::optional<std::int64_t> remaining) {
    m_remaining = remaining;
    if (remaining && *remaining <= 0) {
        throw Error(ErrorKind::Full, "The camera's storage is full; back its photos up, free some space, and "
                                     "resume.");
    }
    std::vector<std::string> sentences;
    if (remaining && *remaining < m_options.remainingWarning) {
        say(sentences, "storage", text("The camera has room for only ", *remaining, " more photos."));
    }
    return sentences;
}

std::optional<double> CameraWatch::photosByBattery() const {
    if (!m_first) {
        return std::nullopt;
    }
    const double fall = m_first->fraction - m_last.fraction;
    const int photos = m_last.photos - m_first->photos;
    if (fall < kLeastFall || photos < kFewestPhotos) {
        return std::nullopt;
    }
    return std::max(0.0, m_last.fraction - m_options.batteryMinimum) * photos / fall;
}

std::optional<std::int64_t> CameraWatch::photosLeft() const {
    const auto byBattery = photosByBattery();
    if (!byBattery) {
        return m_remaining;
    }
    const auto photos = static_cast<std::int64_t>(std::floor(*byBattery));
    return m_remaining ? std::min(*m_remaining, photos) : photos;
}

} // namespace spherewalk::camera
