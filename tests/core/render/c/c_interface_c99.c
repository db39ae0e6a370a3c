// SPDX-License-Identifier: Apache-2.0
// Compiled as C99 with all warnings: what a C program writes works, and the header is C.
#include "c/c_interface_c99.h"

#include "spherewalk/spherewalk.h"

#include <stdlib.h>
#include <string.h>

struct session {
    spherewalk_dataset* dataset;
    spherewalk_camera* camera;
    spherewalk_renderer* renderer;
    spherewalk_stream* stream;
    uint8_t* pixels;
};

static int listed(const spherewalk_dataset* dataset) {
    spherewalk_dataset_info info;
    spherewalk_photo photo;
    uint64_t i;
    if (spherewalk_dataset_info_init(&info, sizeof info) || spherewalk_photo_init(&photo, sizeof photo) ||
        spherewalk_dataset_get_info(dataset, &info)) {
        return 0;
    }
    for (i = 0; i < info.photo_count; ++i) {
        if (spherewalk_dataset_get_photo(dataset, i, &photo) || strlen(photo.file) == 0) {
            return 0;
        }
    }
    return info.photo_count > 0;
}

static int rendered(struct session* s) {
    spherewalk_intrinsics intrinsics;
    spherewalk_view view;
    spherewalk_report report;
    spherewalk_pose pose = {0, 0, 0, 1, 0, 0, 0};
    if (spherewalk_intrinsics_init(&intrinsics, sizeof intrinsics) ||
        spherewalk_view_init(&view, sizeof view) || spherewalk_report_init(&report, sizeof report) ||
        spherewalk_optical_pose(&pose, &pose) || spherewalk_camera_get_intrinsics(s->camera, &intrinsics)) {
        return 0;
    }
    view.rgb.row_stride_bytes = 3 * (uint64_t)intrinsics.width;
    view.rgb.size_bytes = view.rgb.row_stride_bytes * (uint64_t)intrinsics.height;
    s->pixels = malloc((size_t)view.rgb.size_bytes);
    view.rgb.data = s->pixels;
    return s->pixels != NULL &&
           !spherewalk_renderer_render(s->renderer, s->camera, &pose, NULL, &view, &report) &&
           report.trust > 0 && !spherewalk_stream_next(s->stream, &pose, 0.0, NULL, &view, NULL) &&
           !spherewalk_stream_wait_for_prefetch(s->stream);
}

static const char* run(struct session* s, const char* folder, const char* yaml) {
    if (spherewalk_dataset_open(folder, SPHEREWALK_VERIFY_HASHES, NULL, NULL, &s->dataset) ||
        spherewalk_camera_parse(yaml, strlen(yaml), &s->camera) ||
        spherewalk_renderer_create(s->dataset, NULL, &s->renderer) ||
        spherewalk_stream_create(s->renderer, s->camera, NULL, &s->stream)) {
        return spherewalk_last_error();
    }
    if (!listed(s->dataset)) {
        return "the photos were not listed";
    }
    return rendered(s) ? NULL : "nothing was rendered";
}

const char* spherewalkC99Session(const char* folder, const char* yaml) {
    struct session s = {NULL, NULL, NULL, NULL, NULL};
    const char* wrong = run(&s, folder, yaml);
    spherewalk_dataset_destroy(s.dataset);
    spherewalk_camera_destroy(s.camera);
    spherewalk_renderer_destroy(s.renderer);
    spherewalk_stream_destroy(s.stream);
    free(s.pixels);
    return wrong;
}
