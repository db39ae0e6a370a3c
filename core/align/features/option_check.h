// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

namespace spherewalk::align {

/// whose, option, range: as in "The features' option most must be from 1 to 50000." Errors: InvalidInput if
/// it does not hold.
inline void require(bool holds, const char* whose, const char* option, const char* range) {
    if (!holds) {
        throw Error(ErrorKind::InvalidInput,
                    text("The ", whose, " option ", option, " must be ", range, "."));
    }
}

} // namespace spherewalk::align
