// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/bytes.h"

#include <filesystem>
#include <memory>
#include <string>

namespace spherewalk {

/// SHA-256 of a stream of bytes. Errors of all functions: Internal if OpenSSL refuses to work.
/// Source: FIPS 180-4, computed by OpenSSL.
class Sha256 {
  public:
    Sha256();
    ~Sha256();
    Sha256(Sha256&&) noexcept;
    Sha256& operator=(Sha256&&) noexcept;

    /// Appends bytes to the stream.
    void update(ByteView bytes);
    /// The digest of the whole stream, as 64 lower-case hexadecimal digits. No update() may follow.
    std::string hex();

  private:
    struct Context;
    std::unique_ptr<Context> m_context;
};

/// The SHA-256 of the bytes, as 64 lower-case hexadecimal digits.
std::string sha256Hex(ByteView bytes);

/// The SHA-256 of a whole file, which is read in pieces. Errors: NotFound, Io.
std::string sha256HexOfFile(const std::filesystem::path& file);

/// The MD5 of the bytes, as 32 lower-case hexadecimal digits. Only protocols that demand MD5 may use it,
/// because MD5 proves nothing. Source: RFC 1321, computed by OpenSSL.
std::string md5Hex(ByteView bytes);

/// A new random identifier in lower case, such as "0b5a9c6e-7d4f-4a37-9c1b-2f6d1e8a4c03".
/// Source: RFC 4122, version 4.
std::string randomUuid();

} // namespace spherewalk
