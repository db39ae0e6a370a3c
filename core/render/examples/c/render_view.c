// SPDX-License-Identifier: Apache-2.0
// Renders what a camera sees 10 cm beside the first photo of a dataset, and writes it as a picture.
#include <spherewalk/spherewalk.h>
#include <stdio.h>
#include <stdlib.h>

// Calls that fail end the program with the library's sentence.
static void check(spherewalk_status status) {
    if (status != SPHEREWALK_OK) {
        fprintf(stderr, "%s\n", spherewalk_last_error());
        exit(1);
    }
}

static spherewalk_camera* makeCamera(int width, int height, double horizontalFovRad) {
    spherewalk_intrinsics intrinsics;
    spherewalk_camera* camera = NULL;
    check(spherewalk_intrinsics_init(&intrinsics, sizeof intrinsics));
    check(spherewalk_intrinsics_pinhole(width, height, horizontalFovRad, &intrinsics));
    check(spherewalk_camera_create(&intrinsics, &camera));
    return camera;
}

// The body of the camera looks along the room's x axis; views are rendered for its optical frame.
static spherewalk_pose poseBeside(const spherewalk_photo* photo) {
    spherewalk_pose pose = {0, 0, 0, 1, 0, 0, 0};
    pose.x = photo->room_from_photo.x + 0.1;
    pose.y = photo->room_from_photo.y;
    pose.z = photo->room_from_photo.z;
    check(spherewalk_optical_pose(&pose, &pose));
    return pose;
}

static void writePpm(const char* name, const unsigned char* pixels, int width, int height) {
    const size_t size = 3 * (size_t)width * (size_t)height;
    FILE* file = fopen(name, "wb");
    if (file == NULL || fprintf(file, "P6\n%d %d\n255\n", width, height) < 0 ||
        fwrite(pixels, 1, size, file) != size || fclose(file) != 0) {
        fprintf(stderr, "Could not write %s.\n", name);
        exit(1);
    }
}

static void printReport(const spherewalk_dataset* dataset, const spherewalk_report* report) {
    spherewalk_photo photo;
    check(spherewalk_photo_init(&photo, sizeof photo));
    check(spherewalk_dataset_get_photo(dataset, report->photo, &photo));
    printf("From %s, %g m away, with the scene model %s: trust %g, decoded in %g ms, rendered in %g ms.\n",
           photo.file, report->offset_m, spherewalk_scene_name(report->scene), report->trust,
           report->decode_ms, report->render_ms);
}

int main(int count, char** arguments) {
    enum { WIDTH = 640, HEIGHT = 480 };

    static unsigned char pixels[3 * WIDTH * HEIGHT];
    spherewalk_dataset* dataset = NULL;
    spherewalk_renderer* renderer = NULL;
    spherewalk_camera* camera = NULL;
    spherewalk_photo photo;
    spherewalk_pose pose;
    spherewalk_view view;
    spherewalk_report report;
    if (count != 3) {
        fprintf(stderr, "Usage: render_view DATASET OUT.ppm\n");
        return 2;
    }
    check(spherewalk_dataset_open(arguments[1], SPHEREWALK_VERIFY_SIZES, NULL, NULL, &dataset));
    check(spherewalk_renderer_create(dataset, NULL, &renderer));
    camera = makeCamera(WIDTH, HEIGHT, 1.2);
    check(spherewalk_photo_init(&photo, sizeof photo));
    check(spherewalk_dataset_get_photo(dataset, 0, &photo));
    pose = poseBeside(&photo);

    check(spherewalk_view_init(&view, sizeof view));
    view.rgb.data = pixels;
    view.rgb.size_bytes = sizeof pixels;
    view.rgb.row_stride_bytes = 3 * WIDTH;
    check(spherewalk_report_init(&report, sizeof report));
    check(spherewalk_renderer_render(renderer, camera, &pose, NULL, &view, &report));
    writePpm(arguments[2], pixels, WIDTH, HEIGHT);
    printReport(dataset, &report);

    spherewalk_camera_destroy(camera);
    spherewalk_renderer_destroy(renderer);
    spherewalk_dataset_destroy(dataset);
    return 0;
}
