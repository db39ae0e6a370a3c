// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/base/md5.h"

#include "evp_digest.h"

namespace spherewalk {

std::string md5Hex(ByteView bytes) {
    EvpDigest digest(EVP_md5());
    digest.update(bytes);
    return digest.hex();
}

} // namespace spherewalk
