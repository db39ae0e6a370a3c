// SPDX-License-Identifier: GPL-3.0-or-later
// Requests and answers of HTTP/1.1, for small servers: the practice camera and the remote on a phone.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace spherewalk::http {

/// The order of header names, which do not distinguish capital letters.
struct HeaderOrder {
    bool operator()(const std::string& a, const std::string& b) const;
};

struct Request {
    std::string method; ///< In capital letters, as the client sent it.
    std::string target; ///< Path and query, as the client sent them.
    std::string path;   ///< Without the query; %41 stands for its byte.
    std::map<std::string, std::string> query;
    std::map<std::string, std::string, HeaderOrder> headers; ///< The first value counts.
    std::string body;
    bool keepsAlive = true; ///< The client expects to send another request.

    /// The value of the header; "" if the request has none.
    std::string header(const std::string& name) const;
    /// Whether the header has this value, in whatever letters.
    bool says(const std::string& name, std::string_view word) const;
};

/// The request that starts with these lines, without its body. head: ends before the empty line. Returns
/// nothing for text that is no HTTP/1.0 or HTTP/1.1 request. Source: RFC 9112, sections 3 and 5.
std::optional<Request> parseRequestHead(std::string_view head);

/// The length of the body that the request announces: 0 without a Content-Length, and nothing for a length
/// that is no number. Source: RFC 9110, 8.6.
std::optional<std::size_t> contentLength(const Request& request);

struct Answer {
    int status = 200;
    std::string type; ///< Content-Type; empty for none.
    std::string body;
    std::vector<std::pair<std::string, std::string>> headers = {};
};

/// The reason phrase of a status code, for the first line of an answer.
std::string_view reasonPhrase(int status);

} // namespace spherewalk::http
