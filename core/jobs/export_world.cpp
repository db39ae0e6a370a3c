// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/export_world.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/new_folder.h"
#include "spherewalk/base/text.h"
#include "spherewalk/render/camera_info.h"
#include "spherewalk/render/dataset.h"
#include "spherewalk/store/survey_store.h"

#include <algorithm>
#include <vector>

namespace spherewalk::jobs {

namespace {

Eigen::Vector3d mostCentral(const std::vector<Eigen::Vector3d>& places, const std::filesystem::path& folder) {
    if (places.empty()) {
        throw Error(ErrorKind::InvalidInput,
                    text("No place for the robot's camera is known: ", folder.string(), " has no stations."));
    }
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& place : places) {
        middle += place / static_cast<double>(places.size());
    }
    return *std::min_element(places.begin(), places.end(),
                             [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
                                 return (a - middle).squaredNorm() < (b - middle).squaredNorm();
                             });
}

dataset::WorldRoom roomOfDataset(const std::filesystem::path& folder) {
    const render::Dataset opened = render::Dataset::open(folder);
    const render::DatasetInfo& info = opened.info();
    std::vector<Eigen::Vector3d> places;
    for (const render::DatasetPhoto& photo : info.photos) {
        places.push_back(photo.roomFromPhoto.translation);
    }
    const Eigen::Vector3d start = mostCentral(places, folder);
    if (info.roomShape) {
        return {info.name, info.roomShape->outline, info.roomShape->floorM, info.roomShape->ceilingM, start};
    }
    return {info.name, info.outline, 0, info.ceilingM, start};
}

dataset::WorldRoom roomOfSurvey(const std::filesystem::path& folder) {
    const auto store = store::SurveyStore::open(folder, store::Access::Read);
    const survey::Room room = store.room();
    std::vector<Eigen::Vector3d> places;
    for (const store::PhotoRecord& photo : store.keptPhotos()) {
        places.push_back(photo.positionM);
    }
    if (places.empty()) {
        for (const store::StationRecord& station : store.stations()) {
            places.push_back(station.station.positionM);
        }
    }
    return {store.info().name, room.outline, 0, room.ceilingM, mostCentral(places, folder)};
}

} // namespace

dataset::WorldRoom worldRoomOf(const std::filesystem::path& folder) {
    return std::filesystem::exists(folder / render::kDatasetFile) ? roomOfDataset(folder)
                                                                  : roomOfSurvey(folder);
}

void exportWorld(const dataset::WorldRoom& room, const CameraIntrinsics& camera,
                 const std::filesystem::path& folder) {
    const std::string world = dataset::sdfWorld(room, camera);
    makeFolder(folder, "the world", [&](const std::filesystem::path& unfinished) {
        writeFile(unfinished / "world.sdf", bytesOf(world));
        writeFile(unfinished / "camera.yaml", bytesOf(render::cameraInfoYaml(camera, "robot")));
    });
}

} // namespace spherewalk::jobs
