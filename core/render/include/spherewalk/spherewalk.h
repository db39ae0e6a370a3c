// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stddef.h>
#include <stdint.h>

/// The view of a robot's camera from a dataset, for C99 and for every language that calls C.
///
/// Errors: a function that can fail returns a spherewalk_status. If it is not SPHEREWALK_OK,
/// spherewalk_last_error() has a sentence for people. The output arguments are then unchanged, and a handle
/// that was to be made is NULL.
///
/// Structs that begin with struct_size are made ready by their _init(), which takes their sizeof. Later
/// versions add members at the end, and the defaults of these change nothing. So a program works with any
/// later library of the same major version without being compiled again. A size that the library does not
/// know, such as that of a newer header, is SPHEREWALK_INVALID_INPUT.
///
/// Pointers may be NULL only where the comment says so; otherwise NULL is SPHEREWALK_INVALID_INPUT. Strings
/// are UTF-8 and end with NUL.
///
/// Handles are given back with their _destroy(), in any order, each once; NULL is ignored. A renderer keeps
/// what it needs of its dataset, and a stream what it needs of its renderer and camera.
///
/// Threads: all functions may be called from any thread, also with the same handle. But one thread at a time
/// may use a stream: a second one gets SPHEREWALK_BUSY. Nobody may use a handle while it is given back.
///
/// Units: metres, radians, seconds, pixels. The centre of pixel (0, 0) has the coordinates (0, 0).

#if defined(__GNUC__)
#define SPHEREWALK_API __attribute__((visibility("default")))
#else
#define SPHEREWALK_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

#define SPHEREWALK_VERSION_MAJOR 0
#define SPHEREWALK_VERSION_MINOR 1
#define SPHEREWALK_VERSION_PATCH 0
/// The version of this header. spherewalk_version_number() gives that of the library.
#define SPHEREWALK_VERSION_NUMBER                                                                            \
    (SPHEREWALK_VERSION_MAJOR * 1000000 + SPHEREWALK_VERSION_MINOR * 1000 + SPHEREWALK_VERSION_PATCH)

/// The version of the library, for example "0.1.0".
SPHEREWALK_API const char* spherewalk_version(void);
SPHEREWALK_API int32_t spherewalk_version_number(void);

/// How a call ended. Values keep their meaning for ever, and new ones may come.
typedef int32_t spherewalk_status;

enum {
    SPHEREWALK_OK = 0,
    SPHEREWALK_INVALID_INPUT = 1, ///< An argument cannot be used.
    SPHEREWALK_NOT_FOUND = 2,     ///< A file does not exist.
    SPHEREWALK_EXISTS = 3,
    SPHEREWALK_IO = 4, ///< The operating system refused to read.
    SPHEREWALK_NETWORK = 5,
    SPHEREWALK_TIMEOUT = 6,
    SPHEREWALK_STOPPED = 7,     ///< The caller asked to stop.
    SPHEREWALK_CORRUPT = 8,     ///< A file contradicts itself, its format or its dataset.
    SPHEREWALK_UNSUPPORTED = 9, ///< The input is well-formed, but this version cannot use it.
    SPHEREWALK_BUSY = 10,       ///< Another thread uses the handle.
    SPHEREWALK_FULL = 11,       ///< No memory is left.
    SPHEREWALK_INTERNAL = 12    ///< The library has a defect.
};

/// The word that logs use for the status, for example "invalid_input"; "unknown" for other numbers.
SPHEREWALK_API const char* spherewalk_status_name(spherewalk_status status);

/// The sentence of this thread's latest call that failed: what went wrong, and what to do. It is "" before
/// the first. Owner: the library, until this thread's next call that fails. Sentences are cut after 4000
/// bytes.
SPHEREWALK_API const char* spherewalk_last_error(void);

/// The position and the rotation of a body in the room: p_in_room = rotation * p_in_body + (x, y, z). The
/// room has z up. The quaternion must have unit length, to within 0.001.
typedef struct spherewalk_pose {
    double x, y, z;
    double qw, qx, qy, qz;
} spherewalk_pose;

/// Turns the pose of a camera's body (x forward, y left, z up: REP 103) into that of its optical frame (z
/// forward, x right, y down). All other functions take the latter. The two arguments may be the same
/// variable.
SPHEREWALK_API spherewalk_status spherewalk_optical_pose(const spherewalk_pose* room_from_body,
                                                         spherewalk_pose* room_from_camera);

// ---- Datasets

typedef struct spherewalk_dataset spherewalk_dataset;

/// How much of a dataset is checked when it is opened.
enum {
    SPHEREWALK_VERIFY_SIZES = 0, ///< All files must exist and have their sizes.
    SPHEREWALK_VERIFY_HASHES = 1 ///< The SHA-256 of every photo is checked, too.
};

/// A function of the caller that gets the progress of a long call, in [0, 1]. Threads of the library call it,
/// one at a time. If it returns anything but 0, the long call stops (SPHEREWALK_STOPPED).
typedef int32_t (*spherewalk_progress)(void* user, double fraction);

/// Opens and checks a dataset. folder: the folder with dataset.json. verify: SPHEREWALK_VERIFY_... progress:
/// may be NULL. user: the first argument of `progress`.
SPHEREWALK_API spherewalk_status spherewalk_dataset_open(const char* folder, int32_t verify,
                                                         spherewalk_progress progress, void* user,
                                                         spherewalk_dataset** dataset);
SPHEREWALK_API void spherewalk_dataset_destroy(spherewalk_dataset* dataset);

/// Owner: the dataset's handle owns the strings here and in spherewalk_photo.
typedef struct spherewalk_dataset_info {
    size_t struct_size;
    const char* id;
    const char* name;
    uint64_t photo_count;
    uint64_t camera_count;
    double sphere_radius_m; ///< The radius of the sphere scene model; 0 without one.
    double ceiling_m;       ///< The height of the ceiling; 0 if it is unknown.
    double step_m;          ///< The step of the planned grid; 0 without a grid.
} spherewalk_dataset_info;

SPHEREWALK_API spherewalk_status spherewalk_dataset_info_init(spherewalk_dataset_info* info, size_t size);
SPHEREWALK_API spherewalk_status spherewalk_dataset_get_info(const spherewalk_dataset* dataset,
                                                             spherewalk_dataset_info* info);

typedef struct spherewalk_photo {
    size_t struct_size;
    const char* file;            ///< The name, relative to the dataset.
    const char* station;         ///< The name that people give to the spot.
    const char* rotation_source; ///< "imported", "aligned", "metadata" or "unknown".
    int32_t width;
    int32_t height;
    spherewalk_pose room_from_photo; ///< The pose of the panorama frame: x forward, y left, z up.
    double position_sigma_m[3];      ///< Standard deviations along x, y, z; NaN if unknown.
    double rotation_sigma_rad[3];    ///< Standard deviations of yaw, pitch, roll; NaN if unknown.
} spherewalk_photo;

SPHEREWALK_API spherewalk_status spherewalk_photo_init(spherewalk_photo* photo, size_t size);
/// Describes a photo. Range: index below photo_count.
SPHEREWALK_API spherewalk_status spherewalk_dataset_get_photo(const spherewalk_dataset* dataset,
                                                              uint64_t index, spherewalk_photo* photo);

// ---- Cameras

/// The lens models of ROS camera_info. Each comment lists the distortion parameters in order.
enum {
    SPHEREWALK_LENS_PINHOLE = 0,             ///< It has no parameters.
    SPHEREWALK_LENS_PLUMB_BOB = 1,           ///< k1 k2 p1 p2 k3.
    SPHEREWALK_LENS_RATIONAL_POLYNOMIAL = 2, ///< k1 k2 p1 p2 k3 k4 k5 k6, then s1 s2 s3 s4, then two tilts.
    SPHEREWALK_LENS_EQUIDISTANT = 3          ///< k1 k2 k3 k4 of the angle to the axis.
};

typedef struct spherewalk_intrinsics {
    size_t struct_size;
    int32_t width; ///< Range: 1 to 32768 pixels; height likewise.
    int32_t height;
    double fx;
    double fy;
    double cx;
    double cy;
    int32_t lens;
    int32_t distortion_count; ///< The number of parameters that the lens model has: 0, 4, 5, 8, 12 or 14.
    double distortion[14];
} spherewalk_intrinsics;

SPHEREWALK_API spherewalk_status spherewalk_intrinsics_init(spherewalk_intrinsics* intrinsics, size_t size);
/// Describes a camera without distortion whose axis meets the picture's centre. intrinsics: ready from its
/// _init(). Range: 0 < horizontal_fov_rad < pi.
SPHEREWALK_API spherewalk_status spherewalk_intrinsics_pinhole(int32_t width, int32_t height,
                                                               double horizontal_fov_rad,
                                                               spherewalk_intrinsics* intrinsics);
/// A camera that the dataset suggests. index: below camera_count. name: may be NULL; the dataset owns it.
SPHEREWALK_API spherewalk_status spherewalk_dataset_get_camera(const spherewalk_dataset* dataset,
                                                               uint64_t index, const char** name,
                                                               spherewalk_intrinsics* intrinsics);

typedef struct spherewalk_camera spherewalk_camera;

SPHEREWALK_API spherewalk_status spherewalk_camera_create(const spherewalk_intrinsics* intrinsics,
                                                          spherewalk_camera** camera);
/// Makes the camera of a ROS camera-info YAML file.
SPHEREWALK_API spherewalk_status spherewalk_camera_read(const char* file, spherewalk_camera** camera);
/// The same from the YAML's text, at most a megabyte. size_bytes: the length without a NUL.
SPHEREWALK_API spherewalk_status spherewalk_camera_parse(const char* yaml, uint64_t size_bytes,
                                                         spherewalk_camera** camera);
SPHEREWALK_API void spherewalk_camera_destroy(spherewalk_camera* camera);
SPHEREWALK_API spherewalk_status spherewalk_camera_get_intrinsics(const spherewalk_camera* camera,
                                                                  spherewalk_intrinsics* intrinsics);

// ---- Views

typedef struct spherewalk_renderer spherewalk_renderer;

/// When the SHA-256 of a photo is compared with the one in dataset.json.
enum {
    SPHEREWALK_VERIFY_PHOTOS_BEFORE_USE = 0,   ///< At its first use: the view waits for it.
    SPHEREWALK_VERIFY_PHOTOS_IN_BACKGROUND = 1 ///< Some time later, by a stream: see is_verified.
};

typedef struct spherewalk_renderer_options {
    size_t struct_size;
    uint64_t cache_bytes;  ///< Budget for decoded pixels; pixels in use stay in any case. Default: 512 MiB.
    int32_t verify_photos; ///< Default: SPHEREWALK_VERIFY_PHOTOS_BEFORE_USE.
    int32_t reserved;      ///< It must be 0.
} spherewalk_renderer_options;

SPHEREWALK_API spherewalk_status spherewalk_renderer_options_init(spherewalk_renderer_options* options,
                                                                  size_t size);
/// Makes a renderer. options: may be NULL. A dataset that was opened with SPHEREWALK_VERIFY_HASHES is not
/// verified again.
SPHEREWALK_API spherewalk_status spherewalk_renderer_create(const spherewalk_dataset* dataset,
                                                            const spherewalk_renderer_options* options,
                                                            spherewalk_renderer** renderer);
SPHEREWALK_API void spherewalk_renderer_destroy(spherewalk_renderer* renderer);

/// What the scene is taken to be when a camera stands beside the photo.
enum {
    SPHEREWALK_SCENE_BEST = 0,   ///< The dataset's choice, or its best scene model.
    SPHEREWALK_SCENE_NONE = 1,   ///< Everything is infinitely far: the nearest photo is only turned.
    SPHEREWALK_SCENE_SPHERE = 2, ///< Everything lies on a sphere about the photo.
    SPHEREWALK_SCENE_ROOM = 3,   ///< There are walls, a floor and a ceiling, and nothing else.
    SPHEREWALK_SCENE_DEPTH = 4,  ///< The distance of each of the photo's pixels was measured.
    SPHEREWALK_SCENE_BLEND = 5   ///< The distances are those of depth, and photos that agree are mixed.
};

/// How a view's pixel is made from the photo's pixels, cheap to exact. The C++ header ladder.h explains them.
enum {
    SPHEREWALK_SAMPLING_DEFAULT = 0, ///< It means SPHEREWALK_SAMPLING_BEST.
    SPHEREWALK_SAMPLING_NEAREST = 1,
    SPHEREWALK_SAMPLING_BILINEAR = 2,
    SPHEREWALK_SAMPLING_REDUCED = 3,
    SPHEREWALK_SAMPLING_FOOTPRINT = 4,
    SPHEREWALK_SAMPLING_BICUBIC = 5,
    SPHEREWALK_SAMPLING_AUTO = 6, ///< The cheapest that is expected to reach tolerance_db.
    SPHEREWALK_SAMPLING_BEST = 7  ///< Bicubic where the photo is magnified, else footprint.
};

/// Pixels of the caller, row after row from the top left one.
typedef struct spherewalk_source {
    const void* data;
    uint64_t size_bytes;       ///< At least row_stride_bytes * (height - 1) and one row.
    uint64_t row_stride_bytes; ///< Bytes from one row to the next, at least a row's.
} spherewalk_source;

/// Memory of the caller that pixels are written to, as spherewalk_source has it. Bytes between rows stay.
typedef struct spherewalk_buffer {
    void* data;
    uint64_t size_bytes;
    uint64_t row_stride_bytes;
} spherewalk_buffer;

/// Whether the colours of an overlay are already multiplied by its alpha.
enum { SPHEREWALK_ALPHA_STRAIGHT = 0, SPHEREWALK_ALPHA_PREMULTIPLIED = 1 };

/// Objects that a simulator rendered from the view's own pose, to be laid into the view. Depths are floats: z
/// along the optical axis in metres. A value that is not finite and above zero counts as no depth. Shape:
/// that of the camera.
typedef struct spherewalk_overlay {
    size_t struct_size;
    const spherewalk_intrinsics* camera; ///< The camera of the picture; NULL for the view's.
    spherewalk_source rgba;              ///< 4 bytes a pixel.
    spherewalk_source depth;             ///< The depth of the objects, a float a pixel.
    /// The depth of the room as the simulator models it, a float a pixel. If its data are NULL, the depth of
    /// the view's scene model takes its place.
    spherewalk_source room_depth;
    int32_t alpha;    ///< Default: SPHEREWALK_ALPHA_STRAIGHT.
    int32_t reserved; ///< It must be 0.
    /// The share of light that the objects leave to what photos show, a float from 0 to 1 a pixel.
    spherewalk_source shadow; ///< Its data are NULL where objects cast no shadow.
} spherewalk_overlay;

SPHEREWALK_API spherewalk_status spherewalk_overlay_init(spherewalk_overlay* overlay, size_t size);

/// The border between an object and what hides it.
enum {
    SPHEREWALK_EDGES_SOFT = 0, ///< It is softened by a pixel on either side, as in photos.
    SPHEREWALK_EDGES_HARD = 1  ///< A pixel is shown or hidden as a whole.
};

typedef struct spherewalk_view_options {
    size_t struct_size;
    int32_t scene;       ///< Default: SPHEREWALK_SCENE_BEST.
    int32_t sampling;    ///< Default: SPHEREWALK_SAMPLING_DEFAULT.
    int32_t threads;     ///< The most to use, 0 for all. The pixels are the same for any number.
    int32_t is_exact;    ///< 1 computes exactly, bilinearly, and a hundred times slower. Default: 0.
    double tolerance_db; ///< The tolerance of SPHEREWALK_SAMPLING_AUTO. Default: 40.
    const spherewalk_overlay* const* overlays; ///< They are laid into the picture. NULL: none.
    uint64_t overlay_count;                    ///< Range: up to 1000.
    /// How far an object may lie behind the room's surface and still be shown. The larger of metres (default
    /// 0.005) and share of the room's depth (default 0.002) counts.
    double overlay_tolerance_m;
    double overlay_tolerance_share;
    int32_t overlay_edges; ///< Default: SPHEREWALK_EDGES_SOFT.
    int32_t photo_colours; ///< 1 leaves out the dataset's colour correction. Default: 0.
} spherewalk_view_options;

SPHEREWALK_API spherewalk_status spherewalk_view_options_init(spherewalk_view_options* options, size_t size);

/// What is to be known of a pixel. Flags are bits: several may hold.
enum {
    SPHEREWALK_PIXEL_UNSEEN = 1, ///< The lens sees nothing there.
    SPHEREWALK_PIXEL_POLE = 2,   ///< It is near the photo's zenith or nadir, where the camera's own foot is.
    SPHEREWALK_PIXEL_STITCHING = 4, ///< It is near where the pictures of a camera's two lenses were joined.
    SPHEREWALK_PIXEL_SEAM = 8, ///< It comes partly from the photo's left border, partly from its right one.
    SPHEREWALK_PIXEL_COARSE = 16,  ///< It is blurred, since the view was made from a coarser picture.
    SPHEREWALK_PIXEL_OVERLAY = 32, ///< An overlay covers at least a part of it.
    SPHEREWALK_PIXEL_FILLED = 64,  ///< No photo shows what is there: it was filled in from beside.
    SPHEREWALK_PIXEL_UNSURE = 128  ///< It may be displaced by more than two pixels, or nothing is known.
};

/// The memory that a view is written to. A buffer without data is not wanted and costs nothing; rgb must have
/// data. Shape: that of the camera's picture.
typedef struct spherewalk_view {
    size_t struct_size;
    spherewalk_buffer rgb; ///< Red, green, blue: 3 bytes a pixel. Black where the lens sees nothing.
    /// The scene model's depth, a float a pixel: z along the optical axis in metres, +infinity if unknown.
    spherewalk_buffer depth;
    /// By how many pixels the shown thing is displaced, a float a pixel; +infinity where nothing is known.
    spherewalk_buffer error_px;
    spherewalk_buffer flags;    ///< SPHEREWALK_PIXEL_..., a byte a pixel.
    spherewalk_buffer overlaid; ///< How much of it overlays cover, a byte a pixel, 255 for all.
} spherewalk_view;

SPHEREWALK_API spherewalk_status spherewalk_view_init(spherewalk_view* view, size_t size);

/// The picture that a view's pixels come from.
enum {
    SPHEREWALK_ORIGIN_PHOTO = 0,     ///< The nearest photo.
    SPHEREWALK_ORIGIN_THUMBNAIL = 1, ///< The nearest photo's thumbnail, since the photo was not decoded yet.
    SPHEREWALK_ORIGIN_PREVIOUS = 2   ///< The photo of the view before, since the nearest was not decoded yet.
};

/// What a view was made from, and how far it can be trusted.
typedef struct spherewalk_report {
    size_t struct_size;
    uint64_t photo;          ///< The photo's index.
    int32_t scene;           ///< The scene model that was used.
    int32_t sampling;        ///< The sampling that was used.
    int32_t origin;          ///< SPHEREWALK_ORIGIN_...
    int32_t is_late;         ///< 1 if a part of the photo was not in memory when the view was asked for.
    int32_t is_verified;     ///< 1 if the photo's hash is known to be the one in dataset.json.
    int32_t is_whole_decode; ///< 1 if all of the photo was decoded, as it has no restart markers.
    double offset_m;         ///< The distance between the camera and the photo.
    double parallax_px;      ///< By how many pixels things are displaced: the median over the view.
    double blur_px;          ///< The blur of a thumbnail.
    double trust;            ///< 1 / (1 + parallax_px + blur_px); 0 where nothing is known, as outside.
    double decode_ms;        ///< How long the view waited for tiles to be decoded.
    double render_ms;
    int64_t decoded_tiles; ///< The number of tiles that the view waited for.
    int32_t is_outside;    ///< 1 if the camera is outside of what was scanned.
    int32_t sees_place;    ///< 0 if no photo sees the camera's place, so that the nearest ones are shown.
    double seen_share;     ///< The share of pixels that are neither filled nor unsure.
    double filled_share;   ///< The share of pixels that the first photo does not show.
} spherewalk_report;

SPHEREWALK_API spherewalk_status spherewalk_report_init(spherewalk_report* report, size_t size);

/// Makes the view from this pose of the optical frame. It may wait. options, report: may be NULL.
SPHEREWALK_API spherewalk_status spherewalk_renderer_render(const spherewalk_renderer* renderer,
                                                            const spherewalk_camera* camera,
                                                            const spherewalk_pose* room_from_camera,
                                                            const spherewalk_view_options* options,
                                                            const spherewalk_view* view,
                                                            spherewalk_report* report);

/// How much a renderer and its streams have decoded. A request is the part of one photo that one view needs.
typedef struct spherewalk_load_counters {
    size_t struct_size;
    uint64_t hits;          ///< Requests with all their tiles in memory.
    uint64_t late;          ///< All other requests.
    uint64_t waits;         ///< Late requests that waited.
    uint64_t decoded_tiles; ///< Tiles that requests waited for.
    uint64_t prefetched_tiles;
    uint64_t dropped_tiles;
    uint64_t whole_decodes;   ///< Decodes of whole photos, as they cannot be decoded in parts.
    uint64_t prefetch_errors; ///< The view that needs the tile gets the same error again.
    double decode_ms;         ///< How long requests waited.
    double prefetch_ms;
    uint64_t resident_bytes; ///< The size of the decoded pixels that are in memory now.
} spherewalk_load_counters;

SPHEREWALK_API spherewalk_status spherewalk_load_counters_init(spherewalk_load_counters* counters,
                                                               size_t size);
SPHEREWALK_API spherewalk_status spherewalk_renderer_get_counters(const spherewalk_renderer* renderer,
                                                                  spherewalk_load_counters* counters);

// ---- Streams

/// The views of one moving camera in turn. A thread of it decodes ahead for the predicted views.
typedef struct spherewalk_stream spherewalk_stream;

/// What a view is made from when its part of the nearest photo is not decoded.
enum {
    SPHEREWALK_LATE_WAIT = 0,    ///< The view waits while that part is decoded.
    SPHEREWALK_LATE_COARSE = 1,  ///< The view is made from the photo's thumbnail.
    SPHEREWALK_LATE_PREVIOUS = 2 ///< The view is made from the photo of the view before.
};

typedef struct spherewalk_stream_options {
    size_t struct_size;
    int32_t late;            ///< Default: SPHEREWALK_LATE_WAIT.
    int32_t reserved;        ///< It must be 0.
    double prefetch_seconds; ///< How far ahead is decoded. Range: 0 (not at all) to 10. Default: 0.2.
    double passage_m; ///< Metres along which a view with depth passes to the next photo. Default: 0.04.
} spherewalk_stream_options;

SPHEREWALK_API spherewalk_status spherewalk_stream_options_init(spherewalk_stream_options* options,
                                                                size_t size);
/// Makes a stream. options: may be NULL.
SPHEREWALK_API spherewalk_status spherewalk_stream_create(const spherewalk_renderer* renderer,
                                                          const spherewalk_camera* camera,
                                                          const spherewalk_stream_options* options,
                                                          spherewalk_stream** stream);
SPHEREWALK_API void spherewalk_stream_destroy(spherewalk_stream* stream);

/// Makes the stream's next view, as spherewalk_renderer_render(). time_s: when the camera is there, on any
/// clock. A time that is not later than the view before is a new start.
SPHEREWALK_API spherewalk_status spherewalk_stream_next(spherewalk_stream* stream,
                                                        const spherewalk_pose* room_from_camera,
                                                        double time_s, const spherewalk_view_options* options,
                                                        const spherewalk_view* view,
                                                        spherewalk_report* report);
/// Returns when all that was predicted is decoded.
SPHEREWALK_API spherewalk_status spherewalk_stream_wait_for_prefetch(spherewalk_stream* stream);

typedef struct spherewalk_stream_counters {
    size_t struct_size;
    uint64_t views;
    uint64_t late;
    uint64_t waited;   ///< Late views that waited.
    uint64_t coarse;   ///< Late views that were made from a thumbnail.
    uint64_t previous; ///< Late views that were made from the photo of the view before.
} spherewalk_stream_counters;

SPHEREWALK_API spherewalk_status spherewalk_stream_counters_init(spherewalk_stream_counters* counters,
                                                                 size_t size);
SPHEREWALK_API spherewalk_status spherewalk_stream_get_counters(spherewalk_stream* stream,
                                                                spherewalk_stream_counters* counters);

// ---- The words that the command line and logs use; "unknown" for a number without a meaning

SPHEREWALK_API const char* spherewalk_scene_name(int32_t scene);
SPHEREWALK_API const char* spherewalk_sampling_name(int32_t sampling);
SPHEREWALK_API const char* spherewalk_origin_name(int32_t origin);
SPHEREWALK_API const char* spherewalk_late_name(int32_t late);

#ifdef __cplusplus
}
#endif
