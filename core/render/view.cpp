// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/render/view.h"

#include "spherewalk/base/enum_names.h"

namespace spherewalk::render {

std::string_view name(ViewOrigin origin) {
    constexpr EnumNames<ViewOrigin, 3> kNames{{{ViewOrigin::Photo, "photo"},
                                               {ViewOrigin::Thumbnail, "thumbnail"},
                                               {ViewOrigin::PreviousPhoto, "previous"}}};
    return nameOf(kNames, origin);
}

} // namespace spherewalk::render
