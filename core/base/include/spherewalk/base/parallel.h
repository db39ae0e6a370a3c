// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

namespace spherewalk {

/// As many threads as the machine runs at a time, at least one.
int hardwareThreads();

/// Calls body(begin, end) for disjoint pieces that together are [0, count), on up to `threads` threads (0:
/// all that the machine has), and returns when all are done. Pieces are at most `grain` long. Errors: the
/// first exception of a body is rethrown after all threads have ended; pieces not begun by then are left out.
void parallelFor(int count, int grain, int threads, const std::function<void(int begin, int end)>& body);

} // namespace spherewalk
