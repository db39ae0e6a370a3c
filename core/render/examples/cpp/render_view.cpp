// SPDX-License-Identifier: Apache-2.0
// Renders what a camera sees 10 cm beside the first photo of a dataset, and writes it as a picture.
#include <fstream>
#include <iostream>
#include <spherewalk/base/error.h>
#include <spherewalk/geometry/rotation.h>
#include <spherewalk/render/renderer.h>

namespace render = spherewalk::render;

namespace {

void writePpm(const char* file, const spherewalk::RgbImage& picture) {
    std::ofstream out(file, std::ios::binary);
    out << "P6\n" << picture.width() << ' ' << picture.height() << "\n255\n";
    const auto values = picture.values();
    out.write(reinterpret_cast<const char*>(values.data()), static_cast<std::streamsize>(values.size()));
    if (!out.flush()) {
        throw spherewalk::Error(spherewalk::ErrorKind::Io, std::string("Could not write ") + file + ".");
    }
}

void renderView(const char* folder, const char* file) {
    const auto dataset = std::make_shared<const render::Dataset>(render::Dataset::open(folder));
    const render::Renderer renderer(dataset);
    const spherewalk::CameraModel camera(spherewalk::CameraIntrinsics::pinhole(640, 480, 1.2));

    // The body of the camera looks along the room's x axis; views are rendered for its optical frame.
    spherewalk::Rigid3 roomFromCamera;
    roomFromCamera.rotation = spherewalk::bodyFromOptical();
    roomFromCamera.translation = dataset->info().photos.front().roomFromPhoto.translation;
    roomFromCamera.translation.x() += 0.1;

    const render::View view = renderer.render(camera, roomFromCamera);
    writePpm(file, view.picture);
    std::cout << "From " << view.report.file << ", " << view.report.offsetM
              << " m away, with the scene model " << name(view.report.scene) << ": trust "
              << view.report.trust << ", decoded in " << view.report.decodeMs << " ms, rendered in "
              << view.report.renderMs << " ms.\n";
}

} // namespace

int main(int count, char** arguments) {
    if (count != 3) {
        std::cerr << "Usage: render_view DATASET OUT.ppm\n";
        return 2;
    }
    try {
        renderView(arguments[1], arguments[2]);
        return 0;
    } catch (const spherewalk::Error& error) {
        std::cerr << error.sentence() << '\n';
        return 1;
    }
}
