// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"

#include <QImage>

namespace spherewalk::ui {

/// The same pixels as Qt has them. Owner: the picture's memory is not used after the call.
inline QImage qtImage(const RgbImage& picture) {
    return QImage(picture.values().data(), picture.width(), picture.height(), qsizetype{3} * picture.width(),
                  QImage::Format_RGB888)
        .convertToFormat(QImage::Format_RGB32);
}

} // namespace spherewalk::ui
