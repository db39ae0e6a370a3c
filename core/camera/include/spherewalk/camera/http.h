// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/bytes.h"
#include "spherewalk/camera/endpoint.h"

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

namespace spherewalk::camera {

/// Name and password of a user of a camera in client mode.
struct Credentials {
    std::string user;
    std::string password;

    bool operator==(const Credentials&) const = default;
};

/// Gives credentials from a keychain, the environment or a person; nothing if there are none. It is called
/// when a camera asks who connects, and again when the camera refuses the answer. Threads: the client's.
using CredentialsSource = std::function<std::optional<Credentials>()>;

/// The latest credentials for all clients of one camera. Threads: any, also at the same time.
class CredentialsMemory {
  public:
    void set(const Credentials& credentials);

    /// The credentials if they are newer than those that this client got last; otherwise nothing. given: the
    /// client's own counter, 0 at first; this function advances it.
    std::optional<Credentials> newer(int& given) const;

  private:
    mutable std::mutex m_mutex;
    std::optional<Credentials> m_credentials;
    int m_revision = 0;
};

/// A source whose copies share one answer. `ask` is called once for all copies, and again only after a
/// refusal, by one thread at a time.
CredentialsSource rememberingCredentials(CredentialsSource ask);

/// Limits of all requests.
struct HttpOptions {
    std::chrono::milliseconds connectTimeout{5'000};
    std::chrono::milliseconds requestTimeout{20'000}; ///< Whole time of an ordinary request.
    std::chrono::milliseconds stallTimeout{15'000};   ///< Longest time for 16 kB of a download.
    std::uint64_t maxAnswerBytes = 1 << 20;           ///< Largest answer to an ordinary request.
    CredentialsSource credentials = {}; ///< Without a source an answer 401 is returned as it is.

    /// Errors: InvalidInput, with the option and its range.
    void validate() const;
};

/// What a server answered, whatever the status.
struct HttpResponse {
    int status = 0;
    std::string contentType; ///< Content type as sent, in lower case.
    std::string body;        ///< The body; of a download only if the status is not 200, and at most 64 kB.
    std::optional<std::uint64_t> declaredBytes; ///< Content-Length, if the answer had one.
    std::uint64_t receivedBytes = 0;
};

/// HTTP to one camera over libcurl: no proxy, no redirect, no HTTPS, every size and time bounded. If the
/// camera asks for it, with digest authentication: an answer 401 is returned only if no credentials are
/// accepted. Errors of all requests: Network (not reached, or the connection broke), Timeout, Stopped,
/// Corrupt (more bytes than allowed), Unsupported (what answers does not speak HTTP). An error status is a
/// response. Stop: within 200 ms, also while connecting or waiting. Threads: one at a time.
class HttpClient {
  public:
    using Sink = std::function<void(ByteView)>;
    using Tick = std::function<void()>;

    /// Errors: InvalidInput.
    explicit HttpClient(Endpoint endpoint, HttpOptions options = {});
    ~HttpClient();
    HttpClient(const HttpClient&) = delete;
    HttpClient& operator=(const HttpClient&) = delete;

    const Endpoint& endpoint() const { return m_endpoint; }

    HttpResponse get(std::string_view path, const std::stop_token& stop);

    /// Sends JSON. For repeatable commands only: on a connection kept alive from an earlier request libcurl
    /// sends a POST a second time by itself if the server closes without answering (seen with 7.88).
    HttpResponse post(std::string_view path, const std::string& json, const std::stop_token& stop,
                      std::optional<std::chrono::milliseconds> timeout = std::nullopt);

    /// Sends JSON on a connection of its own, which makes libcurl send it at most once; a second time only if
    /// the camera has answered 401, which proves that it did nothing. After an error other than InvalidInput
    /// it is unknown whether the camera acted on it.
    HttpResponse postOnce(std::string_view path, const std::string& json, const std::stop_token& stop);

    /// Gives the body of a 200 answer to the sink piece by piece. Errors: also whatever the sink throws;
    /// Network for a body shorter than its Content-Length. A body without a Content-Length that is cut short
    /// looks complete: the caller must verify.
    /// json: sent with POST, if not empty.
    HttpResponse download(std::string_view path, std::uint64_t maxBytes, const Sink& sink,
                          const std::stop_token& stop, const std::string& json = {});

    /// Sends JSON, as postOnce() does, and gives the endless body of a 200 answer to the sink, until the
    /// server ends it. tick: called at least ten times a second, from the first moment; how long to wait for
    /// what is its to say, by throwing. Errors: also whatever sink and tick throw.
    HttpResponse stream(std::string_view path, const std::string& json, const Sink& sink, const Tick& tick,
                        const std::stop_token& stop);

  private:
    struct Handles;
    struct Transfer;
    enum class Repeat { Allowed, Never };

    HttpResponse send(std::string_view path, const std::string& json, Repeat repeat,
                      std::chrono::milliseconds timeout, const std::stop_token& stop);
    void prepare(Transfer& transfer, std::string_view path);
    HttpResponse authorised(const std::function<HttpResponse()>& request, const std::stop_token& stop);
    bool authorise(const std::stop_token& stop);
    bool areAccepted(const std::stop_token& stop);
    HttpResponse getOnce(std::string_view path, const std::stop_token& stop);
    HttpResponse perform(Transfer& transfer, const std::stop_token& stop);
    [[noreturn]] void fail(const Transfer& transfer, int code) const;

    Endpoint m_endpoint;
    HttpOptions m_options;
    std::unique_ptr<Handles> m_handles;
    std::optional<Credentials> m_credentials; ///< Credentials that were accepted or are about to be tried.
};

} // namespace spherewalk::camera
