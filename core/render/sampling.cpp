// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/render/sampling.h"

#include "spherewalk/base/enum_names.h"

namespace spherewalk::render {

namespace {

constexpr EnumNames<Sampling, 6> kNames{{{Sampling::Nearest, "nearest"},
                                         {Sampling::Bilinear, "bilinear"},
                                         {Sampling::Reduced, "reduced"},
                                         {Sampling::Footprint, "footprint"},
                                         {Sampling::Bicubic, "bicubic"},
                                         {Sampling::Auto, "auto"}}};

} // namespace

std::string_view name(Sampling sampling) {
    return nameOf(kNames, sampling);
}

Sampling sampling(std::string_view name) {
    return valueOf(kNames, "The sampling", name);
}

} // namespace spherewalk::render
