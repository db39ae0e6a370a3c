// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

namespace spherewalk::ui {

/// The sentences of errors and warnings that people meet in the window, and the parts that such sentences are
/// made of. "%1" and so on stand for values. Sources: core/base, core/camera, core/photo/picture, core/store,
/// core/survey, core/jobs. tests/lint compares them with these.
std::span<const char* const> coreErrors();

} // namespace spherewalk::ui
