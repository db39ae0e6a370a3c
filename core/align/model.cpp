// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/align/solve.h"
#include "spherewalk/base/enum_names.h"

namespace spherewalk::align {

namespace {

constexpr EnumNames<Model, 5> kNames{{{Model::Auto, "auto"},
                                      {Model::Yaw, "yaw"},
                                      {Model::Tilt, "tilt"},
                                      {Model::Placement, "placement"},
                                      {Model::Position, "position"}}};

} // namespace

std::string_view name(Model model) {
    return nameOf(kNames, model);
}

Model modelNamed(std::string_view name) {
    return valueOf(kNames, "The alignment model", name);
}

} // namespace spherewalk::align
