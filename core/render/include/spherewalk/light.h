// SPDX-License-Identifier: Apache-2.0
#pragma once

/// The light at a place of a room, in C99. What spherewalk.h says of all functions holds here, too.

#include "spherewalk/spherewalk.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Light is linear red, green and blue; 1 is what the photo stores as white.
typedef struct spherewalk_probe_options {
    size_t struct_size;
    int32_t width;         ///< Pixels; the probe is half as high. Range: even, 16 to 8192. Default: 512.
    int32_t scene;         ///< Default: SPHEREWALK_SCENE_BEST.
    int32_t threads;       ///< The most to use, 0 for all. The values are the same for any number.
    int32_t photo_colours; ///< 1 leaves out the dataset's colour correction. Default: 0.
} spherewalk_probe_options;

SPHEREWALK_API spherewalk_status spherewalk_probe_options_init(spherewalk_probe_options* options,
                                                               size_t size);

/// The memory that a probe's pictures are written to: equirectangular, the centre along the room's x. A
/// buffer without data is not wanted. Shape: width x width / 2 pixels.
typedef struct spherewalk_probe {
    size_t struct_size;
    spherewalk_buffer radiance; ///< Three floats a pixel. Values above 1 come from darker photos.
    spherewalk_buffer clipped;  ///< A byte a pixel: 255 where the light was too bright for all photos.
} spherewalk_probe;

SPHEREWALK_API spherewalk_status spherewalk_probe_init(spherewalk_probe* probe, size_t size);

/// What simulators need of the light at a place. The C++ header light_probe.h explains the members.
typedef struct spherewalk_light {
    size_t struct_size;
    uint64_t photo;         ///< The index of the photo whose white is 1.
    int32_t is_outside;     ///< 1 if the place is outside of what was scanned.
    int32_t sees_place;     ///< 0 if no photo sees the place.
    double clipped_share;   ///< The share of all directions in which the light was too bright.
    double recovered_share; ///< The share of directions whose light a darker photo showed.
    double towards[3];      ///< The unit vector to where the dominant light comes from, in the room.
    double irradiance[3];   ///< What the dominant light throws on a surface that faces it.
    double ambient[3];      ///< The radiance that comes from everywhere besides.
    double share;           ///< The dominant light's part of what falls on a surface that faces it.
    /// The sums of radiance times harmonic, (l, m) = (0, 0), (1, -1), (1, 0), (1, 1), (2, -2) ... (2, 2).
    double harmonics[9][3];
} spherewalk_light;

SPHEREWALK_API spherewalk_status spherewalk_light_init(spherewalk_light* light, size_t size);

/// Finds the light at a place, metres in the room. options, probe, light: may be NULL.
SPHEREWALK_API spherewalk_status spherewalk_renderer_probe(const spherewalk_renderer* renderer,
                                                           const double place_m[3],
                                                           const spherewalk_probe_options* options,
                                                           const spherewalk_probe* probe,
                                                           spherewalk_light* light);

#ifdef __cplusplus
}
#endif
