// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/error.h"

#include <cstdio>
#include <functional>
#include <string>

namespace spherewalk::program {

/// What every program ends with.
enum ExitStatus { kDone = 0, kFailed = 1, kUsage = 2, kStopped = 3 };

/// Runs the body and returns its exit status; an exception of it becomes sentences on standard error and a
/// status. onError, if given, is told of the error first.
int guarded(const std::function<int()>& body, const std::function<void(const Error&)>& onError = {});

void printLine(std::FILE* stream, const std::string& line);

} // namespace spherewalk::program
