// SPDX-License-Identifier: GPL-3.0-or-later
#include "plot_option.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

namespace spherewalk::cli {

void checkPlot(const std::filesystem::path& plot) {
    if (plot.extension() != ".svg") {
        throw Error(ErrorKind::InvalidInput,
                    text("The plot is an SVG picture: give --plot a name that ends in .svg, not ",
                         printable(plot.string()), "."));
    }
    const std::filesystem::path folder = plot.has_parent_path() ? plot.parent_path() : ".";
    if (!std::filesystem::is_directory(folder)) {
        throw Error(ErrorKind::NotFound, text("The plot cannot be written: there is no folder ",
                                              printable(folder.string()), "; make it first."));
    }
}

} // namespace spherewalk::cli
