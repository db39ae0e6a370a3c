// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stddef.h>
#include <stdint.h>

/// What a robot's camera sees from a dataset, for C99 and for whatever calls C.
///
/// Errors: a function that can fail returns a spherewalk_status. If that is not SPHEREWALK_OK,
/// spherewalk_last_error() is a sentence for people, and what was to be filled is as it was; a handle that
/// was to be made is NULL.
///
/// Structs that begin with struct_size: made ready by their _init(), called with their sizeof. Later versions
/// add members at the end, with defaults under which all is as before; so a program works with any later
/// library of the same major version without being compiled again. A size that the library does not know, as
/// of a header newer than it, is SPHEREWALK_INVALID_INPUT.
///
/// Pointers: NULL only where it says so, else it is SPHEREWALK_INVALID_INPUT. Strings: UTF-8, end with NUL.
///
/// Handles: given back with their _destroy() in any order, each once; NULL is ignored. A renderer keeps what
/// it needs of its dataset, a stream what it needs of its renderer and camera.
///
/// Threads: all functions may be called from any thread, with the same handle also; but a stream is used by
/// one thread at a time (a second one is answered SPHEREWALK_BUSY), and while a handle is given back nobody
/// may be using it.
///
/// Units: metres, radians, seconds, pixels; the centre of pixel (0, 0) has the coordinates (0, 0).

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
/// Of this header; that of the library is spherewalk_version_number().
#define SPHEREWALK_VERSION_NUMBER                                                                            \
    (SPHEREWALK_VERSION_MAJOR * 1000000 + SPHEREWALK_VERSION_MINOR * 1000 + SPHEREWALK_VERSION_PATCH)

/// For example "0.1.0".
SPHEREWALK_API const char* spherewalk_version(void);
SPHEREWALK_API int32_t spherewalk_version_number(void);

/// How a call ended. Values keep their meaning for ever; new ones may come.
typedef int32_t spherewalk_status;

enum {
    SPHEREWALK_OK = 0,
    SPHEREWALK_INVALID_INPUT = 1, ///< what the caller gave cannot be used
    SPHEREWALK_NOT_FOUND = 2,     ///< a file that should be there is not
    SPHEREWALK_EXISTS = 3,
    SPHEREWALK_IO = 4, ///< the operating system refused to read
    SPHEREWALK_NETWORK = 5,
    SPHEREWALK_TIMEOUT = 6,
    SPHEREWALK_STOPPED = 7,     ///< the caller asked to stop
    SPHEREWALK_CORRUPT = 8,     ///< a file contradicts itself, its format, or its dataset
    SPHEREWALK_UNSUPPORTED = 9, ///< well-formed, but beyond what this version can do
    SPHEREWALK_BUSY = 10,       ///< in use by another thread
    SPHEREWALK_FULL = 11,       ///< no memory left
    SPHEREWALK_INTERNAL = 12    ///< a defect of the library
};

/// The status as logs spell it, for example "invalid_input"; "unknown" for what is none.
SPHEREWALK_API const char* spherewalk_status_name(spherewalk_status status);

/// What went wrong in the latest call of this thread that failed, and what to do; "" before the first one.
/// Owner: the library, until this thread's next call that fails. Sentences are cut after 4000 bytes.
SPHEREWALK_API const char* spherewalk_last_error(void);

/// Where a body is in the room, and how it is turned: p_in_room = rotation * p_in_body + (x, y, z). The room
/// has z up. The quaternion is of unit length, to within 0.001.
typedef struct spherewalk_pose {
    double x, y, z;
    double qw, qx, qy, qz;
} spherewalk_pose;

/// The pose of the optical frame (z forward, x right, y down), which all other functions take, of a camera
/// whose body (x forward, y left, z up: REP 103) is there. The two may be the same variable.
SPHEREWALK_API spherewalk_status spherewalk_optical_pose(const spherewalk_pose* room_from_body,
                                                         spherewalk_pose* room_from_camera);

// ---- Datasets

typedef struct spherewalk_dataset spherewalk_dataset;

/// How much of a dataset is checked when it is opened.
enum {
    SPHEREWALK_VERIFY_SIZES = 0, ///< that all files are there and have their sizes
    SPHEREWALK_VERIFY_HASHES = 1 ///< and the SHA-256 of every photo
};

/// Is told how far a long call is, in [0, 1], from threads of the library, one call at a time; anything but 0
/// stops it (SPHEREWALK_STOPPED).
typedef int32_t (*spherewalk_progress)(void* user, double fraction);

/// folder: that dataset.json is in. progress: may be NULL; user: what it is given.
SPHEREWALK_API spherewalk_status spherewalk_dataset_open(const char* folder, int32_t verify,
                                                         spherewalk_progress progress, void* user,
                                                         spherewalk_dataset** dataset);
SPHEREWALK_API void spherewalk_dataset_destroy(spherewalk_dataset* dataset);

/// Owner of the strings here and in spherewalk_photo: the dataset's handle.
typedef struct spherewalk_dataset_info {
    size_t struct_size;
    const char* id;
    const char* name;
    uint64_t photo_count;
    uint64_t camera_count;
    double sphere_radius_m; ///< of the sphere scene model; 0 if the dataset has none
    double ceiling_m;       ///< 0 if it is not known
    double step_m;          ///< of the planned grid; 0 if there was none
} spherewalk_dataset_info;

SPHEREWALK_API spherewalk_status spherewalk_dataset_info_init(spherewalk_dataset_info* info, size_t size);
SPHEREWALK_API spherewalk_status spherewalk_dataset_get_info(const spherewalk_dataset* dataset,
                                                             spherewalk_dataset_info* info);

typedef struct spherewalk_photo {
    size_t struct_size;
    const char* file;            ///< relative to the dataset
    const char* station;         ///< what people call its place
    const char* rotation_source; ///< "imported", "aligned", "metadata", or "unknown"
    int32_t width;
    int32_t height;
    spherewalk_pose room_from_photo; ///< of the panorama frame: x forward, y left, z up
    double position_sigma_m[3];      ///< standard deviations along x, y, z; NaN if not known
    double rotation_sigma_rad[3];    ///< of yaw, pitch, roll; NaN if not known
} spherewalk_photo;

SPHEREWALK_API spherewalk_status spherewalk_photo_init(spherewalk_photo* photo, size_t size);
/// index: below photo_count.
SPHEREWALK_API spherewalk_status spherewalk_dataset_get_photo(const spherewalk_dataset* dataset,
                                                              uint64_t index, spherewalk_photo* photo);

// ---- Cameras

/// Lens models, as ROS camera_info has them, and the distortion parameters of each.
enum {
    SPHEREWALK_LENS_PINHOLE = 0,             ///< none
    SPHEREWALK_LENS_PLUMB_BOB = 1,           ///< k1 k2 p1 p2 k3
    SPHEREWALK_LENS_RATIONAL_POLYNOMIAL = 2, ///< k1 k2 p1 p2 k3 k4 k5 k6
    SPHEREWALK_LENS_EQUIDISTANT = 3          ///< k1 k2 k3 k4 of the angle to the axis
};

typedef struct spherewalk_intrinsics {
    size_t struct_size;
    int32_t width; ///< 1 to 32768 pixels, as is height
    int32_t height;
    double fx;
    double fy;
    double cx;
    double cy;
    int32_t lens;
    int32_t distortion_count; ///< as many as the lens model has
    double distortion[8];
} spherewalk_intrinsics;

SPHEREWALK_API spherewalk_status spherewalk_intrinsics_init(spherewalk_intrinsics* intrinsics, size_t size);
/// Of a camera without distortion whose axis meets the picture's centre. intrinsics: ready from its _init().
/// Range: 0 < horizontal_fov_rad < pi.
SPHEREWALK_API spherewalk_status spherewalk_intrinsics_pinhole(int32_t width, int32_t height,
                                                               double horizontal_fov_rad,
                                                               spherewalk_intrinsics* intrinsics);
/// A camera that the dataset suggests. index: below camera_count. name: may be NULL; owner: the dataset's
/// handle.
SPHEREWALK_API spherewalk_status spherewalk_dataset_get_camera(const spherewalk_dataset* dataset,
                                                               uint64_t index, const char** name,
                                                               spherewalk_intrinsics* intrinsics);

typedef struct spherewalk_camera spherewalk_camera;

SPHEREWALK_API spherewalk_status spherewalk_camera_create(const spherewalk_intrinsics* intrinsics,
                                                          spherewalk_camera** camera);
/// From a ROS camera-info YAML.
SPHEREWALK_API spherewalk_status spherewalk_camera_read(const char* file, spherewalk_camera** camera);
/// The same from its text, at most a megabyte. size_bytes: without a NUL at the end, which need not be there.
SPHEREWALK_API spherewalk_status spherewalk_camera_parse(const char* yaml, uint64_t size_bytes,
                                                         spherewalk_camera** camera);
SPHEREWALK_API void spherewalk_camera_destroy(spherewalk_camera* camera);
SPHEREWALK_API spherewalk_status spherewalk_camera_get_intrinsics(const spherewalk_camera* camera,
                                                                  spherewalk_intrinsics* intrinsics);

// ---- Views

typedef struct spherewalk_renderer spherewalk_renderer;

/// When the SHA-256 of a photo is compared with that of the dataset.
enum {
    SPHEREWALK_VERIFY_PHOTOS_BEFORE_USE = 0,   ///< when it is first used; the view waits for it
    SPHEREWALK_VERIFY_PHOTOS_IN_BACKGROUND = 1 ///< some time after, by a stream; reports say is_verified
};

typedef struct spherewalk_renderer_options {
    size_t struct_size;
    uint64_t cache_bytes;  ///< for decoded pixels, 512 MiB; those in use are kept in any case
    int32_t verify_photos; ///< SPHEREWALK_VERIFY_PHOTOS_BEFORE_USE
    int32_t reserved;      ///< 0
} spherewalk_renderer_options;

SPHEREWALK_API spherewalk_status spherewalk_renderer_options_init(spherewalk_renderer_options* options,
                                                                  size_t size);
/// options: may be NULL. A dataset that was opened with SPHEREWALK_VERIFY_HASHES is not verified again.
SPHEREWALK_API spherewalk_status spherewalk_renderer_create(const spherewalk_dataset* dataset,
                                                            const spherewalk_renderer_options* options,
                                                            spherewalk_renderer** renderer);
SPHEREWALK_API void spherewalk_renderer_destroy(spherewalk_renderer* renderer);

/// What an in-between position is computed with.
enum {
    SPHEREWALK_SCENE_BEST = 0,   ///< the best one that the dataset has
    SPHEREWALK_SCENE_NONE = 1,   ///< everything is infinitely far: the nearest photo is only turned
    SPHEREWALK_SCENE_SPHERE = 2, ///< everything lies on a sphere about the photo
    SPHEREWALK_SCENE_ROOM = 3,   ///< there are walls, a floor and a ceiling, and nothing else
    SPHEREWALK_SCENE_DEPTH = 4   ///< how far away each of the photo's pixels is was measured
};

/// How a pixel is made from the photo's, cheap to exact: see the documentation of the C++ interface.
enum {
    SPHEREWALK_SAMPLING_DEFAULT = 0, ///< SPHEREWALK_SAMPLING_FOOTPRINT
    SPHEREWALK_SAMPLING_NEAREST = 1,
    SPHEREWALK_SAMPLING_BILINEAR = 2,
    SPHEREWALK_SAMPLING_REDUCED = 3,
    SPHEREWALK_SAMPLING_FOOTPRINT = 4,
    SPHEREWALK_SAMPLING_BICUBIC = 5,
    SPHEREWALK_SAMPLING_AUTO = 6 ///< the cheapest that is expected to be within tolerance_db
};

/// Pixels of the caller, from the top left one, rows first.
typedef struct spherewalk_source {
    const void* data;
    uint64_t size_bytes;       ///< at least row_stride_bytes * (height - 1) and one row
    uint64_t row_stride_bytes; ///< from one row to the next, at least a row
} spherewalk_source;

/// Memory of the caller that pixels are written to, as in spherewalk_source; what is between rows is left
/// alone.
typedef struct spherewalk_buffer {
    void* data;
    uint64_t size_bytes;
    uint64_t row_stride_bytes;
} spherewalk_buffer;

/// Whether the colours of an overlay are already multiplied by its alpha.
enum { SPHEREWALK_ALPHA_STRAIGHT = 0, SPHEREWALK_ALPHA_PREMULTIPLIED = 1 };

/// Objects as a simulator renders them, to be laid into a view from the view's own pose. Depths are floats: z
/// along the optical axis in metres; what is not finite and above zero is none. Shape: all that of camera.
typedef struct spherewalk_overlay {
    size_t struct_size;
    const spherewalk_intrinsics* camera; ///< what took the picture; NULL: the view's camera
    spherewalk_source rgba;              ///< 4 bytes a pixel
    spherewalk_source depth;             ///< of the objects, a float a pixel
    spherewalk_source room_depth; ///< of the room as the simulator models it, a float a pixel; if its data
                                  ///< are NULL, that of the view's scene model takes its place
    int32_t alpha;                ///< SPHEREWALK_ALPHA_STRAIGHT
    int32_t reserved;             ///< 0
} spherewalk_overlay;

SPHEREWALK_API spherewalk_status spherewalk_overlay_init(spherewalk_overlay* overlay, size_t size);

/// What the border between an object and what hides it is like.
enum {
    SPHEREWALK_EDGES_SOFT = 0, ///< softened over a pixel on either side, as pictures of edges are
    SPHEREWALK_EDGES_HARD = 1  ///< a pixel is shown or hidden as a whole
};

typedef struct spherewalk_view_options {
    size_t struct_size;
    int32_t scene;       ///< SPHEREWALK_SCENE_BEST
    int32_t sampling;    ///< SPHEREWALK_SAMPLING_DEFAULT
    int32_t threads;     ///< 0: all that the machine has; the pixels are the same for any number
    int32_t is_exact;    ///< 0. 1: in double precision, bilinear, a hundred times slower: for comparisons
    double tolerance_db; ///< 40
    const spherewalk_overlay* const* overlays; ///< laid into the picture; NULL if there are none
    uint64_t overlay_count;                    ///< up to 1000
    /// How far an object may lie behind the room's surface and still be shown: the larger of metres (0.005)
    /// and share of the room's depth (0.002).
    double overlay_tolerance_m;
    double overlay_tolerance_share;
    int32_t overlay_edges; ///< SPHEREWALK_EDGES_SOFT
    int32_t photo_colours; ///< 0. 1: the photos' own colours, without the dataset's correction
} spherewalk_view_options;

SPHEREWALK_API spherewalk_status spherewalk_view_options_init(spherewalk_view_options* options, size_t size);

/// What is to be known of a pixel; bits, so that several may hold.
enum {
    SPHEREWALK_PIXEL_UNSEEN = 1,    ///< the lens sees nothing there
    SPHEREWALK_PIXEL_POLE = 2,      ///< near the photo's zenith or nadir, where the camera's own foot is
    SPHEREWALK_PIXEL_STITCHING = 4, ///< near where the pictures of a camera's two lenses were joined
    SPHEREWALK_PIXEL_SEAM = 8,      ///< partly from the photo's left border, partly from its right one
    SPHEREWALK_PIXEL_COARSE = 16,   ///< blurred, since the view was made from a coarser picture
    SPHEREWALK_PIXEL_OVERLAY = 32   ///< at least partly covered by an overlay
};

/// Where a view goes. What has no data is not wanted, and costs nothing; rgb must have. Shape: all that of
/// the camera's picture.
typedef struct spherewalk_view {
    size_t struct_size;
    spherewalk_buffer rgb; ///< 3 bytes a pixel: red, green, blue; black where the lens sees nothing
    /// A float a pixel: how far away the scene model takes it to be, z along the optical axis in metres;
    /// +infinity where it is not known. Without overlays.
    spherewalk_buffer depth;
    /// A float a pixel: by how many pixels what it shows may be off its place; +infinity where the lens sees
    /// nothing. 1 / (1 + error) is its trust.
    spherewalk_buffer error_px;
    spherewalk_buffer flags;    ///< a byte a pixel: SPHEREWALK_PIXEL_...
    spherewalk_buffer overlaid; ///< a byte a pixel: how much of it overlays cover, 255 for all
} spherewalk_view;

SPHEREWALK_API spherewalk_status spherewalk_view_init(spherewalk_view* view, size_t size);

/// What a view's pixels come from.
enum {
    SPHEREWALK_ORIGIN_PHOTO = 0,     ///< the nearest photo
    SPHEREWALK_ORIGIN_THUMBNAIL = 1, ///< its thumbnail, since it was not decoded yet
    SPHEREWALK_ORIGIN_PREVIOUS = 2   ///< the photo of the view before, since it was not decoded yet
};

/// What a view was made from, and how far it can be trusted.
typedef struct spherewalk_report {
    size_t struct_size;
    uint64_t photo;          ///< index
    int32_t scene;           ///< what was used
    int32_t sampling;        ///< what was used
    int32_t origin;          ///< SPHEREWALK_ORIGIN_...
    int32_t is_late;         ///< 1 if something that it needs was not in memory when it was asked for
    int32_t is_verified;     ///< 1 if the photo's hash is that of the dataset
    int32_t is_whole_decode; ///< 1 if the photo has no restart markers, so that all of it was decoded
    double offset_m;         ///< between the camera and the photo
    double parallax_px;      ///< displacement at the picture's centre, of what is half or twice as far as the
                             ///< scene model has it
    double blur_px;          ///< of a thumbnail
    double trust;            ///< 1 / (1 + parallax_px + blur_px)
    double decode_ms;        ///< waiting for the photo to be decoded; 0 if it was in memory
    double render_ms;
    int64_t decoded_tiles; ///< that it waited for
} spherewalk_report;

SPHEREWALK_API spherewalk_status spherewalk_report_init(spherewalk_report* report, size_t size);

/// Waits for what is not decoded yet. options: may be NULL. report: may be NULL.
SPHEREWALK_API spherewalk_status spherewalk_renderer_render(const spherewalk_renderer* renderer,
                                                            const spherewalk_camera* camera,
                                                            const spherewalk_pose* room_from_camera,
                                                            const spherewalk_view_options* options,
                                                            const spherewalk_view* view,
                                                            spherewalk_report* report);

/// What a renderer and its streams have decoded. A request is what one view needs of one photo.
typedef struct spherewalk_load_counters {
    size_t struct_size;
    uint64_t hits;          ///< requests all of whose tiles were in memory
    uint64_t late;          ///< the other ones
    uint64_t waits;         ///< late ones that waited
    uint64_t decoded_tiles; ///< for requests that waited
    uint64_t prefetched_tiles;
    uint64_t dropped_tiles;
    uint64_t whole_decodes;   ///< of photos that cannot be decoded in parts
    uint64_t prefetch_errors; ///< told again to the view that needs the tile
    double decode_ms;         ///< for requests that waited
    double prefetch_ms;
    uint64_t resident_bytes; ///< of decoded pixels, now
} spherewalk_load_counters;

SPHEREWALK_API spherewalk_status spherewalk_load_counters_init(spherewalk_load_counters* counters,
                                                               size_t size);
SPHEREWALK_API spherewalk_status spherewalk_renderer_get_counters(const spherewalk_renderer* renderer,
                                                                  spherewalk_load_counters* counters);

// ---- Streams

/// The views of one moving camera in turn. What it will see next is decoded ahead, in a thread of its own.
typedef struct spherewalk_stream spherewalk_stream;

/// What a view is made from when its part of the nearest photo is not decoded.
enum {
    SPHEREWALK_LATE_WAIT = 0,    ///< that part, decoded now
    SPHEREWALK_LATE_COARSE = 1,  ///< the photo's thumbnail
    SPHEREWALK_LATE_PREVIOUS = 2 ///< the photo of the view before, seen from the new pose
};

typedef struct spherewalk_stream_options {
    size_t struct_size;
    int32_t late;            ///< SPHEREWALK_LATE_WAIT
    int32_t reserved;        ///< 0
    double prefetch_seconds; ///< how far ahead is decoded, 0.2; 0: not at all. Range: up to 10
} spherewalk_stream_options;

SPHEREWALK_API spherewalk_status spherewalk_stream_options_init(spherewalk_stream_options* options,
                                                                size_t size);
/// options: may be NULL.
SPHEREWALK_API spherewalk_status spherewalk_stream_create(const spherewalk_renderer* renderer,
                                                          const spherewalk_camera* camera,
                                                          const spherewalk_stream_options* options,
                                                          spherewalk_stream** stream);
SPHEREWALK_API void spherewalk_stream_destroy(spherewalk_stream* stream);

/// As spherewalk_renderer_render(). time_s: when the camera is there, on any clock; what is not later than
/// the view before is a new start.
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
    uint64_t waited;   ///< late ones that waited
    uint64_t coarse;   ///< made from a thumbnail
    uint64_t previous; ///< made from the photo of the view before
} spherewalk_stream_counters;

SPHEREWALK_API spherewalk_status spherewalk_stream_counters_init(spherewalk_stream_counters* counters,
                                                                 size_t size);
SPHEREWALK_API spherewalk_status spherewalk_stream_get_counters(spherewalk_stream* stream,
                                                                spherewalk_stream_counters* counters);

// ---- Names, as the command line and logs have them; "unknown" for a value that is none

SPHEREWALK_API const char* spherewalk_scene_name(int32_t scene);
SPHEREWALK_API const char* spherewalk_sampling_name(int32_t sampling);
SPHEREWALK_API const char* spherewalk_origin_name(int32_t origin);
SPHEREWALK_API const char* spherewalk_late_name(int32_t late);

#ifdef __cplusplus
}
#endif
