// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/camera/discovery.h"

#include "service_browser.h"
#include "shot_settler.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/camera/osc_client.h"

#include <algorithm>
#include <future>
#include <iterator>
#include <optional>
#include <utility>

namespace spherewalk::camera {

namespace {

constexpr int kPracticePort = 8080; // of `spherewalk-cli practice-camera`, unless it is given another

/// Who answers there; nothing if nobody does, or something that is no camera.
std::optional<CameraInfo> ask(const CameraPlace& place, const FindOptions& options,
                              const std::stop_token& stop) {
    OscOptions client;
    client.attempts = 1; // who looks can look again
    client.http.connectTimeout = options.answerTime;
    client.http.requestTimeout = options.answerTime;
    try {
        return OscClient(place.endpoint, client, systemClock()).info(stop);
    } catch (const Error& error) {
        if (!isCameraTrouble(error.kind())) {
            throw;
        }
        return std::nullopt;
    }
}

bool isKnown(const std::vector<FoundCamera>& cameras, const CameraInfo& info) {
    return std::any_of(cameras.begin(), cameras.end(), [&](const FoundCamera& camera) {
        return camera.info.serialNumber == info.serialNumber && camera.info.model == info.model;
    });
}

/// Asks all at the same time. Errors: Stopped, once all have ended.
void askAll(const std::vector<CameraPlace>& places, const FindOptions& options, FindReport& report,
            const std::stop_token& stop) {
    std::vector<std::future<std::optional<CameraInfo>>> answers;
    for (const CameraPlace& place : places) {
        answers.push_back(
            std::async(std::launch::async, [&options, &stop, &place] { return ask(place, options, stop); }));
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
        std::optional<CameraInfo> info = answers[i].get();
        if (!info) {
            report.silent.push_back(places[i]);
        } else if (!isKnown(report.cameras, *info)) {
            report.cameras.push_back({places[i], *std::move(info)});
        }
    }
}

} // namespace

std::vector<CameraPlace> usualPlaces() {
    return {{Endpoint{}, "its own WiFi"},
            {{"127.0.0.1", kPracticePort}, "a practice camera on this computer"}};
}

void FindOptions::validate() const {
    using namespace std::chrono_literals;
    if (answerTime < 1ms || answerTime > 10min || browseTime < 0ms || browseTime > 10min) {
        throw Error(ErrorKind::InvalidInput,
                    "The times for finding cameras must lie between 1 ms and 10 min.");
    }
}

FindReport findCameras(const FindOptions& options, const std::stop_token& stop) {
    options.validate();
    FindReport report;
    std::future<BrowseReport> browsing;
    if (options.browseTime.count() > 0) {
        browsing = std::async(std::launch::async, [&] { return browseForCameras(options.browseTime, stop); });
    }
    askAll(options.places, options, report, stop);
    if (browsing.valid()) {
        BrowseReport browsed = browsing.get();
        report.note = std::move(browsed.problem);
        askAll(browsed.places, options, report, stop);
    }
    throwIfStopped(stop);
    return report;
}

} // namespace spherewalk::camera
