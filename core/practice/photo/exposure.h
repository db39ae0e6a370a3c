// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "photo/camera_time.h"

#include "spherewalk/base/bytes.h"
#include "spherewalk/base/image.h"
#include "spherewalk/practice/practice_options.h"
#include "spherewalk/practice/truth.h"

#include <stop_token>
#include <vector>

namespace spherewalk::practice {

/// A defect that a photo shall have.
enum class PhotoDefect { None, Empty, Small, NoMakerNote, HostileMakerNote };

/// The settings of the camera at the release of the shutter.
struct ExposureSettings {
    int shot = 0;
    int standing = 0; ///< The first shot since the camera was moved: all since then have its pose.
    Eigen::Vector3d nominalPositionM = Eigen::Vector3d::Zero();
    ZonedTime time;
    bool levelled = false;
    int program = 2;
    double exposureTimeS = 0; ///< Seconds; 0: the camera chooses.
    int isoSpeed = 0;         ///< 0: the camera chooses
    double exposureBias = 0;
    bool hasFixedWhiteBalance = false;
    PhotoDefect defect = PhotoDefect::None;
    Json options = Json::object(); ///< The same settings in the camera's spelling, for the truth.
};

struct ExposedPhoto {
    Bytes jpeg;
    Truth truth; ///< File name and URL are still empty.
};

/// Joins the pictures of a camera's two lenses. The front lens shows what is less than 90 degrees from the
/// picture's middle. Near the seam the pictures fade into each other over two degrees. Range: both pictures
/// are equirectangular and of one size.
RgbImage stitched(const RgbImage& front, const RgbImage& back);

/// Gives a picture the exposure, the white balance and the noise of this shot, and the robot below the lens.
/// The same flaws and shot always give the same picture. Shape: equirectangular.
void addFlaws(RgbImage& picture, const PhotoFlaws& flaws, int shot);

/// How much more light than usual this shot has, with these flaws.
double lightOf(const PhotoFlaws& flaws, int shot);

/// Makes photos: it draws the room, or takes the nearest photo of a folder. Threads: any.
class Exposer {
  public:
    /// Owner: options must outlive the exposer. Errors: NotFound for a photo that the folder lacks.
    explicit Exposer(const PracticeCameraOptions& options);

    /// The file that the camera would store, and the truth about it. Errors: those of reading a given photo.
    /// Stop: throws Error{Stopped}.
    ExposedPhoto expose(const ExposureSettings& settings, const std::stop_token& stop) const;

    /// The picture of the same photo in this size, as a JPEG without metadata. Errors, Stop: as expose().
    Bytes preview(const ExposureSettings& settings, const EquirectSize& size,
                  const std::stop_token& stop) const;

    /// Where a person takes photos on a walk through the room, or where the given photos were taken.
    std::vector<Eigen::Vector3d> walk() const;

  private:
    ExposedPhoto drawn(const ExposureSettings& settings, const std::stop_token& stop) const;
    ExposedPhoto taken(const ExposureSettings& settings) const;
    Rigid3 poseOf(const ExposureSettings& settings) const;
    RgbImage draw(const Rigid3& pose, int shot, const EquirectSize& size, const std::stop_token& stop) const;
    std::optional<PracticeRoom> roomWithPerson(const Rigid3& pose, int shot) const;
    const PlacedPhoto& nearestPhoto(const Eigen::Vector3d& positionM) const;

    const PracticeCameraOptions& m_options;
    std::optional<PracticeRoom> m_room;
};

} // namespace spherewalk::practice
