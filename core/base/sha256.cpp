// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/base/sha256.h"

#include "evp_digest.h"

#include "spherewalk/base/file.h"

namespace spherewalk {

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

} // namespace spherewalk
