// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/progress.h"
#include "spherewalk/dataset/pose_formats.h"
#include "spherewalk/dataset/world_file.h"
#include "spherewalk/jobs/export_place.h"

#include <filesystem>
#include <optional>
#include <span>
#include <stop_token>
#include <string_view>

namespace spherewalk::store {
class SurveyStore;
}

namespace spherewalk::jobs {

struct ForeignOptions {
    dataset::PoseFormat format = dataset::PoseFormat::Nerfstudio;
    /// Writes the six faces of a cube in place of the photo: pinhole pictures of 90 degrees, a quarter of the
    /// photo wide. COLMAP gets faces in any case.
    bool withFaces = false;
    /// Adds the points of the surfaces that the photos show (paintedSurfaceOf()), with colours. Depths are
    /// estimated for it, unless an earlier export kept them.
    bool withPoints = false;
    PlaceOptions place = {}; ///< How points are found.
    /// Says which pictures are tests: all of the photos that isTestPhoto() names. No point is made from them.
    /// Range: 0 for none, or 2 or more.
    int testEvery = 0;

    /// Errors: InvalidInput for testEvery, and for points and tests in a format that does not know them;
    /// those of PlaceOptions::validate().
    void validate() const;
};

struct ForeignReport {
    std::size_t photos = 0;
    std::size_t pictures = 0; ///< Photos, or six faces for each of them.
    std::size_t tests = 0;    ///< Photos among them that are tests.
    std::size_t points = 0;
};

/// Writes the pose files of a format into a folder. Errors: those of dataset::poseFiles() and of writing.
void writePoseFiles(dataset::PoseFormat format, const dataset::FrameCamera& camera,
                    std::span<const dataset::PosedFrame> frames, const std::filesystem::path& folder,
                    std::span<const dataset::ColouredPoint> points = {});

/// Exports the photos that exportDataset() would export, for programs that read other formats: pictures in
/// images/, and the format's files beside it. Photos have no times in these formats; they get a second each,
/// in their order.
///
/// Where faces are tests, test.csv has their poses and camera.yaml their camera, as compareRenderings() takes
/// them.
///
/// Errors: those of ForeignOptions::validate(), exportDataset(), paintedSurfaceOf() and dataset::poseFiles();
/// Unsupported for photos of different sizes. After an error
/// nothing is left.
ForeignReport exportForeign(const store::SurveyStore& store, const std::filesystem::path& folder,
                            const ForeignOptions& options, ProgressSink& progress,
                            const std::stop_token& stop);

/// The height of obstacles in a world, which surveys and datasets do not know: that of a table.
inline constexpr double kObstacleHeightM = 0.75;

/// The room of the survey or of the dataset in this folder. The robot's camera begins at the photo nearest to
/// the middle of all photos at which the robot stands in no obstacle; a survey without photos takes its
/// stations instead. Photos whose place is not known have no say. Obstacles in which the robot would have to
/// begin are left out. Lengths that are hardly known, and walls that nobody drew, are warned of.
/// Errors: those of opening the folder; InvalidInput for a folder without photos and stations; NotFound for a
/// survey whose room nobody drew and no photos show.
dataset::WorldRoom worldRoomOf(const std::filesystem::path& folder, double obstacleHeightM = kObstacleHeightM,
                               ProgressSink& progress = noProgress());

/// What a world is written for.
enum class WorldFormat {
    Sdf,  ///< world.sdf for Gazebo, and furniture.obj.
    Mjcf, ///< world.xml for MuJoCo.
    Urdf, ///< room.urdf for what reads robots' models.
};

/// The words "sdf", "mjcf" and "urdf". Another word is no format of a world.
std::string_view name(WorldFormat format);
std::optional<WorldFormat> worldFormat(std::string_view name);

/// Writes the world's file, and camera.yaml for the camera in it, into a new folder. Returns the name of the
/// world's file. Errors: Exists, Full, Io; those of dataset::sdfWorld() and dataset::mjcfWorld(). After an
/// error nothing is left.
std::string exportWorld(const dataset::WorldRoom& room, const CameraIntrinsics& camera, WorldFormat format,
                        const std::filesystem::path& folder);

} // namespace spherewalk::jobs
