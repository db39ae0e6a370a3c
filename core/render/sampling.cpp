// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/render/sampling.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <array>
#include <utility>

namespace spherewalk::render {

namespace {

constexpr std::array<std::pair<Sampling, std::string_view>, 6> kNames{{{Sampling::Nearest, "nearest"},
                                                                       {Sampling::Bilinear, "bilinear"},
                                                                       {Sampling::Reduced, "reduced"},
                                                                       {Sampling::Footprint, "footprint"},
                                                                       {Sampling::Bicubic, "bicubic"},
                                                                       {Sampling::Auto, "auto"}}};

} // namespace

std::string_view name(Sampling sampling) {
    for (const auto& [value, text] : kNames) {
        if (value == sampling) {
            return text;
        }
    }
    return "unknown";
}

Sampling sampling(std::string_view name) {
    for (const auto& [value, text] : kNames) {
        if (text == name) {
            return value;
        }
    }
    throw Error(ErrorKind::InvalidInput,
                text("The sampling \"", printable(name),
                     "\" is unknown; there are nearest, bilinear, reduced, footprint, bicubic and auto."));
}

} // namespace spherewalk::render
