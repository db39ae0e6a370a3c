// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/geometry/camera_model.h"

#include <QComboBox>
#include <QString>

#include <vector>

namespace spherewalk::ui {

/// A camera of the list, with its name for people.
struct CameraPreset {
    QString name;
    CameraIntrinsics intrinsics;
};

/// Returns cameras that robots often have. Each has the field of view of its data sheet and no calibration.
std::vector<CameraPreset> cameraPresets();

/// Index of the preset that is chosen at first.
constexpr int kUsualCamera = 2;

/// A box that chooses the robot's camera: a preset, or the calibration of a ROS file.
class CameraBox : public QComboBox {
    Q_OBJECT

  public:
    explicit CameraBox(QWidget* parent = nullptr);

    const CameraIntrinsics& camera() const { return m_cameras.at(m_taken).intrinsics; }

    /// Chooses the camera of a ROS camera-info YAML and adds it to the list. Returns false for a file that
    /// cannot be read: the camera stays, and message() says why.
    bool readCamera(const QString& yaml);

  signals:
    void cameraChanged();
    /// Carries a sentence for the status line.
    void message(const QString& sentence);

  private:
    void offer(const CameraPreset& camera);
    void take(int index);
    void chooseFile(int index);

    std::vector<CameraPreset>
        m_cameras; ///< One for each item, except for the last item, which asks for a file.
    std::size_t m_taken = 0;
};

} // namespace spherewalk::ui
