// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Frames of a sensor that is not perfect, in C99. What spherewalk.h says of all functions holds here, too.

#include "spherewalk/spherewalk.h"

#ifdef __cplusplus
extern "C" {
#endif

/// A sensor that is not perfect: noise, exposure, blur and other effects of a YAML file, for one camera.
/// Where exposure or white balance is automatic, each frame depends on those before. One thread at a time may
/// use it: a second one gets SPHEREWALK_BUSY.
typedef struct spherewalk_sensor spherewalk_sensor;

/// Makes the sensor of a YAML file, which may be the camera-info with an entry `sensor`.
SPHEREWALK_API spherewalk_status spherewalk_sensor_read(const char* file, const spherewalk_camera* camera,
                                                        spherewalk_sensor** sensor);
/// The same from the YAML's text, at most a megabyte.
SPHEREWALK_API spherewalk_status spherewalk_sensor_parse(const char* yaml, uint64_t size_bytes,
                                                         const spherewalk_camera* camera,
                                                         spherewalk_sensor** sensor);
SPHEREWALK_API void spherewalk_sensor_destroy(spherewalk_sensor* sensor);

/// A pose of the optical frame at a time.
typedef struct spherewalk_timed_pose {
    double time_s;
    spherewalk_pose room_from_camera;
} spherewalk_timed_pose;

/// Takes the stream's next frame by the sensor, whose camera must be the stream's. poses: at least one, with
/// ascending times; the camera moves evenly between them, and goes on so before the first and after the last.
/// time_s: the frame's, in the middle of the exposure of its first row. frame: its number, which decides its
/// noise. Overlays are those of the frame's time. A depth has the errors of the sensor; -infinity is too
/// near.
SPHEREWALK_API spherewalk_status spherewalk_stream_take(spherewalk_stream* stream, spherewalk_sensor* sensor,
                                                        const spherewalk_timed_pose* poses,
                                                        uint64_t pose_count, double time_s, uint64_t frame,
                                                        const spherewalk_view_options* options,
                                                        const spherewalk_view* view,
                                                        spherewalk_report* report);

#ifdef __cplusplus
}
#endif
