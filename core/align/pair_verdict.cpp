// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/align/pair_estimate.h"

namespace spherewalk::align {

std::string_view name(PairVerdict verdict) {
    switch (verdict) {
    case PairVerdict::Constraint:
        return "constraint";
    case PairVerdict::TooFew:
        return "too_few";
    case PairVerdict::TooNarrow:
        return "too_narrow";
    case PairVerdict::NoAgreement:
        return "no_agreement";
    }
    return "unknown";
}

} // namespace spherewalk::align
