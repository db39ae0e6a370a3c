// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace spherewalk::camera {

/// Address at which a camera answers. It is plain HTTP, because spherical cameras offer nothing else over
/// WiFi.
struct Endpoint {
    std::string host = "192.168.1.1"; ///< Name, IPv4 address, or IPv6 address without brackets.
    int port = 80;

    bool operator==(const Endpoint&) const = default;

    /// "192.168.1.1:80", for sentences.
    std::string name() const;
    /// The URL of a path at this camera. Range: the path begins with a slash.
    std::string url(std::string_view path) const;
};

/// Reads what an operator types: "192.168.1.1", "camera.local:8080", "http://127.0.0.1:8080/", "[::1]:80".
/// Errors: InvalidInput, for anything else, https included.
Endpoint parseEndpoint(std::string_view address);

/// Path and query of a file's URL, whatever scheme, host and port the camera wrote: those are replaced by the
/// ones at which it was reached. Two URLs with the same path are the same file of one camera.
/// Errors: Corrupt, for a text that is no absolute URL or path, is longer than 2048 characters, or holds
/// spaces or control characters; Unsupported for the relative file names of API level 1.
std::string pathOfUrl(std::string_view url);

/// The last part of the URL's path, with everything but letters, digits, '.', '-' and '_' replaced, so that
/// it can be a file's name anywhere: "R0010049.JPG".
std::string fileNameOfUrl(std::string_view url);

} // namespace spherewalk::camera
