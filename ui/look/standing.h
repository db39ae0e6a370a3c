// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace spherewalk::ui {

/// How a station or its photo stands: what people decided goes before what the checks say.
enum class Standing { Missing, Taken, Accepted, Doubtful, Failed, Rejected };

/// In one word, translated.
QString standingText(Standing standing);

/// A sign that tells standings apart without colour.
QString standingSign(Standing standing);

} // namespace spherewalk::ui
