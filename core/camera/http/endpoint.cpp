// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/camera/endpoint.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <charconv>

namespace spherewalk::camera {

namespace {

constexpr std::string_view kScheme = "http://";
constexpr std::size_t kMaxUrlLength = 2048;

bool isAlphanumeric(char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool isHostCharacter(char c) {
    return isAlphanumeric(c) || c == '.' || c == '-' || c == '_';
}

bool isIpv6Character(char c) {
    return isAlphanumeric(c) || c == ':' || c == '.' || c == '%';
}

[[noreturn]] void refuse(std::string_view address) {
    throw Error(ErrorKind::InvalidInput, text("The camera's address \"", printable(address),
                                              "\" cannot be used; write it like 192.168.1.1 or "
                                              "http://127.0.0.1:8080."));
}

int parsePort(std::string_view digits, std::string_view address) {
    int port = 0;
    const auto [end, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), port);
    if (failure != std::errc() || end != digits.data() + digits.size() || port < 1 || port > 65535) {
        refuse(address);
    }
    return port;
}

} // namespace

std::string Endpoint::name() const {
    const bool isIpv6 = host.find(':') != std::string::npos;
    return isIpv6 ? text("[", host, "]:", port) : text(host, ":", port);
}

std::string Endpoint::url(std::string_view path) const {
    return text(kScheme, name(), path);
}

Endpoint parseEndpoint(std::string_view address) {
    std::string_view rest = address;
    if (rest.starts_with(kScheme)) {
        rest.remove_prefix(kScheme.size());
    }
    if (rest.ends_with('/')) {
        rest.remove_suffix(1);
    }
    Endpoint endpoint;
    std::string_view port;
    if (rest.starts_with('[')) {
        const std::size_t bracket = rest.find(']');
        if (bracket == std::string_view::npos) {
            refuse(address);
        }
        endpoint.host = rest.substr(1, bracket - 1);
        port = rest.substr(bracket + 1);
        if (!std::all_of(endpoint.host.begin(), endpoint.host.end(), isIpv6Character)) {
            refuse(address);
        }
    } else {
        const std::size_t colon = std::min(rest.find(':'), rest.size());
        endpoint.host = rest.substr(0, colon);
        port = rest.substr(colon);
        if (!std::all_of(endpoint.host.begin(), endpoint.host.end(), isHostCharacter)) {
            refuse(address);
        }
    }
    if (endpoint.host.empty() || endpoint.host.size() > 253 || (!port.empty() && port.front() != ':')) {
        refuse(address);
    }
    if (!port.empty()) {
        endpoint.port = parsePort(port.substr(1), address);
    }
    return endpoint;
}

std::string pathOfUrl(std::string_view url) {
    std::string_view path = url;
    const std::size_t scheme = path.find("://");
    const bool isAbsolute = scheme < 8; // "https" is long enough, and "not found" is longer
    if (isAbsolute) {
        path.remove_prefix(scheme + 3);
        path.remove_prefix(std::min(path.find('/'), path.size()));
    }
    path = path.substr(0, path.find('#'));
    const bool isClean = std::all_of(path.begin(), path.end(), [](char c) { return c > ' ' && c < 0x7f; });
    if (path.size() > kMaxUrlLength || !isClean || (isAbsolute && path.size() < 2) || path.empty()) {
        throw Error(ErrorKind::Corrupt, text("The camera named a photo by \"", printable(url),
                                             "\", which is not a usable URL; update its firmware."));
    }
    if (path.front() != '/') {
        throw Error(ErrorKind::Unsupported, text("The camera names photos as API level 1 does (\"",
                                                 printable(url), "\"); such cameras cannot be used yet."));
    }
    return std::string(path);
}

std::string fileNameOfUrl(std::string_view url) {
    std::string path = pathOfUrl(url);
    path = path.substr(0, path.find('?'));
    std::string name = path.substr(path.rfind('/') + 1).substr(0, 100);
    std::replace_if(
        name.begin(), name.end(), [](char c) { return !isHostCharacter(c); }, '_');
    if (name.empty() || name.front() == '.') {
        name.insert(name.begin(), '_');
    }
    return name;
}

} // namespace spherewalk::camera
