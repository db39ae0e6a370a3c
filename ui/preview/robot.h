// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/preview/laid_object.h"

#include "spherewalk/geometry/angle.h"
#include "spherewalk/geometry/polygon.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/jobs/positions_csv.h"
#include "spherewalk/render/view_stream.h"

#include <QImage>
#include <QString>

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace spherewalk::ui {

/// Place and heading of a robot. Frames: room.
struct RobotPlace {
    Eigen::Vector2d pInRoom = Eigen::Vector2d::Zero();
    Radians yaw;
};

/// Height and tilt of the camera on the robot.
struct CameraMount {
    double heightM = 1.2;
    Radians down; ///< Angle below the horizon.
};

/// Returns the pose of the camera's optical frame in the room.
Rigid3 roomFromOptical(const RobotPlace& robot, const CameraMount& mount);

/// What the driver wants: shares of the greatest speeds, each in [-1, 1].
struct DriveWish {
    double forward = 0;
    double left = 0;
    double turnLeft = 0;

    bool isNone() const { return forward == 0 && left == 0 && turnLeft == 0; }
};

/// Moves a robot as a driver wants and keeps it on the floor. It slides along walls.
class Drive {
  public:
    static constexpr double kSpeedMps = 0.8;
    static constexpr Degrees kTurnPerSecond{60};

    Drive() = default;

    /// An empty outline lets the robot go anywhere.
    Drive(Polygon outline, std::vector<Polygon> obstacles);

    /// Returns the place after this time.
    RobotPlace after(const RobotPlace& robot, const DriveWish& wish, double seconds) const;
    bool isFloor(const Eigen::Vector2d& point) const;

  private:
    Polygon m_outline;
    std::vector<Polygon> m_obstacles;
};

/// How one of the compared views is made.
struct ViewSide {
    std::optional<render::SceneKind> scene; ///< Nothing: the scene model that the dataset chooses.
    render::Sampling sampling = render::Sampling::Footprint;
    std::optional<CameraIntrinsics> camera = {}; ///< Nothing: the robot's camera.

    bool operator==(const ViewSide&) const = default;
};

/// The views that are wanted next.
struct ViewOrder {
    Rigid3 roomFromCamera; ///< Pose of the optical frame.
    double timeS = 0;
    std::vector<ViewSide> sides; ///< One side, or two for a comparison.
    std::optional<LaidObject> object;
    bool showsError = false; ///< Whether the pictures are tinted by the expected error of each pixel.
    /// What the robot's own camera took at this pose. It is shown beside the views.
    std::optional<jobs::RobotPicture> own = {};
    double share = 1; ///< Share of the cameras' width and height that the pictures have; see DrivePace.
};

/// Tints the picture by the error: nothing for a pixel that is where it belongs, and the more the further it
/// is off, up to kWorstShownPx. Shape: both have the same size.
void tintByError(QImage& picture, const render::PixelTrust& trust);
inline constexpr double kWorstShownPx = 10;

struct MadeView {
    QImage picture;
    render::ViewReport report;
    QString caption = {}; ///< Of the robot's own picture, which has no report.
    double share = 1; ///< Share of the camera's width and height. The report's pixels are the whole camera's.
};

/// The camera with this share of its width and height, at least one pixel each; it sees the same. Range:
/// share in (0, 1].
CameraIntrinsics scaled(const CameraIntrinsics& camera, double share);

/// Makes the views of a camera that moves through a dataset. Threads: any, one at a time.
class ViewMaker {
  public:
    /// Errors: those of ViewStream.
    ViewMaker(render::Renderer renderer, const CameraIntrinsics& camera);

    /// Returns one view for each side, and the robot's own picture after them. Before a photo is decoded the
    /// view is coarse, and its report says so. Errors: those of ViewStream::next().
    std::vector<MadeView> make(const ViewOrder& order);

  private:
    /// A camera with its stream.
    struct Eye {
        CameraIntrinsics intrinsics; ///< As they were asked for; the camera is a share of them.
        double share = 1;
        CameraModel camera;
        render::ViewStream stream;
    };

    Eye& eye(std::size_t side, const CameraIntrinsics& camera, double share);
    const MadeView& ownPicture(const jobs::RobotPicture& own);

    render::Renderer m_renderer;
    CameraIntrinsics m_camera;
    std::vector<std::array<std::unique_ptr<Eye>, 2>>
        m_eyes; ///< Of each side, the whole one and a smaller one.
    render::View m_view;
    std::filesystem::path m_ownFile; ///< The file of m_own.
    MadeView m_own;
};

} // namespace spherewalk::ui
