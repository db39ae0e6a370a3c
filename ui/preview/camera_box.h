// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/preview/camera_presets.h"

#include <QComboBox>

namespace spherewalk::ui {

/// Which camera the robot has: one of the presets, or of a ROS file.
class CameraBox : public QComboBox {
    Q_OBJECT

  public:
    explicit CameraBox(QWidget* parent = nullptr);

    const CameraIntrinsics& camera() const { return m_cameras.at(m_taken).intrinsics; }

    /// Takes the camera of a ROS camera-info YAML, and offers it from then on. If it cannot be read, the
    /// camera stays, and message() says why.
    bool readCamera(const QString& yaml);

  signals:
    void cameraChanged();
    /// A sentence for people.
    void message(const QString& sentence);

  private:
    void offer(const CameraPreset& camera);
    void take(int index);
    void chooseFile(int index);

    std::vector<CameraPreset> m_cameras; ///< as the items, but for the last one, which asks for a file
    std::size_t m_taken = 0;
};

} // namespace spherewalk::ui
