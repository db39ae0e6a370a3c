// SPDX-License-Identifier: GPL-3.0-or-later
#include "http/http_transfer.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <utility>

namespace spherewalk::camera {

namespace {

constexpr std::uint64_t kMaxErrorBodyBytes = 64 << 10;
constexpr std::uint64_t kMaxHeaderBytes = 64 << 10;
constexpr int kTickMs = 100; // in case a wake-up is missed, a stop is seen at the next tick
constexpr int kOk = 200;

std::string lowerCase(std::string_view text) {
    std::string lower(text);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return lower;
}

} // namespace

void requireCurl(bool worked) {
    if (!worked) {
        throw Error(ErrorKind::Internal, "libcurl could not be set up; check the installation.");
    }
}

std::string secondsText(std::chrono::milliseconds duration) {
    return text(std::chrono::duration<double>(duration).count(), " s");
}

long HttpClient::Transfer::status() const {
    long code = 0;
    curl_easy_getinfo(easy, CURLINFO_RESPONSE_CODE, &code);
    return code;
}

bool HttpClient::Transfer::take(ByteView bytes) {
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

std::size_t HttpClient::Transfer::onBody(char* data, std::size_t size, std::size_t count, void* self) {
    const bool taken = static_cast<Transfer*>(self)->take(bytesOf({data, size * count}));
    return taken ? size * count : 0;
}

std::size_t HttpClient::Transfer::onHeader(char* /*data*/, std::size_t size, std::size_t count, void* self) {
    auto& transfer = *static_cast<Transfer*>(self);
    transfer.headerBytes += size * count;
    transfer.isTooLarge = transfer.headerBytes > kMaxHeaderBytes;
    return transfer.isTooLarge ? 0 : size * count;
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
                        text("Could not reach ", camera, " within ", secondsText(m_options.connectTimeout),
                             "; press its power button in case it sleeps, and check that this computer is "
                             "on the camera's WiFi."),
                        reason);
        }
        throw Error(ErrorKind::Timeout,
                    text("No answer from ", camera, " within ", secondsText(transfer.timeout),
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
