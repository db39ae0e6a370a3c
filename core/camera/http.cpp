// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/camera/http.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/base/text.h"

#include <curl/curl.h>

#include <algorithm>
#include <exception>
#include <utility>

namespace spherewalk::camera {

namespace {

constexpr std::uint64_t kMaxErrorBodyBytes = 64 << 10;
constexpr std::uint64_t kMaxHeaderBytes = 64 << 10;
constexpr std::uint64_t kStallBytes = 16 << 10;
constexpr int kTickMs = 100; // in case a wake-up is missed, a stop is seen at the next tick
constexpr int kOk = 200;
constexpr int kUnauthorised = 401;

void requireCurl(bool worked) {
    if (!worked) {
        throw Error(ErrorKind::Internal, "libcurl could not be set up; check the installation.");
    }
}

void initialiseOnce() {
    static const CURLcode result = curl_global_init(CURL_GLOBAL_DEFAULT);
    requireCurl(result == CURLE_OK);
}

using Easy = std::unique_ptr<CURL, decltype(&curl_easy_cleanup)>;
using Multi = std::unique_ptr<CURLM, decltype(&curl_multi_cleanup)>;
using HeaderList = std::unique_ptr<curl_slist, decltype(&curl_slist_free_all)>;

HeaderList jsonHeaders(const char* accept) {
    curl_slist* list = nullptr;
    for (const char* header :
         {"Content-Type: application/json;charset=utf-8", accept, "X-XSRF-Protected: 1", "Expect:"}) {
        curl_slist* longer = curl_slist_append(list, header);
        requireCurl(longer != nullptr);
        list = longer;
    }
    return {list, &curl_slist_free_all};
}

std::string lowerCase(std::string_view text) {
    std::string lower(text);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return lower;
}

std::string seconds(std::chrono::milliseconds duration) {
    return text(std::chrono::duration<double>(duration).count(), " s");
}

void requireTime(const char* option, std::chrono::milliseconds value) {
    if (value < std::chrono::milliseconds(1) || value > std::chrono::minutes(10)) {
        throw Error(ErrorKind::InvalidInput,
                    text("The HTTP option ", option, " must lie between 1 ms and 10 min."));
    }
}

} // namespace

void HttpOptions::validate() const {
    requireTime("connectTimeout", connectTimeout);
    requireTime("requestTimeout", requestTimeout);
    requireTime("stallTimeout", stallTimeout);
    if (maxAnswerBytes < 1024 || maxAnswerBytes > (1ULL << 30)) {
        throw Error(ErrorKind::InvalidInput,
                    "The HTTP option maxAnswerBytes must lie between 1 kB and 1 GB.");
    }
}

struct HttpClient::Handles {
    Handles() { requireCurl(multi != nullptr && easy != nullptr); }

    Multi multi{curl_multi_init(), &curl_multi_cleanup};
    Easy easy{curl_easy_init(), &curl_easy_cleanup};
};

namespace {

/// Notices when too few bytes arrive for too long.
class StallWatch {
  public:
    using Steady = std::chrono::steady_clock;

    explicit StallWatch(std::chrono::milliseconds limit) : m_limit(limit) {}

    bool hasStalled(std::uint64_t receivedBytes) {
        const auto now = Steady::now();
        if (receivedBytes >= m_bytesAtStart + kStallBytes) {
            m_bytesAtStart = receivedBytes;
            m_start = now;
        }
        return now - m_start > m_limit;
    }

  private:
    std::chrono::milliseconds m_limit;
    Steady::time_point m_start = Steady::now();
    std::uint64_t m_bytesAtStart = 0;
};

void setBody(CURL* easy, curl_slist* headers, const std::string& json) {
    bool worked = curl_easy_setopt(easy, CURLOPT_HTTPHEADER, headers) == CURLE_OK;
    worked &= curl_easy_setopt(easy, CURLOPT_POSTFIELDS, json.c_str()) == CURLE_OK;
    worked &= curl_easy_setopt(easy, CURLOPT_POSTFIELDSIZE, static_cast<long>(json.size())) == CURLE_OK;
    requireCurl(worked);
}

} // namespace

/// One request and what has come back so far. libcurl's callbacks, which must not throw, work on it.
struct HttpClient::Transfer {
    Handles* handles = nullptr; ///< of its own; none: the client's
    CURL* easy = nullptr;
    Sink sink; ///< of a download or a stream
    Tick tick; ///< whether to wait longer; throws if not
    std::uint64_t maxBytes = 0;
    std::chrono::milliseconds timeout{0}; ///< 0: only the stall timeout
    HttpResponse response;
    std::uint64_t headerBytes = 0;
    bool isTooLarge = false;
    std::exception_ptr sinkFailure;

    long status() const {
        long code = 0;
        curl_easy_getinfo(easy, CURLINFO_RESPONSE_CODE, &code);
        return code;
    }

    bool take(ByteView bytes) {
        const bool goesToSink = sink && status() == kOk;
        response.receivedBytes += bytes.size();
        if (response.receivedBytes > (sink && !goesToSink ? kMaxErrorBodyBytes : maxBytes)) {
            isTooLarge = true;
            return false;
        }
        if (!goesToSink) {
            response.body += textOf(bytes);
            return true;
        }
        try {
            sink(bytes);
            return true;
        } catch (...) {
            sinkFailure = std::current_exception(); // rethrown when libcurl has let go
            return false;
        }
    }

    static std::size_t onBody(char* data, std::size_t size, std::size_t count, void* self) {
        const bool taken = static_cast<Transfer*>(self)->take(bytesOf({data, size * count}));
        return taken ? size * count : 0;
    }

    static std::size_t onHeader(char* /*data*/, std::size_t size, std::size_t count, void* self) {
        auto& transfer = *static_cast<Transfer*>(self);
        transfer.headerBytes += size * count;
        transfer.isTooLarge = transfer.headerBytes > kMaxHeaderBytes;
        return transfer.isTooLarge ? 0 : size * count;
    }
};

HttpClient::HttpClient(Endpoint endpoint, HttpOptions options)
    : m_endpoint(std::move(endpoint)), m_options(options) {
    m_options.validate();
    initialiseOnce();
    m_handles = std::make_unique<Handles>();
}

HttpClient::~HttpClient() = default;

void HttpClient::prepare(Transfer& transfer, std::string_view path) {
    if (transfer.handles == nullptr) {
        transfer.handles = m_handles.get();
    }
    // Not reset, which would forget the nonce: all that any request sets is set here.
    CURL* easy = transfer.handles->easy.get();
    transfer.easy = easy;
    const std::string url = m_endpoint.url(path);
    bool worked = curl_easy_setopt(easy, CURLOPT_URL, url.c_str()) == CURLE_OK;
    worked &= curl_easy_setopt(easy, CURLOPT_PROTOCOLS_STR, "http") == CURLE_OK;
    worked &= curl_easy_setopt(easy, CURLOPT_NOPROXY, "*") == CURLE_OK;
    worked &= curl_easy_setopt(easy, CURLOPT_NOSIGNAL, 1L) == CURLE_OK;
    worked &= curl_easy_setopt(easy, CURLOPT_FOLLOWLOCATION, 0L) == CURLE_OK;
    worked &= curl_easy_setopt(easy, CURLOPT_HTTP_VERSION, long{CURL_HTTP_VERSION_1_1}) == CURLE_OK;
    // A stopped look-up of a host's name is left behind rather than waited for.
    worked &= curl_easy_setopt(easy, CURLOPT_QUICK_EXIT, 1L) == CURLE_OK;
    const auto milliseconds = [](std::chrono::milliseconds time) { return static_cast<long>(time.count()); };
    worked &=
        curl_easy_setopt(easy, CURLOPT_CONNECTTIMEOUT_MS, milliseconds(m_options.connectTimeout)) == CURLE_OK;
    worked &= curl_easy_setopt(easy, CURLOPT_TIMEOUT_MS, milliseconds(transfer.timeout)) == CURLE_OK;
    worked &= curl_easy_setopt(easy, CURLOPT_WRITEFUNCTION, &Transfer::onBody) == CURLE_OK;
    worked &= curl_easy_setopt(easy, CURLOPT_WRITEDATA, &transfer) == CURLE_OK;
    worked &= curl_easy_setopt(easy, CURLOPT_HEADERFUNCTION, &Transfer::onHeader) == CURLE_OK;
    worked &= curl_easy_setopt(easy, CURLOPT_HEADERDATA, &transfer) == CURLE_OK;
    worked &= curl_easy_setopt(easy, CURLOPT_HTTPGET, 1L) == CURLE_OK;
    worked &= curl_easy_setopt(easy, CURLOPT_HTTPHEADER, nullptr) == CURLE_OK;
    worked &= curl_easy_setopt(easy, CURLOPT_FRESH_CONNECT, 0L) == CURLE_OK;
    worked &= curl_easy_setopt(easy, CURLOPT_FORBID_REUSE, 0L) == CURLE_OK;
    if (m_credentials) {
        worked &= curl_easy_setopt(easy, CURLOPT_HTTPAUTH, long{CURLAUTH_DIGEST}) == CURLE_OK;
        worked &= curl_easy_setopt(easy, CURLOPT_USERNAME, m_credentials->user.c_str()) == CURLE_OK;
        worked &= curl_easy_setopt(easy, CURLOPT_PASSWORD, m_credentials->password.c_str()) == CURLE_OK;
    }
    requireCurl(worked);
}

/// The request, and once more if the camera wants to know who asks.
HttpResponse HttpClient::authorised(const std::function<HttpResponse()>& request,
                                    const std::stop_token& stop) {
    HttpResponse response = request();
    if (response.status == kUnauthorised && m_options.credentials && authorise(stop)) {
        return request();
    }
    return response;
}

/// Tries credentials with a request that does nothing, until they are accepted or there are no others.
bool HttpClient::authorise(const std::stop_token& stop) {
    constexpr int kMostTries = 3;
    std::optional<Credentials> refused;
    for (int tries = 0; tries < kMostTries; ++tries) {
        if (!m_credentials) {
            m_credentials = m_options.credentials();
        }
        if (!m_credentials || m_credentials == refused) {
            m_credentials.reset();
            return false;
        }
        if (areAccepted(stop)) {
            return true;
        }
        refused = std::exchange(m_credentials, std::nullopt);
    }
    return false;
}

bool HttpClient::areAccepted(const std::stop_token& stop) {
    curl_easy_reset(m_handles->easy.get()); // an old nonce would be taken for a refused password
    try {
        const bool result = getOnce("/osc/info", stop).status != kUnauthorised;
        curl_easy_reset(m_handles->easy.get()); // the nonce may have been good for this once
        return result;
    } catch (const Error&) {
        m_credentials.reset();
        throw;
    }
}

HttpResponse HttpClient::get(std::string_view path, const std::stop_token& stop) {
    return authorised([&] { return getOnce(path, stop); }, stop);
}

HttpResponse HttpClient::getOnce(std::string_view path, const std::stop_token& stop) {
    Transfer transfer;
    transfer.maxBytes = m_options.maxAnswerBytes;
    transfer.timeout = m_options.requestTimeout;
    prepare(transfer, path);
    return perform(transfer, stop);
}

HttpResponse HttpClient::send(std::string_view path, const std::string& json, Repeat repeat,
                              std::chrono::milliseconds timeout, const std::stop_token& stop) {
    Transfer transfer;
    // The answer to a challenge goes on any connection that is kept alive, whatever is asked for, and there
    // libcurl would repeat it: so there is none.
    std::optional<Handles> own;
    if (repeat == Repeat::Never && m_credentials) {
        transfer.handles = &own.emplace();
    }
    transfer.maxBytes = m_options.maxAnswerBytes;
    transfer.timeout = timeout;
    prepare(transfer, path);
    const HeaderList headers = jsonHeaders("Accept: application/json");
    setBody(transfer.easy, headers.get(), json);
    const long isOwnConnection = repeat == Repeat::Never ? 1 : 0;
    requireCurl(curl_easy_setopt(transfer.easy, CURLOPT_FRESH_CONNECT, isOwnConnection) == CURLE_OK &&
                curl_easy_setopt(transfer.easy, CURLOPT_FORBID_REUSE, isOwnConnection) == CURLE_OK);
    return perform(transfer, stop);
}

HttpResponse HttpClient::post(std::string_view path, const std::string& json, const std::stop_token& stop,
                              std::optional<std::chrono::milliseconds> timeout) {
    const auto time = timeout.value_or(m_options.requestTimeout);
    return authorised([&] { return send(path, json, Repeat::Allowed, time, stop); }, stop);
}

HttpResponse HttpClient::postOnce(std::string_view path, const std::string& json,
                                  const std::stop_token& stop) {
    return authorised([&] { return send(path, json, Repeat::Never, m_options.requestTimeout, stop); }, stop);
}

HttpResponse HttpClient::download(std::string_view path, std::uint64_t maxBytes, const Sink& sink,
                                  const std::stop_token& stop, const std::string& json) {
    const HeaderList headers = jsonHeaders("Accept: image/jpeg, application/json");
    const auto request = [&] {
        Transfer transfer;
        transfer.maxBytes = maxBytes;
        transfer.sink = sink;
        transfer.tick = [this, &transfer, watch = StallWatch(m_options.stallTimeout)]() mutable {
            if (watch.hasStalled(transfer.response.receivedBytes)) {
                throw Error(ErrorKind::Timeout, text("The download from the camera at ", m_endpoint.name(),
                                                     " stood still for ", seconds(m_options.stallTimeout),
                                                     "; move closer to the camera and try again."));
            }
        };
        prepare(transfer, path);
        if (!json.empty()) {
            setBody(transfer.easy, headers.get(), json);
        }
        // What a server sends beyond the length that it announced must not be read as the next answer.
        requireCurl(curl_easy_setopt(transfer.easy, CURLOPT_FORBID_REUSE, 1L) == CURLE_OK);
        return perform(transfer, stop);
    };
    return authorised(request, stop);
}

HttpResponse HttpClient::stream(std::string_view path, const std::string& json, const Sink& sink,
                                const Tick& tick, const std::stop_token& stop) {
    const HeaderList headers = jsonHeaders("Accept: multipart/x-mixed-replace, application/json");
    const auto request = [&] {
        Transfer transfer;
        transfer.maxBytes = UINT64_MAX;
        transfer.sink = sink;
        transfer.tick = tick;
        prepare(transfer, path);
        setBody(transfer.easy, headers.get(), json);
        requireCurl(curl_easy_setopt(transfer.easy, CURLOPT_FRESH_CONNECT, 1L) == CURLE_OK &&
                    curl_easy_setopt(transfer.easy, CURLOPT_FORBID_REUSE, 1L) == CURLE_OK);
        return perform(transfer, stop);
    };
    return authorised(request, stop);
}

namespace {

/// Takes the handle out of the multi handle at the end, which also breaks off what is unfinished.
class Attachment {
  public:
    Attachment(CURLM* multi, CURL* easy) : m_multi(multi), m_easy(easy) {
        requireCurl(curl_multi_add_handle(multi, easy) == CURLM_OK);
    }

    ~Attachment() { curl_multi_remove_handle(m_multi, m_easy); }

    Attachment(const Attachment&) = delete;
    Attachment& operator=(const Attachment&) = delete;

  private:
    CURLM* m_multi;
    CURL* m_easy;
};

CURLcode resultOf(CURLM* multi) {
    int left = 0;
    while (const CURLMsg* message = curl_multi_info_read(multi, &left)) {
        if (message->msg == CURLMSG_DONE) {
            return message->data.result;
        }
    }
    return CURLE_RECV_ERROR;
}

} // namespace

// The easy interface looks at its progress callback only once a second while nothing arrives; driving the
// same handle through the multi interface lets a stop request wake the wait.
HttpResponse HttpClient::perform(Transfer& transfer, const std::stop_token& stop) {
    throwIfStopped(stop);
    CURLM* multi = transfer.handles->multi.get();
    const Attachment attachment(multi, transfer.easy);
    const std::stop_callback wakeUp(stop, [multi] { curl_multi_wakeup(multi); });
    for (int running = 1;;) {
        requireCurl(curl_multi_perform(multi, &running) == CURLM_OK);
        if (running == 0) {
            break;
        }
        throwIfStopped(stop);
        if (transfer.tick) {
            transfer.tick();
        }
        requireCurl(curl_multi_poll(multi, nullptr, 0, kTickMs, nullptr) == CURLM_OK);
    }
    const CURLcode result = resultOf(multi);
    if (transfer.sinkFailure) {
        std::rethrow_exception(transfer.sinkFailure);
    }
    if (result != CURLE_OK) {
        fail(transfer, result);
    }
    transfer.response.status = static_cast<int>(transfer.status());
    const char* type = nullptr;
    curl_easy_getinfo(transfer.easy, CURLINFO_CONTENT_TYPE, &type);
    transfer.response.contentType = lowerCase(type == nullptr ? "" : type);
    curl_off_t declared = -1;
    curl_easy_getinfo(transfer.easy, CURLINFO_CONTENT_LENGTH_DOWNLOAD_T, &declared);
    if (declared >= 0) {
        transfer.response.declaredBytes = static_cast<std::uint64_t>(declared);
    }
    return std::move(transfer.response);
}

void HttpClient::fail(const Transfer& transfer, int code) const {
    const std::string camera = text("the camera at ", m_endpoint.name());
    const std::string reason = curl_easy_strerror(static_cast<CURLcode>(code));
    if (transfer.isTooLarge) {
        throw Error(ErrorKind::Corrupt, text("What answers at ", m_endpoint.name(),
                                             " sent more than a camera would; check the address."));
    }
    long newConnections = 0;
    curl_easy_getinfo(transfer.easy, CURLINFO_NUM_CONNECTS, &newConnections);
    curl_off_t connectUs = 0;
    curl_easy_getinfo(transfer.easy, CURLINFO_CONNECT_TIME_T, &connectUs);
    switch (code) {
    case CURLE_OPERATION_TIMEDOUT:
        if (connectUs == 0) {
            throw Error(ErrorKind::Timeout,
                        text("Could not reach ", camera, " within ", seconds(m_options.connectTimeout),
                             "; press its power button in case it sleeps, and check that this computer is "
                             "on the camera's WiFi."),
                        reason);
        }
        throw Error(ErrorKind::Timeout,
                    text("No answer from ", camera, " within ", seconds(transfer.timeout),
                         "; press its power button in case it sleeps, and check the WiFi."),
                    reason);
    case CURLE_COULDNT_CONNECT:
    case CURLE_COULDNT_RESOLVE_HOST:
        throw Error(ErrorKind::Network,
                    text("Could not reach ", camera, " (", reason,
                         "); check that it is switched on, that no USB data cable is plugged in, and that "
                         "this computer is on its WiFi."),
                    reason);
    case CURLE_UNSUPPORTED_PROTOCOL:
    case CURLE_WEIRD_SERVER_REPLY:
        if (newConnections == 0) {
            break; // more likely the rest of an earlier answer that was longer than it said
        }
        throw Error(ErrorKind::Unsupported,
                    text("What answers at ", m_endpoint.name(),
                         " does not speak HTTP; check the address of the camera."),
                    reason);
    default:
        break;
    }
    throw Error(ErrorKind::Network,
                text("The connection to ", camera, " broke (", reason,
                     "); move closer to the camera, check the WiFi, and try again."),
                reason);
}

} // namespace spherewalk::camera
