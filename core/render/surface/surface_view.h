// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "pixels/photo_plane.h"
#include "surface/coordinates.h"
#include "surface/mesh.h"
#include "surface/pieces.h"
#include "tiles/tile_grid.h"

#include "spherewalk/base/recently_used.h"
#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/render/dataset.h"
#include "spherewalk/render/ladder.h"

#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace spherewalk::render {

/// A photo with its surface.
struct SurfacePhoto {
    std::size_t photo = 0; ///< The photo's index in the dataset.
    std::shared_ptr<const SurfaceMesh> mesh;
    Rigid3 roomFromPhoto;
    TileGrid grid; ///< The grid of the level that is sampled.
};

/// The surfaces of a dataset's photos, for the scene models that have some. The last ones used are kept.
/// Threads: any number at a time; while one makes a surface, the others wait.
class Surfaces {
  public:
    /// A view takes so many photos at most.
    static constexpr std::size_t kPhotosOfView = 3;
    /// A view takes so many photos at most where photos are mixed.
    static constexpr std::size_t kPhotosOfBlend = 4;

    explicit Surfaces(std::shared_ptr<const Dataset> dataset);

    /// Whether a photo has a surface of this kind.
    bool has(SceneKind kind, std::size_t photo) const;

    /// The surface of a photo. Range: has() is true. Errors: those of readFile(); Corrupt for a damaged file
    /// and for one whose width is no multiple of 16; InvalidInput for a room that cannot be.
    std::shared_ptr<const SurfaceMesh> get(SceneKind kind, std::size_t photo);

  private:
    static constexpr std::size_t kKept = 24; ///< Each surface has about 5 MB.

    SurfaceMesh made(SceneKind kind, std::size_t photo) const;

    std::shared_ptr<const Dataset> m_dataset;
    RecentlyUsed<std::pair<SceneKind, std::size_t>, SurfaceMesh> m_meshes{kKept};
};

/// The camera from the photo. Positions are subtracted first, since a room may lie at 10^6 m.
Rigid3 between(const Rigid3& roomFromCamera, const Rigid3& roomFromPhoto);

/// What a view is known to see.
struct KnownDistances {
    const InverseBuffer& inverse; ///< 0 is a hole.
    const OpenCells& open;        ///< The cells with holes.
    const MaskImage& share;       ///< Cells that are all 0 are not sampled. Shape: that of `inverse`.
};

/// Draws surfaces as a camera sees them. It keeps its memory. The values are the same for any number of
/// threads.
class SurfaceRaster {
  public:
    /// Draws the surface of a photo. Quads with a corner nearer than 5 mm are not drawn. Cells that are not
    /// open may be left out, and may get any values. Frames: the camera's is the optical one. tolerancePx: by
    /// how much a part that is drawn flat may be displaced. out: it gets the view's size in whole cells.
    void draw(const SurfaceMesh& mesh, const Rigid3& cameraFromPhoto, const CameraModel& camera,
              const OpenCells& open, double tolerancePx, WorkerPool& pool, int threads, InverseBuffer& out);

  private:
    class BlockCutter;

    static void clear(int row, const OpenCells& open, InverseBuffer& out);

    /// The pieces of each row of blocks, for each row of cells.
    std::vector<std::vector<simd::Piece>> m_pieces;
};

/// A view from the surfaces of several photos. Things hide each other. What the first photo does not see
/// comes from the next one that sees it. prepare() tells which tiles are needed; sample() then makes the
/// picture. It keeps its memory from frame to frame. The bytes are the same for any number of threads.
/// Threads: one at a time.
class SurfaceView {
  public:
    /// By how many pixels of the view a part that is drawn flat may be displaced.
    static constexpr double kTolerancePx = 0.5;
    /// The same for what the first photo does not see.
    static constexpr double kFurtherTolerancePx = 2;
    /// If a smaller share of the view is open, it is not looked for in a third photo, but filled from beside.
    static constexpr double kLeastOpenShare = 0.01;

    /// Draws the surfaces and finds each pixel's photo coordinates. Returns the tiles of each photo that
    /// sample() reads. Frames: the camera's is the optical one. photos: 1 to 8, in the order in which they
    /// are asked. usualDistanceM: the distance in a row of pixels of which no photo sees any. samplesPerAxis:
    /// that of the sampling that sample() gets.
    std::vector<TileSet> prepare(const PixelRays& rays, const Rigid3& roomFromCamera,
                                 std::span<const SurfacePhoto> photos, double usualDistanceM,
                                 int samplesPerAxis, WorkerPool& pool, int threads);

    /// As prepare(), for one photo and distances that are known. Where cells are not sampled, sample() leaves
    /// the picture as it is.
    TileSet prepareKnown(const PixelRays& rays, const Rigid3& roomFromCamera, const SurfacePhoto& photo,
                         const KnownDistances& known, double usualDistanceM, int samplesPerAxis,
                         WorkerPool& pool, int threads);

    /// Looks up what a row of the view's pixels has in a mask of the first photo: the nearest pixel's value,
    /// and 0 in cells that do not show the photo. ofPhoto: 2:1, of any size. photo: the size of the level
    /// that is sampled. values: it has the view's width.
    void look(const MaskImage& ofPhoto, const EquirectSize& photo, int row,
              std::span<std::uint8_t> values) const;

    /// Makes the picture. rays: those of prepare(). planes: those of the photos of prepare(), in its order.
    /// sampling: not Auto. picture: it gets the view's size.
    void sample(const PixelRays& rays, std::span<const PlaneView> planes, Sampling sampling, WorkerPool& pool,
                int threads, RgbImage& picture) const;

    /// The depth of the prepared view in metres: z along the optical axis. Holes have the depth that they
    /// were filled with. It is +infinity where the lens sees nothing or 90 degrees or more off the axis.
    /// rays: those of prepare().
    DepthImage depth(const PixelRays& rays) const;

    /// 1 / s of a pixel of the prepared view, as InverseBuffer defines it. Holes have what they were filled
    /// with.
    double inverse(int x, int y) const { return *m_coordinates.inverse.at(x, y); }

    /// The share of the view's pixels that the first photo's surface does not cover. Pixels that the lens
    /// does not see count, too.
    double filledShare() const { return m_filledShare; }

  private:
    /// A cell of 16 x 16 pixels, cut at the view's edges.
    struct Cell {
        int column = 0, row = 0;
        int width = 0, height = 0;
    };

    struct SampleSpace;

    /// Rows of sixteen pixels of a cell.
    struct PixelRows {
        const std::int32_t* u;
        const std::int32_t* v;
        int count;
    };

    Cell cell(int column, int row) const;
    void needOfCell(const Cell& at, std::size_t source, TileSet& tiles) const;
    void fillFirst(const Cell& at, const PlaneView& plane, Sampling sampling, SampleSpace& space) const;
    void sampleOthers(const Cell& at, std::span<const PlaneView> planes, Sampling sampling,
                      SampleSpace& space, RgbImage& picture) const;
    void fillPlaces(std::size_t cell, std::size_t source, const PlaneView& plane, Sampling sampling,
                    const PixelRows& rows, SampleSpace& space) const;
    void samplePart(const Cell& at, std::size_t source, const PlaneView& plane, Sampling sampling,
                    SampleSpace& space, RgbImage& picture) const;
    void begin(const PixelRays& rays, int samplesPerAxis);
    void mark(const MaskImage& share);
    bool shows(int column, int row) const;
    std::vector<TileSet> locate(const PixelRays& rays, const Rigid3& roomFromCamera,
                                std::span<const SurfacePhoto> photos, std::span<const SourcePhoto> drawn,
                                double usualDistanceM, WorkerPool& pool, int threads);
    std::vector<SourcePhoto> drawPhotos(const PixelRays& rays, const Rigid3& roomFromCamera,
                                        std::span<const SurfacePhoto> photos, WorkerPool& pool, int threads);

    int m_width = 0;
    int m_height = 0;
    int m_samples = 1;
    OpenCells m_open{0, 0};
    InverseBuffer m_seen; ///< What a further photo's surface looks like.
    SurfaceRaster m_raster;
    SurfaceCoordinates m_coordinates;
    std::size_t m_photos = 0; ///< The number of photos that were drawn.
    double m_filledShare = 0;
};

/// What one photo says about a view's distances, and what part it gets in the view.
struct DepthWitness {
    double offsetM = 0;                  ///< The distance from the photo to the camera.
    const InverseBuffer* seen = nullptr; ///< What the camera sees of the photo's surface.
    MaskImage* share = nullptr; ///< Output: the photo's share of each pixel; the view in whole cells.
};

/// Finds one distance for each pixel, and which photos show it. The first photo with a surface there decides.
/// Photos whose 1 / s differ by less than 6 % are mixed, less the more they differ. Each counts by 1 / its
/// squared distance from the camera, so at a photo that photo alone decides. witnesses: 1 to 8, the nearest
/// first, of views of the same size. width, height: the view's size. inverse: it gets the view's 1 / s, 0
/// where no photo sees anything. The shares of a pixel add up to 255; a pixel that no photo sees is the first
/// photo's. The values are the same for any number of threads.
void fuseDepths(std::span<const DepthWitness> witnesses, int width, int height, WorkerPool& pool, int threads,
                InverseBuffer& inverse);

/// Fills what no photo shows with the colours around it, softly. Each pixel gets a mean of the nearest known
/// pixels in eight directions. Near ones count more, and so do far surfaces, since what is hidden lies
/// behind. known: 0 where a pixel is to be filled. inverse: 1 / s of the pixels around. The bytes are the
/// same for any number of threads.
void fillSoftly(const MaskImage& known, const InverseBuffer& inverse, WorkerPool& pool, int threads,
                RgbImage& picture);

/// A view from the surfaces of several photos, in which photos that agree about a pixel's distance are mixed.
/// Each counts by 1 / its squared distance from the camera, so the view at a photo is that photo. It is used
/// as a SurfaceView is. The bytes are the same for any number of threads. Threads: one at a time.
class BlendedView {
  public:
    /// As SurfaceView::prepare().
    std::vector<TileSet> prepare(const PixelRays& rays, const Rigid3& roomFromCamera,
                                 std::span<const SurfacePhoto> photos, double usualDistanceM,
                                 int samplesPerAxis, WorkerPool& pool, int threads);

    /// As SurfaceView::sample().
    void sample(const PixelRays& rays, std::span<const PlaneView> planes, Sampling sampling, WorkerPool& pool,
                int threads, RgbImage& picture);

    /// As SurfaceView::depth().
    DepthImage depth(const PixelRays& rays) const { return m_layers.front().view.depth(rays); }

    /// As SurfaceView::inverse().
    double inverse(int x, int y) const { return m_layers.front().view.inverse(x, y); }

    /// As SurfaceView::filledShare().
    double filledShare() const { return m_filledShare; }

  private:
    /// What one photo gives to the view.
    struct Layer {
        std::shared_ptr<const SurfaceMesh> mesh;
        EquirectSize photo; ///< The size of the level that is sampled.
        InverseBuffer seen;
        MaskImage share;
        SurfaceView view;
        RgbImage picture;
    };

    void mixRow(int y, RgbImage& picture);

    std::vector<Layer> m_layers;
    std::size_t m_photos = 0;
    SurfaceRaster m_raster;
    InverseBuffer m_inverse;
    MaskImage m_known; ///< 0 where no photo shows more than the rim of a thing.
    double m_filledShare = 0;
};

} // namespace spherewalk::render
