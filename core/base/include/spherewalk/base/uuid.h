// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace spherewalk {

/// A new random identifier, version 4 of RFC 4122, in lower case.
std::string randomUuid();

} // namespace spherewalk
