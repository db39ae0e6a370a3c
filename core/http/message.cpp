// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/http/message.h"

#include <algorithm>
#include <cctype>
#include <charconv>

namespace spherewalk::http {

namespace {

char lowered(char c) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

bool isSameWord(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](char x, char y) { return lowered(x) == lowered(y); });
}

std::string_view withoutBlanks(std::string_view words) {
    const std::size_t begin = words.find_first_not_of(" \t");
    return begin == std::string_view::npos ? std::string_view()
                                           : words.substr(begin, words.find_last_not_of(" \t") + 1 - begin);
}

/// Cuts off the part before the separator, or all where there is none.
std::string_view cutUntil(std::string_view& words, std::string_view separator) {
    const std::size_t end = std::min(words.find(separator), words.size());
    const std::string_view part = words.substr(0, end);
    words.remove_prefix(std::min(end + separator.size(), words.size()));
    return part;
}

/// The text that a part of a URL spells. A percent sign without two digits stands for itself.
std::string unescaped(std::string_view part) {
    std::string spelled;
    for (std::size_t i = 0; i < part.size(); ++i) {
        unsigned byte = 0;
        const char* const digits = part.data() + i + 1;
        if (part[i] == '%' && i + 2 < part.size() &&
            std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2) {
            spelled += static_cast<char>(byte);
            i += 2;
        } else {
            spelled += part[i];
        }
    }
    return spelled;
}

} // namespace

bool HeaderOrder::operator()(const std::string& a, const std::string& b) const {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(),
                                        [](char x, char y) { return lowered(x) < lowered(y); });
}

std::string Request::header(const std::string& name) const {
    const auto found = headers.find(name);
    return found == headers.end() ? std::string() : found->second;
}

bool Request::says(const std::string& name, std::string_view word) const {
    return isSameWord(header(name), word);
}

std::optional<Request> parseRequestHead(std::string_view head) {
    std::string_view line = cutUntil(head, "\r\n");
    Request request;
    request.method = cutUntil(line, " ");
    request.target = cutUntil(line, " ");
    const bool isMethod = !request.method.empty() && std::all_of(request.method.begin(), request.method.end(),
                                                                 [](char c) { return c >= 'A' && c <= 'Z'; });
    if (!isMethod || request.target.empty() || (line != "HTTP/1.1" && line != "HTTP/1.0")) {
        return std::nullopt;
    }
    const bool isOld = line == "HTTP/1.0";
    std::string_view query = request.target;
    request.path = unescaped(cutUntil(query, "?"));
    while (!query.empty()) {
        std::string_view value = cutUntil(query, "&");
        const std::string key = unescaped(cutUntil(value, "="));
        request.query.emplace(key, unescaped(value));
    }
    while (!head.empty()) {
        line = cutUntil(head, "\r\n");
        const std::size_t colon = line.find(':');
        if (colon == 0 || colon == std::string_view::npos ||
            line.substr(0, colon).find(' ') != std::string_view::npos) {
            return std::nullopt;
        }
        request.headers.emplace(line.substr(0, colon), withoutBlanks(line.substr(colon + 1)));
    }
    request.keepsAlive =
        isOld ? request.says("Connection", "keep-alive") : !request.says("Connection", "close");
    return request;
}

std::optional<std::size_t> contentLength(const Request& request) {
    const std::string spelled = request.header("Content-Length");
    std::size_t length = 0;
    const char* const end = spelled.data() + spelled.size();
    const auto [stop, failure] = std::from_chars(spelled.data(), end, length);
    const bool isNumber = failure == std::errc() && stop == end;
    return isNumber || spelled.empty() ? std::optional(length) : std::nullopt;
}

std::string_view reasonPhrase(int status) {
    switch (status) {
    case 200:
        return "OK";
    case 400:
        return "Bad Request";
    case 401:
        return "Unauthorized";
    case 403:
        return "Forbidden";
    case 404:
        return "Not Found";
    case 405:
        return "Method Not Allowed";
    case 409:
        return "Conflict";
    case 411:
        return "Length Required";
    case 413:
        return "Payload Too Large";
    case 431:
        return "Request Header Fields Too Large";
    case 503:
        return "Service Unavailable";
    default:
        return "Internal Server Error";
    }
}

} // namespace spherewalk::http
