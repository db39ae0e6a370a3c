// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/practice_pictures.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"
#include "spherewalk/photo/picture_file.h"
#include "spherewalk/practice/practice_room.h"
#include "spherewalk/render/sensor.h"

#include <iomanip>
#include <locale>
#include <sstream>

namespace spherewalk::jobs {

void drawPracticePictures(const practice::PracticeRoom& room, const CameraModel& camera,
                          std::span<const TimedPose> path, const std::filesystem::path& folder,
                          ProgressSink& progress, const std::stop_token& stop) {
    if (path.empty()) {
        throw Error(ErrorKind::InvalidInput, "The path has no pose; nothing was drawn.");
    }
    if (std::filesystem::exists(folder) && !std::filesystem::is_empty(folder)) {
        throw Error(ErrorKind::Exists,
                    text("The folder ", folder.string(), " has files already; give a new one."));
    }
    std::filesystem::create_directories(folder);
    std::ostringstream table;
    table.imbue(std::locale::classic());
    table << "file,x_m,y_m,z_m,qx,qy,qz,qw,depth\n" << std::setprecision(12);
    for (std::size_t i = 0; i < path.size(); ++i) {
        throwIfStopped(stop);
        progress.progress(static_cast<double>(i) / static_cast<double>(path.size()),
                          text("Drawing picture ", i + 1, " of ", path.size()));
        const Rigid3& pose = path[i].roomFromCamera;
        std::ostringstream name;
        name << std::setw(6) << std::setfill('0') << i;
        const std::string file = name.str() + ".png";
        const std::string depth = name.str() + "-depth.png";
        photo::writePng(folder / file, room.view(camera, pose));
        photo::writePng(folder / depth, render::depthMillimetres(room.viewDepth(camera, pose)));
        const Eigen::Vector3d& p = pose.translation;
        const Eigen::Quaterniond& q = pose.rotation;
        table << file << ',' << p.x() << ',' << p.y() << ',' << p.z() << ',' << q.x() << ',' << q.y() << ','
              << q.z() << ',' << q.w() << ',' << depth << '\n';
    }
    writeFile(folder / "pictures.csv", bytesOf(table.str()));
}

} // namespace spherewalk::jobs
