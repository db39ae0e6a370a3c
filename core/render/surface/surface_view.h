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

#include <array>
#include <cstdint>
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
    /// The gains with which its red, green and blue are as bright as the view's first photo.
    Eigen::Vector3d gain = Eigen::Vector3d::Ones();
    LensPair lenses = {};
    double highlightRolloff = 0; ///< See exposedValue().
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
    static constexpr std::size_t kKept = 24; ///< Each surface has 1 MB, and 6 MB once all of it was seen.

    SurfaceMesh made(SceneKind kind, std::size_t photo) const;

    std::shared_ptr<const Dataset> m_dataset;
    RecentlyUsed<std::pair<SceneKind, std::size_t>, SurfaceMesh> m_meshes{kKept};
};

/// The camera from the photo. Positions are subtracted first, since a room may lie at 10^6 m.
Rigid3 between(const Rigid3& roomFromCamera, const Rigid3& roomFromPhoto);

/// Draws surfaces as a camera sees them. It keeps its memory. The values are the same for any number of
/// threads.
class SurfaceRaster {
  public:
    /// Draws the surface of a photo. Quads with a corner nearer than 5 mm are not drawn. Cells that are not
    /// open may be left out, and may get any values. Frames: the camera's is the optical one. tolerancePx: by
    /// how much a part that is drawn flat may be displaced. out: it gets the view's size in whole cells.
    void draw(const SurfaceMesh& mesh, const Rigid3& cameraFromPhoto, const LensPair& lenses,
              const CameraModel& camera, const OpenCells& open, double tolerancePx, WorkerPool& pool,
              int threads, InverseBuffer& out);

  private:
    class BlockCutter;

    /// The pieces of each row of blocks, for each row of cells.
    std::vector<std::vector<simd::Piece>> m_pieces;
};

/// A view from the surfaces of several photos. Things hide each other. What the first photo does not see
/// comes from the next one that sees it. prepare() tells which tiles are needed; sample() then makes the
/// picture. It keeps its memory from frame to frame. The bytes are the same for any number of threads.
/// Threads: one at a time.
///
/// A view that mixes takes the mean of the first two photos where their 1 / s differ by less than 10 %. They
/// are mixed less the more they differ. Each photo counts by 1 / its distance from the camera, so the
/// view at a photo is that photo. The second photo's colours stay near the first one's, see keepWithin(). The
/// rims of things count little, see colourWeights(). What further photos show in narrow holes must lie
/// between their sides, see reopenNarrow(). Holes are filled softly, see fillSoftly().
class SurfaceView {
  public:
    explicit SurfaceView(bool mixes = false) : m_mixes(mixes) {}

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

    /// Makes the picture. rays: those of prepare(). planes: those of the photos of prepare(), in its order.
    /// sampling: not Auto. picture: it gets the view's size.
    void sample(const PixelRays& rays, std::span<const PlaneView> planes, Sampling sampling, WorkerPool& pool,
                int threads, RgbImage& picture);

    /// The depth of the prepared view in metres: z along the optical axis. Holes have the depth that they
    /// were filled with. It is +infinity where the lens sees nothing or 90 degrees or more off the axis.
    /// rays: those of prepare(). memory: the result of a view before, whose memory is used again.
    DepthImage depth(const PixelRays& rays, WorkerPool& pool, int threads, DepthImage memory = {}) const;

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

    /// The samples of a cell.
    struct SampleSpace {
        explicit SampleSpace(int samplesPerAxis)
            : places(SurfaceCoordinates::kCellPixels *
                     static_cast<std::size_t>(samplesPerAxis * samplesPerAxis)),
              fractions(places.size()) {}

        std::vector<std::int32_t> places;
        std::vector<std::int32_t> fractions;
        int step = 1; ///< CellSamples::nextStep

        // The pixels that come from another photo than the first:
        std::array<std::int32_t, SurfaceCoordinates::kCellPixels> u;
        std::array<std::int32_t, SurfaceCoordinates::kCellPixels> v;
        std::array<std::uint8_t, SurfaceCoordinates::kCellPixels> pixels; ///< Their numbers in the cell.
        std::array<std::uint8_t, 3 * SurfaceCoordinates::kCellPixels + 16> colours;
    };

    /// Rows of sixteen pixels of a cell.
    struct PixelRows {
        const std::int32_t* u;
        const std::int32_t* v;
        int count;
    };

    using CellBytes = std::array<std::uint8_t, SurfaceCoordinates::kCellPixels>;

    /// A photo's surface, the size of the level that is sampled, and how bright it becomes.
    struct Drawn {
        std::shared_ptr<const SurfaceMesh> mesh;
        EquirectSize size;
        /// The level that each level of red, of green and of blue becomes; empty if all stay.
        std::vector<std::uint8_t> levels;

        explicit Drawn(const SurfacePhoto& photo);
        void brighten(std::uint8_t* colours, std::size_t pixels) const;
    };

    Cell cell(int column, int row) const;
    bool needOfCell(const Cell& at, std::size_t source, TileSet& tiles) const;
    bool needOfMixed(const Cell& at, TileSet& tiles) const;
    void needOfRow(int row, std::vector<TileSet>& tiles);
    void fillFirst(const Cell& at, const PlaneView& plane, Sampling sampling, SampleSpace& space) const;
    void sampleOthers(const Cell& at, std::span<const PlaneView> planes, Sampling sampling,
                      SampleSpace& space, RgbImage& picture) const;
    void fillPlaces(std::size_t cell, std::size_t source, const PlaneView& plane, Sampling sampling,
                    const PixelRows& rows, SampleSpace& space) const;
    void samplePart(const Cell& at, std::size_t source, const PlaneView& plane, Sampling sampling,
                    SampleSpace& space, RgbImage& picture) const;
    void sampleMixed(const Cell& at, const PlaneView& plane, Sampling sampling, SampleSpace& space) const;
    void mix(const Cell& at, std::span<const PlaneView> planes, Sampling sampling, SampleSpace& space,
             RgbImage& picture);
    void weighRims(const Cell& at, CellBytes& shares);
    static void look(const Drawn& drawn, const std::int32_t* u, const std::int32_t* v, CellBytes& weights);
    void markHoles(WorkerPool& pool, int threads);
    void begin(const PixelRays& rays, int samplesPerAxis);
    std::vector<TileSet> locate(const PixelRays& rays, const Rigid3& roomFromCamera,
                                std::span<const SurfacePhoto> photos, std::span<const SourcePhoto> drawn,
                                double usualDistanceM, WorkerPool& pool, int threads);
    std::vector<SourcePhoto> drawPhotos(const PixelRays& rays, const Rigid3& roomFromCamera,
                                        std::span<const SurfacePhoto> photos, WorkerPool& pool, int threads);

    bool m_mixes;
    int m_width = 0;
    int m_height = 0;
    int m_samples = 1;
    OpenCells m_open{0, 0};
    InverseBuffer m_seen; ///< What a further photo's surface looks like.
    SurfaceRaster m_raster;
    SurfaceCoordinates m_coordinates;
    std::vector<Drawn> m_drawn;
    MaskImage m_known; ///< What a pixel of a mixed view is: a Known. Shape: whole cells.
    double m_filledShare = 0;
};

/// What is known of a pixel.
enum class Known : std::uint8_t {
    Nothing, ///< A hole.
    Seen,
    Outside, ///< The lens sees nothing there.
};

/// Fills what no photo shows with the colours around it, softly. Each pixel gets a mean of the nearest known
/// pixels in eight directions. Near ones count more, and so do far surfaces, since what is hidden lies
/// behind. known: a Known a pixel; what is Nothing is filled from what is Seen. inverse: 1 / s of the pixels
/// around. Both may be larger than the picture. The bytes are the same for any number of threads.
void fillSoftly(const MaskImage& known, const InverseBuffer& inverse, WorkerPool& pool, int threads,
                RgbImage& picture);

} // namespace spherewalk::render

/// Operations on the colours of mixed cells. They give the same bytes on every processor.
namespace spherewalk::render::simd {

/// Brings the second photo's colours of a cell within what the view's colours are up to two pixels away in
/// the cell, and eight levels beyond. What is displaced in the second photo then does not double what the
/// first one shows. colours, others: 16 rows of 16 pixels. Source: the clamping of a pixel's history in Karis
/// 2014, "High-quality temporal supersampling".
void keepWithin(const std::uint8_t* colours, std::uint8_t* others);

/// Mixes the colours of a row of sixteen pixels. other: colours of the second photo. shares: its share of
/// each pixel in 255 parts.
void mixColours(const std::uint8_t* other, const std::uint8_t* shares, std::uint8_t* colours);

} // namespace spherewalk::render::simd
