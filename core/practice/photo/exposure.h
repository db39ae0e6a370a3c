// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "camera_time.h"

#include "spherewalk/base/bytes.h"
#include "spherewalk/practice/practice_camera.h"
#include "spherewalk/practice/truth.h"

#include <stop_token>

namespace spherewalk::practice {

/// What is wrong with a photo.
enum class PhotoDefect { None, Empty, Small, NoMakerNote, HostileMakerNote };

/// What the camera was set to when the shutter was released.
struct ExposureSettings {
    int shot = 0;
    Eigen::Vector3d nominalPositionM = Eigen::Vector3d::Zero();
    ZonedTime time;
    bool levelled = false;
    int program = 2;
    double exposureTimeS = 0; ///< 0: the camera chooses
    int isoSpeed = 0;         ///< 0: the camera chooses
    double exposureBias = 0;
    bool hasFixedWhiteBalance = false;
    PhotoDefect defect = PhotoDefect::None;
    Json options = Json::object(); ///< of the exposure, for the truth
};

struct ExposedPhoto {
    Bytes jpeg;
    Truth truth; ///< without file name and URL
};

/// Makes the photos: draws the room, or takes them from a folder. Threads: const, any.
class Exposer {
  public:
    /// Errors: those of reading the photo folder's names.
    explicit Exposer(const PracticeCameraOptions& options);

    ExposedPhoto expose(const ExposureSettings& settings, const std::stop_token& stop) const;

    /// The picture of that photo alone, small, as a JPEG. Errors: also Stopped.
    Bytes preview(const ExposureSettings& settings, const EquirectSize& size,
                  const std::stop_token& stop) const;

  private:
    ExposedPhoto drawn(const ExposureSettings& settings, const std::stop_token& stop) const;
    ExposedPhoto taken(const ExposureSettings& settings) const;
    Rigid3 poseOf(const ExposureSettings& settings) const;
    RgbImage draw(const Rigid3& pose, const EquirectSize& size, const std::stop_token& stop) const;
    const PlacedPhoto& nearestPhoto(const Eigen::Vector3d& positionM) const;

    const PracticeCameraOptions& m_options;
    std::optional<PracticeRoom> m_room;
};

} // namespace spherewalk::practice
