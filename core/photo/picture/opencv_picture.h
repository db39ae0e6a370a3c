// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/error.h"
#include "spherewalk/base/image.h"
#include "spherewalk/base/text.h"

#include <opencv2/core.hpp>

#include <string_view>

namespace spherewalk::photo {

/// The picture's pixels as OpenCV sees them, not copied. Owner: the picture must outlive the matrix.
inline cv::Mat matOver(RgbImage& picture) {
    return {picture.height(), picture.width(), CV_8UC3, picture.values().data()};
}

/// The same for reading; OpenCV has no constant matrices.
inline cv::Mat matOver(const RgbImage& picture) {
    return {picture.height(), picture.width(), CV_8UC3, const_cast<std::uint8_t*>(picture.values().data())};
}

/// What call() returns; an exception of OpenCV becomes Error{Internal}.
template <class Call>
auto translated(std::string_view tried, Call&& call) {
    try {
        return call();
    } catch (const cv::Exception& error) {
        throw Error(ErrorKind::Internal,
                    text("Could not ", tried, ": OpenCV refused it; please report this."), error.what());
    }
}

} // namespace spherewalk::photo
