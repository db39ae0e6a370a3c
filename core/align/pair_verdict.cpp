// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/align/pair_estimate.h"
#include "spherewalk/base/enum_names.h"

namespace spherewalk::align {

std::string_view name(PairVerdict verdict) {
    constexpr EnumNames<PairVerdict, 4> kNames{{{PairVerdict::Constraint, "constraint"},
                                                {PairVerdict::TooFew, "too_few"},
                                                {PairVerdict::TooNarrow, "too_narrow"},
                                                {PairVerdict::NoAgreement, "no_agreement"}}};
    return nameOf(kNames, verdict);
}

} // namespace spherewalk::align
