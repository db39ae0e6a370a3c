// SPDX-License-Identifier: GPL-3.0-or-later
// Makes what tests of nodes look at: OUT/dataset, of an endlessly far world whose colours differ in every
// direction, and OUT/camera.yaml. Usage: spherewalk_small_dataset OUT
#include "photographed_survey.h"

#include "spherewalk/jobs/export_dataset.h"
#include "spherewalk/render/camera_info.h"

#include <filesystem>

int main(int /*argc*/, char** argv) {
    using namespace spherewalk;
    const std::filesystem::path out = argv[1];
    std::filesystem::remove_all(out);
    std::filesystem::create_directories(out);
    const test::PhotographedSurvey survey{6};
    jobs::exportDataset(survey.open(), out / "dataset", {}, noProgress(), {});
    CameraIntrinsics camera{
        160, 120, 120, 121, 79.5, 60.5, LensModel::PlumbBob, {-0.1, 0.02, 1e-3, -1e-3, 0}};
    writeFile(out / "camera.yaml", bytesOf(render::cameraInfoYaml(camera, "robot")));
    return 0;
}
