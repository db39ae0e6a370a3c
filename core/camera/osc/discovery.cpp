// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/camera/discovery.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/base/text.h"
#include "spherewalk/camera/osc_client.h"
#include "spherewalk/camera/osc_error.h"

#include <algorithm>
#include <future>
#include <iterator>
#include <optional>
#include <utility>

#ifdef SPHEREWALK_HAS_AVAHI
#include <array>
#include <avahi-client/client.h>
#include <avahi-client/lookup.h>
#include <avahi-common/error.h>
#include <avahi-common/simple-watch.h>
#include <memory>
#endif

namespace spherewalk::camera {

namespace {

constexpr int kPracticePort = 8080; // of `spherewalk-cli practice-camera`, unless it is given another

/// Who answers there; nothing if nobody does, or something that is no camera.
std::optional<CameraInfo> whoAnswers(const CameraPlace& place, const FindOptions& options,
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

bool isFound(const std::vector<FoundCamera>& cameras, const CameraInfo& info) {
    return std::any_of(cameras.begin(), cameras.end(), [&](const FoundCamera& camera) {
        return camera.info.serialNumber == info.serialNumber && camera.info.model == info.model;
    });
}

/// Asks all at the same time. Errors: Stopped, once all have ended.
void askAll(const std::vector<CameraPlace>& places, const FindOptions& options, FindReport& report,
            const std::stop_token& stop) {
    std::vector<std::future<std::optional<CameraInfo>>> answers;
    answers.reserve(places.size());
    for (const CameraPlace& place : places) {
        answers.push_back(std::async(std::launch::async,
                                     [&options, &stop, &place] { return whoAnswers(place, options, stop); }));
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
        std::optional<CameraInfo> info = answers[i].get();
        if (!info) {
            report.silent.push_back(places[i]);
        } else if (!isFound(report.cameras, *info)) {
            report.cameras.push_back({places[i], *std::move(info)});
        }
    }
}

/// Cameras that announced themselves.
struct BrowseReport {
    std::vector<CameraPlace> places;
    std::string problem; ///< Why nothing could be listened for, as a sentence; empty if it could.
};

#ifdef SPHEREWALK_HAS_AVAHI

constexpr const char* kOscService = "_osc._tcp";
constexpr std::size_t kMostAnnounced = 32;
constexpr int kBrowseTickMs = 50;

using AvahiPoll = std::unique_ptr<AvahiSimplePoll, decltype(&avahi_simple_poll_free)>;
using AvahiConnection = std::unique_ptr<AvahiClient, decltype(&avahi_client_free)>;

/// The talk with Avahi's daemon. Its objects belong to the client and end with it. The callbacks are C's and
/// run inside of iterate(), on this thread.
class CameraBrowser {
  public:
    BrowseReport run(std::chrono::milliseconds time, const std::stop_token& stop) {
        const AvahiPoll poll(avahi_simple_poll_new(), &avahi_simple_poll_free);
        int error = AVAHI_ERR_NO_MEMORY;
        const AvahiConnection client(poll ? avahi_client_new(avahi_simple_poll_get(poll.get()),
                                                             AvahiClientFlags{}, &CameraBrowser::onClient,
                                                             this, &error)
                                          : nullptr,
                                     &avahi_client_free);
        const bool isListening =
            client && avahi_service_browser_new(client.get(), AVAHI_IF_UNSPEC, AVAHI_PROTO_INET, kOscService,
                                                nullptr, AvahiLookupFlags{}, &CameraBrowser::onService, this);
        if (!isListening) {
            fail(client ? avahi_client_errno(client.get()) : error);
            return std::move(m_report);
        }
        const auto end = std::chrono::steady_clock::now() + time;
        while (!stop.stop_requested() && std::chrono::steady_clock::now() < end &&
               avahi_simple_poll_iterate(poll.get(), kBrowseTickMs) == 0) {
        }
        return std::move(m_report);
    }

  private:
    void fail(int error) {
        m_report.problem =
            text("Announcements on the network were not listened for, as Avahi does not answer (",
                 avahi_strerror(error), ").");
    }

    static void onClient(AvahiClient* client, AvahiClientState state, void* self) {
        if (state == AVAHI_CLIENT_FAILURE) {
            static_cast<CameraBrowser*>(self)->fail(avahi_client_errno(client));
        }
    }

    static void onService(AvahiServiceBrowser* browser, AvahiIfIndex interface, AvahiProtocol protocol,
                          AvahiBrowserEvent event, const char* name, const char* type, const char* domain,
                          AvahiLookupResultFlags /*flags*/, void* self) {
        if (event == AVAHI_BROWSER_NEW) { // one that cannot be resolved is not there
            avahi_service_resolver_new(avahi_service_browser_get_client(browser), interface, protocol, name,
                                       type, domain, AVAHI_PROTO_INET, AvahiLookupFlags{},
                                       &CameraBrowser::onResolved, self);
        }
    }

    static void onResolved(AvahiServiceResolver* resolver, AvahiIfIndex /*interface*/,
                           AvahiProtocol /*protocol*/, AvahiResolverEvent event, const char* name,
                           const char* /*type*/, const char* /*domain*/, const char* /*host*/,
                           const AvahiAddress* address, std::uint16_t port, AvahiStringList* /*txt*/,
                           AvahiLookupResultFlags /*flags*/, void* self) {
        auto& places = static_cast<CameraBrowser*>(self)->m_report.places;
        if (event == AVAHI_RESOLVER_FOUND && port != 0 && places.size() < kMostAnnounced) {
            std::array<char, AVAHI_ADDRESS_STR_MAX> spelled{};
            avahi_address_snprint(spelled.data(), spelled.size(), address);
            places.push_back({{spelled.data(), port}, text("announced as ", printable(name))});
        }
        avahi_service_resolver_free(resolver);
    }

    BrowseReport m_report;
};

/// Listens so long for cameras that announce themselves as _osc._tcp, over IPv4. Stop: within 200 ms; what
/// came until then is returned.
BrowseReport browseForCameras(std::chrono::milliseconds time, const std::stop_token& stop) {
    return CameraBrowser().run(time, stop);
}

#else

BrowseReport browseForCameras(std::chrono::milliseconds /*time*/, const std::stop_token& /*stop*/) {
    return {{},
            "Announcements on the network were not listened for, as this program was built without Avahi."};
}

#endif

} // namespace

std::vector<CameraPlace> usualPlaces() {
    return {{Endpoint{}, "its own WiFi"},
            {{"192.168.42.1", 80}, "the WiFi of an Insta360"},
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
