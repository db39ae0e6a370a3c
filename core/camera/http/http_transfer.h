// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/camera/http.h"

#include <curl/curl.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <string>

namespace spherewalk::camera {

/// Errors: Internal if libcurl did not do what it always can.
void requireCurl(bool worked);

std::string secondsText(std::chrono::milliseconds duration);

using Easy = std::unique_ptr<CURL, decltype(&curl_easy_cleanup)>;
using Multi = std::unique_ptr<CURLM, decltype(&curl_multi_cleanup)>;
using HeaderList = std::unique_ptr<curl_slist, decltype(&curl_slist_free_all)>;

struct HttpClient::Handles {
    Handles() { requireCurl(multi != nullptr && easy != nullptr); }

    Multi multi{curl_multi_init(), &curl_multi_cleanup};
    Easy easy{curl_easy_init(), &curl_easy_cleanup};
};

/// One request and what has come back so far. libcurl's callbacks, which must not throw, work on it.
struct HttpClient::Transfer {
    Handles* handles = nullptr; ///< Handles of this request; null for those of the client.
    CURL* easy = nullptr;
    Sink sink; ///< Receiver of a download or a stream.
    Tick tick; ///< Called while waiting; it throws to end the request.
    std::uint64_t maxBytes = 0;
    std::chrono::milliseconds timeout{0}; ///< 0 leaves only the stall timeout.
    HttpResponse response;
    std::uint64_t headerBytes = 0;
    bool isTooLarge = false;
    std::exception_ptr sinkFailure;

    long status() const;
    bool take(ByteView bytes);
    static std::size_t onBody(char* data, std::size_t size, std::size_t count, void* self);
    static std::size_t onHeader(char* data, std::size_t size, std::size_t count, void* self);
};

} // namespace spherewalk::camera
