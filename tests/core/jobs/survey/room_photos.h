// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "temporary_folder.h"

#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jobs/align_trade.h"
#include "spherewalk/jobs/import_photos.h"
#include "spherewalk/practice/practice_camera.h"
#include "spherewalk/practice/practice_room.h"
#include "spherewalk/practice/theta_jpeg.h"
#include "spherewalk/store/survey_store.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

namespace spherewalk::jobs {

/// Photos of a practice room, each turned by any yaw and tilted, and the survey that they are imported into.
/// A test may change pictures and places before the import.
class RoomPhotos : public testing::Test {
  protected:
    static constexpr int kWidth = 768;
    static constexpr double kStepM = 0.2;

    /// Photos of the lively room in rows along x.
    void photograph(int columns = 3, int rows = 2) {
        practice::PracticeRoomOptions options;
        options.originM = originM;
        const practice::PracticeRoom room(options);
        practice::PhotoErrors errors;
        errors.seed = 5;
        for (int i = 0; i < columns * rows; ++i) {
            const Eigen::Vector3d nominal =
                originM + Eigen::Vector3d(2.0 + kStepM * (i % columns), 1.6 + kStepM * (i / columns), 1.2);
            addPhoto(room, nominal, errors);
        }
    }

    /// Photos at these places of the practice flat: two rooms above a corridor, with a doorway each.
    void photographFlat(const std::vector<Eigen::Vector2d>& nominals) {
        const practice::PracticeRoom flat(flatOptions());
        size = flat.options().sizeM.head<2>();
        practice::PhotoErrors errors;
        errors.seed = 7;
        for (const Eigen::Vector2d& nominal : nominals) {
            addPhoto(flat, {nominal.x(), nominal.y(), 1.2}, errors);
        }
    }

    static practice::PracticeRoomOptions flatOptions() {
        practice::PracticeRoomOptions options;
        options.sizeM = {8, 6, 2.6};
        options.style = practice::RoomStyle::Flat;
        return options;
    }

    /// The first photos, as many as there are pictures, in a new survey of that name.
    store::SurveyStore newSurvey(const std::string& name = "s") const {
        survey::Room room;
        const Eigen::Vector2d corner = originM.head<2>();
        for (const Eigen::Vector2d& at : {Eigen::Vector2d(0, 0), {size.x(), 0}, size, {0, size.y()}}) {
            room.outline.emplace_back(corner + at);
        }
        room.ceilingM = 2.6;
        survey::PlanOptions options;
        options.stepM = 1;
        auto store = store::SurveyStore::create(folder / (name + ".spherewalk"), name, room, options,
                                                survey::plan(room, options));
        const std::filesystem::path in = folder / (name + "-photos");
        std::filesystem::create_directories(in);
        std::string csv = "file,x_m,y_m,z_m\n";
        for (std::size_t i = 0; i < pictures.size(); ++i) {
            practice::ThetaTags tags; // which say how the camera leaned, to a tenth of a degree
            if (i < truth.size()) {
                const YawPitchRoll angles = yawPitchRoll(truth[i].rotation);
                tags.posePitchDeg = -Degrees(angles.pitch).value() + (i == liar ? 40 : 0);
                tags.poseRollDeg = Degrees(angles.roll).value();
            }
            writeFile(in / fileOf(i), practice::thetaJpeg(pictures[i], tags));
            csv += text(fileOf(i), ",", fixed(places[i].x(), 3), ",", fixed(places[i].y(), 3), ",",
                        fixed(places[i].z(), 3), "\n");
        }
        writeFile(folder / (name + ".csv"), bytesOf(csv));
        importPhotos(store, {in, folder / (name + ".csv")}, noProgress(), {});
        return store;
    }

    TruePoses truePoses(const store::SurveyStore& store) const {
        TruePoses poses;
        for (const store::PhotoRecord& photo : store.photos()) {
            poses.emplace(photo.id, truth.at(numberOf(photo.cameraFileName)));
        }
        return poses;
    }

    static std::string fileOf(std::size_t photo) { return text("R", photo, ".JPG"); }

    /// The photo's number in the order of its taking, from its file's name.
    static std::size_t numberOf(const std::string& file) { return std::stoul(file.substr(1)); }

    static const AlignedPhoto& photoOf(const AlignReport& report, std::string_view file) {
        return *std::find_if(report.photos.begin(), report.photos.end(),
                             [&](const AlignedPhoto& photo) { return photo.file == file; });
    }

    test::TemporaryFolder folder;
    Eigen::Vector3d originM = Eigen::Vector3d::Zero(); ///< the floor's south-west corner
    Eigen::Vector2d size{5, 4};                        ///< of the floor
    std::vector<Rigid3> truth;
    std::vector<Eigen::Vector3d> places; ///< as the positions file says
    std::vector<RgbImage> pictures;
    std::optional<std::size_t> liar; ///< photo whose metadata state a pitch that is 40 degrees off

  private:
    void addPhoto(const practice::PracticeRoom& room, const Eigen::Vector3d& nominal,
                  const practice::PhotoErrors& errors) {
        places.push_back(nominal);
        truth.push_back(errors.truePose(nominal, static_cast<int>(places.size())));
        pictures.push_back(room.spherical(truth.back(), {kWidth, kWidth / 2}));
    }
};

} // namespace spherewalk::jobs
