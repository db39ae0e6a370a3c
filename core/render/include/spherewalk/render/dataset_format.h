// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/json_fwd.h"
#include "spherewalk/geometry/angle.h"
#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/lens_pair.h"
#include "spherewalk/geometry/polygon.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/render/colour_correction.h"
#include "spherewalk/render/ladder.h"
#include "spherewalk/render/scene_depth.h"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace spherewalk::render {

/// The contents of dataset.json, version 1. resources/docs/formats.md explains the members, and
/// resources/docs/dataset.schema.json is their schema.

constexpr std::string_view kDatasetFormat = "spherewalk-dataset";
constexpr int kDatasetVersion = 1;
constexpr std::string_view kDatasetFile = "dataset.json";

/// Standard deviations of a photo's rotation about the room's z axis and the levelled photo's y and x axes.
struct RotationSigma {
    Radians yaw;
    Radians pitch;
    Radians roll;
};

/// One photo. File names are relative to the dataset's folder, and "" where the photo has no such file.
struct DatasetPhoto {
    std::string file; ///< The JPEG lies under photos/.
    std::string sha256;
    std::uint64_t sizeBytes = 0;
    int width = 0;
    int height = 0;
    std::string restartIndex; ///< The index exists if the JPEG has restart markers.
    std::string thumbnail;
    std::string depth;
    std::string station; ///< The name that people give to the spot where it was taken.
    Rigid3 roomFromPhoto;
    LensPair lenses;
    std::string rotationSource; ///< The words are "imported", "aligned", "metadata" and "unknown" (identity).
    std::optional<Eigen::Vector3d> positionSigmaM;
    std::optional<RotationSigma> rotationSigma;
    /// The gains with which its red, green and blue are as bright as the other photos, see exposedValue().
    /// Views that take pixels from several photos make the others as bright as the nearest.
    std::optional<Eigen::Vector3d> exposureGain;
    /// A scene model that is cheaper than the dataset's choice and good enough around this photo.
    std::optional<SceneKind> scene;
    std::int64_t blurredRegions = 0; ///< Faces and screens in it that were blurred when it was exported.
};

struct SuggestedCamera {
    std::string name;
    CameraIntrinsics intrinsics;
};

/// A printed AprilTag (36h11) that hangs in the room. Pictures that show it can be registered by it.
struct DatasetTag {
    int number = 0;
    /// Of the black square, in the room: upper left, upper right, lower right, lower left.
    std::array<Eigen::Vector3d, 4> cornersM;
    double sigmaM = 0; ///< Standard deviation of a corner along the worst axis.
};

struct DatasetInfo {
    std::string id;
    std::string name;
    std::string createdUtc;
    std::string madeBy; ///< The program and its version.
    std::string surveyId;
    Polygon outline; ///< It is empty if the outline is unknown.
    std::vector<Polygon> obstacles;
    double ceilingM = 0;
    double stepM = 0;                    ///< The step of the planned grid; 0 without a grid.
    std::optional<double> sphereRadiusM; ///< It exists if the dataset has the sphere scene model.
    std::optional<RoomShape> roomShape;  ///< It exists if the dataset has the room scene model.
    /// The errors of the scene models that were measured, defined as ViewChoice::errorPx.
    std::map<SceneKind, double> measuredErrorPx;
    std::optional<ViewChoice> choice; ///< It exists if it was measured.
    /// Standard deviation of all lengths, as a share of them. 0 if it is not known.
    double scaleSigma = 0;
    double highlightRolloff = 0; ///< How softly the camera's values end at white, see exposedValue().
    std::optional<ColourCorrection> colour; ///< From the photos' colours to the robot's, if it is known.
    std::vector<DatasetTag> tags;
    std::vector<SuggestedCamera> cameras;
    std::vector<DatasetPhoto> photos;
};

/// The scene models that the dataset has for at least one photo, cheap to exact. None is always among them.
std::vector<SceneKind> scenesOf(const DatasetInfo& info);

/// The most exact scene model that the dataset has for a photo, but for Blend, which takes three times as
/// long as Depth: who wants it asks for it.
SceneKind bestScene(const DatasetInfo& info, std::size_t photo);

/// The chosen scene model for views from a photo, if the choice holds for the camera; else bestScene().
SceneKind autoScene(const DatasetInfo& info, std::size_t photo, const CameraIntrinsics& camera);

/// For Sampling::Auto the chosen sampling, if the choice holds for the camera; else `sampling` itself.
Sampling autoSampling(const DatasetInfo& info, Sampling sampling, const CameraIntrinsics& camera);

/// Writes measured values into a description. Members that this version does not know stay. photoScenes:
/// DatasetPhoto::scene of each photo, or empty. Errors: Corrupt for a description of other photos.
void putMeasured(Json& description, const ViewChoice& choice, const std::map<SceneKind, double>& errorPx,
                 const std::vector<std::optional<SceneKind>>& photoScenes);

/// The description as dataset.json holds it.
Json toJson(const DatasetInfo& info);

/// The description that toJson() wrote. source: the file's name for sentences. Errors: Unsupported for
/// another version. Corrupt, with source and member, for names that lead out of the dataset, sizes that are
/// not 2:1, rotations that are no unit quaternions, and no photos.
DatasetInfo parseDatasetInfo(const Json& json, const std::string& source);

} // namespace spherewalk::render
