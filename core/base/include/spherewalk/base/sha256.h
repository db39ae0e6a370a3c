// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/bytes.h"

#include <filesystem>
#include <memory>
#include <string>

namespace spherewalk {

/// SHA-256 of a stream of bytes, as 64 lower-case hexadecimal digits. Source: FIPS 180-4, by OpenSSL.
class Sha256 {
  public:
    Sha256();
    ~Sha256();
    Sha256(Sha256&&) noexcept;
    Sha256& operator=(Sha256&&) noexcept;

    void update(ByteView bytes);
    /// The digest of all that was given; the object cannot be updated afterwards.
    std::string hex();

  private:
    struct Context;
    std::unique_ptr<Context> m_context;
};

std::string sha256Hex(ByteView bytes);

/// Errors: NotFound, Io.
std::string sha256HexOfFile(const std::filesystem::path& file);

} // namespace spherewalk
