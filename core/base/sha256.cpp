// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/base/sha256.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"

#include <openssl/evp.h>

#include <array>
#include <fstream>

namespace spherewalk {

namespace {

void require(int succeeded) {
    if (succeeded != 1) {
        throw Error(ErrorKind::Internal, "The SHA-256 of OpenSSL failed; check the OpenSSL installation.");
    }
}

} // namespace

struct Sha256::Context {
    std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> digest{EVP_MD_CTX_new(), &EVP_MD_CTX_free};
};

Sha256::Sha256() : m_context(std::make_unique<Context>()) {
    require(EVP_DigestInit_ex(m_context->digest.get(), EVP_sha256(), nullptr));
}

Sha256::~Sha256() = default;
Sha256::Sha256(Sha256&&) noexcept = default;
Sha256& Sha256::operator=(Sha256&&) noexcept = default;

void Sha256::update(ByteView bytes) {
    require(EVP_DigestUpdate(m_context->digest.get(), bytes.data(), bytes.size()));
}

std::string Sha256::hex() {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned int size = 0;
    require(EVP_DigestFinal_ex(m_context->digest.get(), digest.data(), &size));
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string result;
    for (unsigned int i = 0; i < size; ++i) {
        result += kDigits[digest[i] >> 4];
        result += kDigits[digest[i] & 15];
    }
    return result;
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

} // namespace spherewalk
