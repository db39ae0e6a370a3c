// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/preview/camera_box.h"

#include "spherewalk/base/error.h"
#include "spherewalk/render/camera_info.h"

#include <QFileDialog>
#include <QFileInfo>

namespace spherewalk::ui {

CameraBox::CameraBox(QWidget* parent) : QComboBox(parent) {
    addItem(tr("From a ROS file..."));
    for (const CameraPreset& preset : cameraPresets()) {
        offer(preset);
    }
    m_taken = static_cast<std::size_t>(kUsualCamera);
    setCurrentIndex(kUsualCamera);
    setAccessibleName(tr("Camera model"));
    setToolTip(tr("The robot's camera; a ROS camera-info YAML has your own one's calibration"));
    setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    connect(this, &QComboBox::currentIndexChanged, this, &CameraBox::take);
    connect(this, &QComboBox::activated, this, &CameraBox::chooseFile);
}

void CameraBox::offer(const CameraPreset& camera) {
    insertItem(count() - 1, camera.name);
    m_cameras.push_back(camera);
}

void CameraBox::take(int index) {
    const auto camera = static_cast<std::size_t>(index);
    if (index >= 0 && camera < m_cameras.size() && camera != m_taken) {
        m_taken = camera;
        emit cameraChanged();
    }
}

void CameraBox::chooseFile(int index) {
    if (index != count() - 1) {
        return;
    }
    const QString file =
        QFileDialog::getOpenFileName(this, tr("ROS camera-info file"), {}, tr("Camera info (*.yaml *.yml)"));
    if (file.isEmpty() || !readCamera(file)) {
        setCurrentIndex(static_cast<int>(m_taken));
    }
}

bool CameraBox::readCamera(const QString& yaml) {
    try {
        offer({QFileInfo(yaml).fileName(), render::readCameraInfo(yaml.toStdString())});
    } catch (const Error& error) {
        emit message(QString::fromStdString(error.sentence()));
        return false;
    }
    setCurrentIndex(count() - 2);
    return true;
}

} // namespace spherewalk::ui
