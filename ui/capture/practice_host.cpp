// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/capture/practice_host.h"

#include <QDir>
#include <QStandardPaths>

namespace spherewalk::ui {

PracticeHost::PracticeHost(const PracticeSettings& settings) {
    practice::PracticeCameraOptions options;
    options.width = settings.width;
    options.timeScale = settings.timeScale;
    if (settings.keepsPhotos) {
        const QString folder =
            QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + "/practice-camera";
        QDir().mkpath(folder);
        options.storageFolder = folder.toStdString();
    }
    m_camera = std::make_unique<practice::PracticeCamera>(options);
    m_camera->start();
}

} // namespace spherewalk::ui
