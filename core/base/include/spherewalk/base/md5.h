// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/bytes.h"

#include <string>

namespace spherewalk {

/// MD5 as 32 lower-case hexadecimal digits, for protocols that ask for it: it proves nothing any more.
/// Source: RFC 1321, by OpenSSL.
std::string md5Hex(ByteView bytes);

} // namespace spherewalk
