// SPDX-License-Identifier: Apache-2.0
#include "c_rows.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

namespace spherewalk::render {

void checkRows(const spherewalk_source& source, std::uint64_t rowBytes, int height, std::string_view what) {
    const auto [data, sizeBytes, stride] = source;
    if (data == nullptr) {
        throw Error(ErrorKind::InvalidInput,
                    text("The memory for ", what, " is NULL, which it must not be."));
    }
    if (stride < rowBytes) {
        throw Error(ErrorKind::InvalidInput, text("The rows of ", what, " are ", stride,
                                                  " bytes apart, and one of them has ", rowBytes, "."));
    }
    const auto steps = static_cast<std::uint64_t>(height - 1);
    const bool fits =
        sizeBytes >= rowBytes && sizeBytes <= PTRDIFF_MAX &&
        (steps == 0 || stride <= (sizeBytes - rowBytes) / steps); // a product may need more bits
    if (!fits) {
        throw Error(ErrorKind::InvalidInput,
                    text("The memory for ", what, ", ", sizeBytes, " bytes, cannot hold ", height,
                         " rows of ", rowBytes, " bytes that are ", stride, " bytes apart."));
    }
}

} // namespace spherewalk::render
