// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/camera/http.h"

#include "http/http_transfer.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <memory>
#include <utility>

namespace spherewalk::camera {

namespace {

constexpr std::uint64_t kStallBytes = 16 << 10;
constexpr int kUnauthorised = 401;

void initialiseOnce() {
    static const CURLcode result = curl_global_init(CURL_GLOBAL_DEFAULT);
    requireCurl(result == CURLE_OK);
}

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

void requireHttpTime(const char* option, std::chrono::milliseconds value) {
    if (value < std::chrono::milliseconds(1) || value > std::chrono::minutes(10)) {
        throw Error(ErrorKind::InvalidInput,
                    text("The HTTP option ", option, " must lie between 1 ms and 10 min."));
    }
}

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

void HttpOptions::validate() const {
    requireHttpTime("connectTimeout", connectTimeout);
    requireHttpTime("requestTimeout", requestTimeout);
    requireHttpTime("stallTimeout", stallTimeout);
    if (maxAnswerBytes < 1024 || maxAnswerBytes > (1ULL << 30)) {
        throw Error(ErrorKind::InvalidInput,
                    "The HTTP option maxAnswerBytes must lie between 1 kB and 1 GB.");
    }
}

HttpClient::HttpClient(Endpoint endpoint, HttpOptions options)
    : m_endpoint(std::move(endpoint)), m_options(std::move(options)) {
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
#if LIBCURL_VERSION_NUM < 0x075500
    worked &= curl_easy_setopt(easy, CURLOPT_PROTOCOLS, long{CURLPROTO_HTTP}) == CURLE_OK;
#else
    worked &= curl_easy_setopt(easy, CURLOPT_PROTOCOLS_STR, "http") == CURLE_OK;
#endif
    worked &= curl_easy_setopt(easy, CURLOPT_NOPROXY, "*") == CURLE_OK;
    worked &= curl_easy_setopt(easy, CURLOPT_NOSIGNAL, 1L) == CURLE_OK;
    worked &= curl_easy_setopt(easy, CURLOPT_FOLLOWLOCATION, 0L) == CURLE_OK;
    worked &= curl_easy_setopt(easy, CURLOPT_HTTP_VERSION, long{CURL_HTTP_VERSION_1_1}) == CURLE_OK;
#if LIBCURL_VERSION_NUM >= 0x075700
    // A stopped look-up of a host's name is left behind rather than waited for.
    worked &= curl_easy_setopt(easy, CURLOPT_QUICK_EXIT, 1L) == CURLE_OK;
#endif
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
                                                     " stood still for ", secondsText(m_options.stallTimeout),
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

void CredentialsMemory::set(const Credentials& credentials) {
    const std::scoped_lock lock(m_mutex);
    m_credentials = credentials;
    ++m_revision;
}

std::optional<Credentials> CredentialsMemory::newer(int& given) const {
    const std::scoped_lock lock(m_mutex);
    return std::exchange(given, m_revision) < m_revision ? m_credentials : std::nullopt;
}

CredentialsSource rememberingCredentials(CredentialsSource ask) {
    struct Shared {
        std::mutex asking;
        CredentialsMemory memory;
    };

    return [ask = std::move(ask), shared = std::make_shared<Shared>(), given = 0]() mutable {
        const std::scoped_lock lock(shared->asking);
        if (auto known = shared->memory.newer(given)) {
            return known;
        }
        if (const auto said = ask()) {
            shared->memory.set(*said);
        }
        return shared->memory.newer(given);
    };
}

} // namespace spherewalk::camera
