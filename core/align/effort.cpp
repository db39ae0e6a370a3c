// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/align/effort.h"

#include "spherewalk/base/enum_names.h"

namespace spherewalk::align {

namespace {

constexpr EnumNames<Effort, 4> kNames{
    {{Effort::Draft, "draft"}, {Effort::Normal, "normal"}, {Effort::Fine, "fine"}, {Effort::Exact, "exact"}}};

} // namespace

std::string_view name(Effort effort) {
    return nameOf(kNames, effort);
}

Effort effortNamed(std::string_view name) {
    return valueOf(kNames, "The effort", name);
}

EffortOptions optionsFor(Effort effort) {
    EffortOptions options;
    switch (effort) {
    case Effort::Draft:
        options.features.detector = Detector::Orb;
        options.features.width = 1024;
        options.features.most = 1000;
        break;
    case Effort::Normal:
        options.features.width = 1280;
        options.features.most = 2000;
        options.features.leastContrast = 0.03;
        break;
    case Effort::Fine:
        options.features.width = 2048;
        options.features.most = 4000;
        options.features.leastContrast = 0.02;
        options.neighbours.farDirections = 4;
        break;
    case Effort::Exact:
        options.features.width = 2688;
        options.features.most = 8000;
        options.features.leastContrast = 0.015;
        options.neighbours.farDirections = 8;
        break;
    }
    return options;
}

} // namespace spherewalk::align
