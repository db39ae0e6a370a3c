// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/fields/camera_box.h"

#include "ui/look/core_words.h"

#include "spherewalk/base/error.h"
#include "spherewalk/geometry/angle.h"
#include "spherewalk/render/camera_info.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>

namespace spherewalk::ui {

namespace {

CameraPreset pinhole(const QString& name, int width, int height, double fovDeg) {
    return {QCoreApplication::translate("CameraPreset", "%1, %2 x %3, %4°")
                .arg(name)
                .arg(width)
                .arg(height)
                .arg(fovDeg),
            CameraIntrinsics::pinhole(width, height, Radians(Degrees(fovDeg)).value())};
}

CameraPreset fisheye() {
    CameraIntrinsics camera;
    camera.width = 848;
    camera.height = 800;
    camera.fx = camera.fy = 285;
    camera.cx = 0.5 * (camera.width - 1);
    camera.cy = 0.5 * (camera.height - 1);
    camera.lens = LensModel::Equidistant;
    camera.distortion = {0, 0, 0, 0};
    return {QCoreApplication::translate("CameraPreset", "Fisheye (as RealSense T265), 848 x 800"), camera};
}

} // namespace

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
        emit message(coreWords(error.sentence()));
        return false;
    }
    setCurrentIndex(count() - 2);
    return true;
}

std::vector<CameraPreset> cameraPresets() {
    return {pinhole(QStringLiteral("RealSense D435"), 1280, 720, 69),
            pinhole(QStringLiteral("RealSense D435"), 640, 480, 55),
            pinhole(QStringLiteral("Kinect, Xtion, Astra"), 640, 480, 57),
            pinhole(QStringLiteral("ZED 2"), 1280, 720, 102),
            pinhole(QStringLiteral("Raspberry Pi 2"), 820, 616, 62.2),
            pinhole(QCoreApplication::translate("CameraPreset", "Wide angle"), 640, 480, 90),
            fisheye()};
}

} // namespace spherewalk::ui
