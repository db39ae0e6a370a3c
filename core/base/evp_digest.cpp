// SPDX-License-Identifier: Apache-2.0
#include "evp_digest.h"

#include "spherewalk/base/error.h"

#include <array>
#include <string_view>

namespace spherewalk {

namespace {

void require(int succeeded) {
    if (succeeded != 1) {
        throw Error(ErrorKind::Internal, "A digest of OpenSSL failed; check the OpenSSL installation.");
    }
}

} // namespace

EvpDigest::EvpDigest(const EVP_MD* kind) {
    require(EVP_DigestInit_ex(m_context.get(), kind, nullptr));
}

void EvpDigest::update(ByteView bytes) {
    require(EVP_DigestUpdate(m_context.get(), bytes.data(), bytes.size()));
}

std::string EvpDigest::hex() {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned int size = 0;
    require(EVP_DigestFinal_ex(m_context.get(), digest.data(), &size));
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string result;
    for (unsigned int i = 0; i < size; ++i) {
        result += kDigits[digest[i] >> 4];
        result += kDigits[digest[i] & 15];
    }
    return result;
}

} // namespace spherewalk
