// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/bytes.h"

#include <openssl/evp.h>

#include <memory>
#include <string>

namespace spherewalk {

/// One of OpenSSL's digests of a stream of bytes. Errors of all: Internal.
class EvpDigest {
  public:
    explicit EvpDigest(const EVP_MD* kind);

    void update(ByteView bytes);
    /// As lower-case hexadecimal digits; the object cannot be updated afterwards.
    std::string hex();

  private:
    std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> m_context{EVP_MD_CTX_new(), &EVP_MD_CTX_free};
};

} // namespace spherewalk
