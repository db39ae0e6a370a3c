// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/json.h"
#include "spherewalk/geometry/angle.h"
#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/polygon.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/render/colour_correction.h"
#include "spherewalk/render/room_shape.h"
#include "spherewalk/render/scene_model.h"
#include "spherewalk/render/view_choice.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace spherewalk::render {

/// What dataset.json says, version 1. The members are explained in resources/docs/formats.md, and
/// resources/docs/dataset.schema.json is the machine's form of it.

constexpr std::string_view kDatasetFormat = "spherewalk-dataset";
constexpr int kDatasetVersion = 1;
constexpr std::string_view kDatasetFile = "dataset.json";

/// Standard deviations of a photo's rotation about the room's z axis and the levelled photo's y and x axes.
struct RotationSigma {
    Radians yaw;
    Radians pitch;
    Radians roll;
};

struct DatasetPhoto {
    std::string file; ///< relative to the dataset, under photos/
    std::string sha256;
    std::uint64_t sizeBytes = 0;
    int width = 0;
    int height = 0;
    std::string restartIndex; ///< relative; "" if the photo has no restart markers
    std::string thumbnail;    ///< relative; "" if there is none
    std::string depth;        ///< relative; "" if there is none
    std::string station;      ///< what people call its place
    Rigid3 roomFromPhoto;
    std::string rotationSource; ///< "imported", "aligned", "metadata", or "unknown" (identity)
    std::optional<Eigen::Vector3d> positionSigmaM;
    std::optional<RotationSigma> rotationSigma;
    /// A scene model cheaper than the dataset's choice that is enough about this photo.
    std::optional<SceneKind> scene;
};

struct SuggestedCamera {
    std::string name;
    CameraIntrinsics intrinsics;
};

struct DatasetInfo {
    std::string id;
    std::string name;
    std::string createdUtc;
    std::string madeBy; ///< program and version
    std::string surveyId;
    Polygon outline; ///< empty if unknown
    std::vector<Polygon> obstacles;
    double ceilingM = 0;
    double stepM = 0;                            ///< of the planned grid; 0 if there was none
    std::optional<double> sphereRadiusM;         ///< of the sphere scene model, if the dataset has one
    std::optional<RoomShape> roomShape;          ///< of the room scene model, if the dataset has one
    std::map<SceneKind, double> measuredErrorPx; ///< as ViewChoice::errorPx; of those that were measured
    std::optional<ViewChoice> choice;            ///< if it was measured
    std::optional<ColourCorrection> colour;      ///< from the photos' colours to the robot's, if it is known
    std::vector<SuggestedCamera> cameras;
    std::vector<DatasetPhoto> photos;
};

/// The scene models that the dataset has for some photo, cheap to exact; None always.
std::vector<SceneKind> scenesOf(const DatasetInfo& info);

/// The best scene model that the dataset has for a photo.
SceneKind bestScene(const DatasetInfo& info, std::size_t photo);

/// What was chosen for views from a photo if that holds for the camera, else the best that there is.
SceneKind autoScene(const DatasetInfo& info, std::size_t photo, const CameraIntrinsics& camera);

/// For Sampling::Auto what was chosen, if that holds for the camera; else the same.
Sampling autoSampling(const DatasetInfo& info, Sampling sampling, const CameraIntrinsics& camera);

/// Writes what was measured into an open description, which may hold more than this version knows.
/// photoScenes: DatasetPhoto::scene of each photo, or none at all. Errors: Corrupt if it is no description of
/// so many photos.
void putMeasured(Json& description, const ViewChoice& choice, const std::map<SceneKind, double>& errorPx,
                 const std::vector<std::optional<SceneKind>>& photoScenes);

Json toJson(const DatasetInfo& info);

/// Errors: Unsupported for another version; Corrupt, naming source and place, for everything else that cannot
/// be right: names that lead out of the dataset, sizes that are no equirectangular picture, rotations that
/// are none, no photos.
DatasetInfo parseDatasetInfo(const Json& json, const std::string& source);

} // namespace spherewalk::render
