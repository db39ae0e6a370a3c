// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/preview/camera_presets.h"

#include "spherewalk/geometry/angle.h"

#include <QCoreApplication>

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
