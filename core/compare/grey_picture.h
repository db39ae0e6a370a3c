// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/error.h"
#include "spherewalk/base/image.h"
#include "spherewalk/base/text.h"

#include <opencv2/imgproc.hpp>

namespace spherewalk::compare {

/// The picture's brightness (ITU-R BT.601). Range: not empty. Errors: cv::Exception.
inline cv::Mat greyPicture(const RgbImage& picture) {
    const cv::Mat rgb(picture.height(), picture.width(), CV_8UC3,
                      const_cast<std::uint8_t*>(picture.values().data()));
    cv::Mat grey;
    cv::cvtColor(rgb, grey, cv::COLOR_RGB2GRAY);
    return grey;
}

/// What the function returns; OpenCV's errors become ours. Errors: Internal.
template <class Function>
auto withOpenCv(const Function& function) {
    try {
        return function();
    } catch (const cv::Exception& error) {
        throw Error(ErrorKind::Internal,
                    "Could not compare pictures: OpenCV refused them; please report this.", error.what());
    }
}

/// Errors: InvalidInput if the sizes differ or are 0.
inline void requireOneSize(const RgbImage& a, const RgbImage& b) {
    if (a.empty() || a.width() != b.width() || a.height() != b.height()) {
        throw Error(ErrorKind::InvalidInput,
                    text("Pictures of ", a.width(), " x ", a.height(), " and ", b.width(), " x ", b.height(),
                         " pixels cannot be compared: they must be of one size."));
    }
}

} // namespace spherewalk::compare
