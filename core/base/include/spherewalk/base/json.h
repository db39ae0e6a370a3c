// SPDX-License-Identifier: Apache-2.0
#pragma once

/// For sources: the JSON types complete. Headers that only name Json include json_fwd.h.

#include "spherewalk/base/json_fwd.h"

#include <nlohmann/json.hpp>
