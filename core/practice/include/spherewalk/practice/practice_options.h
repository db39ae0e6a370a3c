// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/geometry/angle.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/practice/practice_room.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace spherewalk::practice {

/// The errors of the camera's pose on a real cart: any yaw, a small tilt and a small shift. The same seed and
/// shot always give the same errors.
struct PhotoErrors {
    bool anyYaw = true;               ///< False: no photo is turned.
    Radians tiltSigma = Degrees(0.5); ///< Standard deviation of pitch and of roll.
    double positionSigmaM = 0.003;    ///< Standard deviation along each axis, metres.
    std::uint64_t seed = 1;

    /// Errors: InvalidInput for sigmas below 0, above 30 degrees or 1 m, or not finite.
    void validate() const;

    /// The true roomFromPhoto of a shot, and of all after it until the camera is moved. nominalPositionM: the
    /// place that the operator aimed at, room frame, metres.
    Rigid3 truePose(const Eigen::Vector3d& nominalPositionM, int shot) const;
};

/// What a real camera does to its pictures. By default, nothing is done to them. The same seed and shot
/// always give the same flaws.
struct PhotoFlaws {
    double exposureSigmaEv = 0;   ///< Standard deviation of the automatic exposure between photos, stops.
    double whiteBalanceSigma = 0; ///< Standard deviation of red's and of blue's gain, as a share.
    double noiseSigma = 0;        ///< Standard deviation of a pixel's noise, grey levels.
    double lensOffsetM = 0; ///< Distance of each of two lenses from the middle: near things tear at the seam.
    double robotHalfAngleDeg = 0; ///< Half angle under which the lens sees its robot below; 0: no robot.
    double personShare = 0;       ///< Share of the photos with a person in the room, another place each time.
    std::uint64_t seed = 1;

    /// Flaws as large as those of a hand-held Theta with automatic exposure.
    static PhotoFlaws ofARealCamera(std::uint64_t seed);

    /// Errors: InvalidInput for numbers below 0 or too large, naming the range.
    void validate() const;
};

/// A photo that the practice camera serves instead of drawing the room.
struct PlacedPhoto {
    std::string file; ///< Path within the photo folder.
    Eigen::Vector3d positionM = Eigen::Vector3d::Zero();
    std::optional<Eigen::Quaterniond> roomFromPhoto; ///< For the truth file; nothing if it is not known.
};

enum class CameraModel {
    ThetaV,   ///< Speaks API level 2 only.
    ThetaS,   ///< Begins at level 1, switches to 2 on demand, and falls back at a sleep or a restart.
    LevelOne, ///< A Theta S with its first firmware, which knows level 1 only.
};

struct PracticeCameraOptions {
    CameraModel model = CameraModel::ThetaV;
    std::string host = "127.0.0.1";
    int port = 0;         ///< TCP port; 0: any that is free.
    double timeScale = 0; ///< Factor on the camera's times: 1 as a Theta V, 0 for no waits. Range: [0, 100].
    int width = 5376;     ///< Width of the photos, pixels; they are half as high. Range: even, [512, 16384].
    int jpegQuality = 92;
    std::uint64_t seed =
        1; ///< For ids, the serial number and the scatter of times; the errors have a seed of their own.
    PhotoErrors errors;
    PhotoFlaws flaws;
    bool isPlain = false;  ///< Photos show stripes instead of the room, which is much quicker.
    bool levelled = false; ///< The zenith correction is on at first, so that the pixels have no tilt.
    Eigen::Vector3d positionM = {2.0, 1.8, 1.2}; ///< First place of the cart, room frame, metres.
    PracticeRoomOptions room;

    std::filesystem::path
        storageFolder;               ///< The camera's memory, kept between runs. Empty: a temporary folder.
    std::filesystem::path truthFile; ///< File for the truth. Empty: truth.jsonl in the storage folder.

    std::filesystem::path photoFolder; ///< Not empty: the camera serves `photos` instead of the room.
    std::vector<PlacedPhoto> photos;

    /// The answer to a trigger during an exposure, which differs between firmwares.
    enum class WhenBusy { DisabledCommand, ServiceUnavailable, DeviceBusy };

    WhenBusy whenBusy = WhenBusy::DisabledCommand;
    std::string digestUser; ///< Not empty: asks for HTTP digest authentication, as in client mode.
    std::string digestPassword;
    int nonceRequests = 0; ///< Each nonce is good for so many requests; 0: for ever.

    int doneAnswers = 1; ///< A finished id answers so often; 0: for ever.
    bool urlsOfAccessPoint =
        false;       ///< File URLs begin with 192.168.1.1 as the real camera's, not with the request's host.
    int threads = 0; ///< Threads for drawing; 0: all that the machine has.
    std::uint64_t storageBytes = 19'200'000'000ULL;

    /// Errors: InvalidInput, naming the option and its range.
    void validate() const;
};

} // namespace spherewalk::practice
