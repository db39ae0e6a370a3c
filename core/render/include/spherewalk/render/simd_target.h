// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace spherewalk::render {

/// The processor's instructions that views are made with on this machine, as Highway calls them: "AVX2". The
/// pixels are the same with any.
std::string simdTarget();

} // namespace spherewalk::render
