// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/base/digest.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"

#include <openssl/evp.h>

#include <array>
#include <random>
#include <string_view>

namespace spherewalk {

namespace {

constexpr std::string_view kHexDigits = "0123456789abcdef";

void requireSuccess(int evpResult) {
    if (evpResult != 1) {
        throw Error(ErrorKind::Internal, "A digest of OpenSSL failed; check the OpenSSL installation.");
    }
}

} // namespace

/// One of OpenSSL's digests of a stream of bytes.
class EvpDigest {
  public:
    explicit EvpDigest(const EVP_MD* kind) {
        requireSuccess(EVP_DigestInit_ex(m_context.get(), kind, nullptr));
    }

    void update(ByteView bytes) {
        requireSuccess(EVP_DigestUpdate(m_context.get(), bytes.data(), bytes.size()));
    }

    std::string hex() {
        std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
        unsigned int size = 0;
        requireSuccess(EVP_DigestFinal_ex(m_context.get(), digest.data(), &size));
        std::string result;
        for (unsigned int i = 0; i < size; ++i) {
            result += kHexDigits[digest[i] >> 4];
            result += kHexDigits[digest[i] & 15];
        }
        return result;
    }

  private:
    std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> m_context{EVP_MD_CTX_new(), &EVP_MD_CTX_free};
};

struct Sha256::Context {
    EvpDigest digest{EVP_sha256()};
};

Sha256::Sha256() : m_context(std::make_unique<Context>()) {
}

Sha256::~Sha256() = default;
Sha256::Sha256(Sha256&&) noexcept = default;
Sha256& Sha256::operator=(Sha256&&) noexcept = default;

void Sha256::update(ByteView bytes) {
    m_context->digest.update(bytes);
}

std::string Sha256::hex() {
    return m_context->digest.hex();
}

std::string sha256Hex(ByteView bytes) {
    Sha256 hash;
    hash.update(bytes);
    return hash.hex();
}

std::string sha256HexOfFile(const std::filesystem::path& file) {
    Sha256 hash;
    readFileInPieces(file, [&](ByteView piece) { hash.update(piece); });
    return hash.hex();
}

std::string md5Hex(ByteView bytes) {
    EvpDigest digest(EVP_md5());
    digest.update(bytes);
    return digest.hex();
}

std::string randomUuid() {
    std::random_device entropy;
    std::string uuid = "xxxxxxxx-xxxx-4xxx-yxxx-xxxxxxxxxxxx";
    for (char& digit : uuid) {
        if (digit == 'x') {
            digit = kHexDigits[entropy() & 15U];
        } else if (digit == 'y') {
            digit = kHexDigits[8U | (entropy() & 3U)];
        }
    }
    return uuid;
}

} // namespace spherewalk
