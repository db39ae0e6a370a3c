// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/simulator/camera_options.h"

#include "spherewalk/base/enum_names.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

namespace spherewalk::simulator {

namespace {

constexpr EnumNames<Pace, 2> kPaces{{{Pace::Newest, "newest"}, {Pace::Every, "every"}}};

} // namespace

std::string_view name(Pace pace) {
    return nameOf(kPaces, pace);
}

Pace pace(std::string_view name) {
    return valueOf(kPaces, "The pace", name);
}

void CameraOptions::validate() const {
    if (!(rateHz >= 0 && rateHz <= 1000)) {
        throw Error(ErrorKind::InvalidInput,
                    text("A camera cannot give ", rateHz, " frames a second; ask for 0 to 1000."));
    }
    mounting.validate();
    if (overlay) {
        overlay->validate();
    }
}

} // namespace spherewalk::simulator
