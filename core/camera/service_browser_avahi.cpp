// SPDX-License-Identifier: GPL-3.0-or-later
#include "service_browser.h"

#include "spherewalk/base/text.h"

#include <array>
#include <avahi-client/client.h>
#include <avahi-client/lookup.h>
#include <avahi-common/error.h>
#include <avahi-common/simple-watch.h>
#include <memory>
#include <utility>

namespace spherewalk::camera {

namespace {

constexpr const char* kService = "_osc._tcp";
constexpr std::size_t kMostPlaces = 32;
constexpr int kTickMs = 50;

using Poll = std::unique_ptr<AvahiSimplePoll, decltype(&avahi_simple_poll_free)>;
using Client = std::unique_ptr<AvahiClient, decltype(&avahi_client_free)>;

/// The talk with Avahi's daemon. Its objects belong to the client and end with it. The callbacks are C's and
/// run inside of iterate(), on this thread.
class Browser {
  public:
    BrowseReport run(std::chrono::milliseconds time, const std::stop_token& stop) {
        const Poll poll(avahi_simple_poll_new(), &avahi_simple_poll_free);
        int error = AVAHI_ERR_NO_MEMORY;
        const Client client(poll ? avahi_client_new(avahi_simple_poll_get(poll.get()), AvahiClientFlags{},
                                                    &Browser::onClient, this, &error)
                                 : nullptr,
                            &avahi_client_free);
        const bool isListening =
            client && avahi_service_browser_new(client.get(), AVAHI_IF_UNSPEC, AVAHI_PROTO_INET, kService,
                                                nullptr, AvahiLookupFlags{}, &Browser::onService, this);
        if (!isListening) {
            fail(client ? avahi_client_errno(client.get()) : error);
            return std::move(m_report);
        }
        const auto end = std::chrono::steady_clock::now() + time;
        while (!stop.stop_requested() && std::chrono::steady_clock::now() < end &&
               avahi_simple_poll_iterate(poll.get(), kTickMs) == 0) {
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
            static_cast<Browser*>(self)->fail(avahi_client_errno(client));
        }
    }

    static void onService(AvahiServiceBrowser* browser, AvahiIfIndex interface, AvahiProtocol protocol,
                          AvahiBrowserEvent event, const char* name, const char* type, const char* domain,
                          AvahiLookupResultFlags /*flags*/, void* self) {
        if (event == AVAHI_BROWSER_NEW) { // one that cannot be resolved is not there
            avahi_service_resolver_new(avahi_service_browser_get_client(browser), interface, protocol, name,
                                       type, domain, AVAHI_PROTO_INET, AvahiLookupFlags{},
                                       &Browser::onResolved, self);
        }
    }

    static void onResolved(AvahiServiceResolver* resolver, AvahiIfIndex /*interface*/,
                           AvahiProtocol /*protocol*/, AvahiResolverEvent event, const char* name,
                           const char* /*type*/, const char* /*domain*/, const char* /*host*/,
                           const AvahiAddress* address, std::uint16_t port, AvahiStringList* /*txt*/,
                           AvahiLookupResultFlags /*flags*/, void* self) {
        auto& places = static_cast<Browser*>(self)->m_report.places;
        if (event == AVAHI_RESOLVER_FOUND && port != 0 && places.size() < kMostPlaces) {
            std::array<char, AVAHI_ADDRESS_STR_MAX> spelled{};
            avahi_address_snprint(spelled.data(), spelled.size(), address);
            places.push_back({{spelled.data(), port}, text("announced as ", printable(name))});
        }
        avahi_service_resolver_free(resolver);
    }

    BrowseReport m_report;
};

} // namespace

BrowseReport browseForCameras(std::chrono::milliseconds time, const std::stop_token& stop) {
    return Browser().run(time, stop);
}

} // namespace spherewalk::camera
