// SPDX-License-Identifier: Apache-2.0
#include "layers/shown_errors.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

namespace spherewalk::render {

using Eigen::Vector3d;

namespace {

/// One worker does so many rows in turn: neighbouring rows share their rays.
constexpr int kTrustRows = 8;

/// Errors are told for blocks of pixels in large views. Returns a block's pixels along an axis, of which
/// kTrustRows is a multiple: a power of two, at most an eightieth of the view's width.
int blockOf(int width) {
    constexpr int kInRow = 80;
    return std::clamp(static_cast<int>(std::bit_floor(static_cast<unsigned>(width / kInRow))), 1, kTrustRows);
}

[[noreturn]] void refuseTrust(const std::string& what) {
    throw Error(ErrorKind::InvalidInput, text("The trust of the view's pixels cannot be told: ", what, "."));
}

unsigned bits(const ShownError& error) {
    return (error.isFilled ? static_cast<unsigned>(PixelFlag::Filled) : 0U) |
           (error.isUnsure ? static_cast<unsigned>(PixelFlag::Unsure) : 0U);
}

class TrustRows {
  public:
    TrustRows(const ViewGeometry& view, const ViewEvidence& evidence, const TrustOptions& options)
        : m_rays(view.rays),
          m_scene(view.roomFromCamera, view.roomFromPhoto, view.scene, view.sphereRadiusM),
          m_options(options),
          m_errors(m_scene, view, evidence),
          m_block(blockOf(view.rays.camera().width())),
          m_photoPixel(2 * std::numbers::pi / view.photo.width),
          m_sinPole(std::sin(std::min(Radians(options.poleRadius).value(), std::numbers::pi / 2))),
          m_sinStitching(
              std::sin(std::min(Radians(options.stitchingHalfWidth).value(), std::numbers::pi / 2))) {}

    /// Computes the rows [begin, end).
    void compute(int begin, int end, PixelTrust& trust) const;

  private:
    struct Seen {
        Vector3d ray;     ///< Frame: optical. It is zero where the lens sees nothing.
        Vector3d inPhoto; ///< A unit vector of the photo's frame.
    };

    using Row = std::vector<Seen>;

    Row seen(int y) const;
    double footprint(const Row& row, const Row& other, std::size_t x) const;
    double blurPx(double footprint) const;
    std::uint8_t flags(const Vector3d& inPhoto, double footprint, bool isBlurred) const;
    std::vector<ShownError> errorsOfBlocks(int y, const Row& row) const;
    void computeRow(int y, const Row& row, const Row& other, std::span<const ShownError> errors,
                    PixelTrust& trust) const;

    const PixelRays& m_rays;
    SceneRays m_scene;
    const TrustOptions& m_options;
    ShownErrors m_errors;
    int m_block;
    double m_photoPixel; ///< Radians that a pixel of the photo spans at the equator.
    double m_sinPole;
    double m_sinStitching;
};

TrustRows::Row TrustRows::seen(int y) const {
    Row row(static_cast<std::size_t>(m_rays.camera().width()));
    for (int x = 0; x < m_rays.camera().width(); ++x) {
        const Vector3d ray = m_rays.ray(x, y);
        row[static_cast<std::size_t>(x)] = {ray, m_scene.directionInPhoto(ray)};
    }
    return row;
}

/// The angle in the photo between the pixel and its neighbours, along the axis of the view that has more.
double TrustRows::footprint(const Row& row, const Row& other, std::size_t x) const {
    double most = 0;
    const auto measure = [&](const Seen& neighbour) {
        if (!neighbour.ray.isZero(0)) {
            most = std::max(most, (neighbour.inPhoto - row[x].inPhoto).squaredNorm());
        }
    };
    if (row.size() > 1) {
        measure(x + 1 < row.size() ? row[x + 1] : row[x - 1]);
    }
    if (!other.empty()) {
        measure(other[x]);
    }
    const CameraIntrinsics& k = m_rays.camera().intrinsics();
    return most > 0 ? std::sqrt(most) : 1 / std::min(k.fx, k.fy);
}

double TrustRows::blurPx(double footprint) const {
    const double full = m_photoPixel / footprint; // view pixels that one pixel of the photo spans
    return 0.5 * std::max(0.0, m_options.coarseness * full - std::max(1.0, full));
}

std::uint8_t TrustRows::flags(const Vector3d& inPhoto, double footprint, bool isBlurred) const {
    const double level = inPhoto.head<2>().norm();
    const double seamReach = 0.5 * (footprint + level * m_photoPixel); // of bilinear samples in the pixel
    unsigned result = 0;
    const auto set = [&](bool holds, PixelFlag flag) { result |= holds ? static_cast<unsigned>(flag) : 0U; };
    set(level < m_sinPole, PixelFlag::Pole);
    set(std::abs(inPhoto.x()) < m_sinStitching, PixelFlag::Stitching);
    set(inPhoto.x() <= 0 && std::abs(inPhoto.y()) <= seamReach, PixelFlag::Seam);
    set(isBlurred, PixelFlag::Coarse);
    return static_cast<std::uint8_t>(result);
}

/// The errors of a row of blocks: each that of the pixel in its middle, or of another one that is seen.
std::vector<ShownError> TrustRows::errorsOfBlocks(int y, const Row& row) const {
    const int width = m_rays.camera().width();
    std::vector<ShownError> errors;
    for (int left = 0; left < width; left += m_block) {
        const int end = std::min(width, left + m_block);
        int x = (left + end) / 2;
        for (int other = left; other < end && row[static_cast<std::size_t>(x)].ray.isZero(0); ++other) {
            x = other;
        }
        const Vector3d& ray = row[static_cast<std::size_t>(x)].ray;
        errors.push_back(ray.isZero(0) ? ShownError() : m_errors.at(x, y, ray));
    }
    return errors;
}

void TrustRows::computeRow(int y, const Row& row, const Row& other, std::span<const ShownError> errors,
                           PixelTrust& trust) const {
    for (int x = 0; x < m_rays.camera().width(); ++x) {
        const auto& [ray, inPhoto] = row[static_cast<std::size_t>(x)];
        if (ray.isZero(0)) {
            *trust.errorPx.at(x, y) = std::numeric_limits<float>::infinity();
            *trust.flags.at(x, y) = static_cast<std::uint8_t>(PixelFlag::Unseen);
        } else {
            const double angle = footprint(row, other, static_cast<std::size_t>(x));
            const double blur = blurPx(angle);
            const ShownError& error = errors[static_cast<std::size_t>(x / m_block)];
            *trust.errorPx.at(x, y) = static_cast<float>(error.px + blur);
            *trust.flags.at(x, y) = static_cast<std::uint8_t>(flags(inPhoto, angle, blur > 0) | bits(error));
        }
        if (m_options.overlays != nullptr && *m_options.overlays->at(x, y) != 0) {
            *trust.flags.at(x, y) |= static_cast<std::uint8_t>(PixelFlag::Overlay);
        }
    }
}

void TrustRows::compute(int begin, int end, PixelTrust& trust) const {
    const int height = m_rays.camera().height();
    Row row = seen(begin);
    std::vector<ShownError> errors;
    for (int y = begin; y < end; ++y) {
        if (y % m_block == 0) {
            const int middle = std::min(y + m_block / 2, height - 1);
            errors = errorsOfBlocks(middle, middle == y ? row : seen(middle));
        }
        Row other = y + 1 < height ? seen(y + 1) : y > 0 ? seen(y - 1) : Row();
        computeRow(y, row, other, errors, trust);
        row.swap(other);
    }
}

} // namespace

void TrustOptions::validate() const {
    for (const double value : {poleRadius.value(), stitchingHalfWidth.value()}) {
        if (!(value >= 0) || !std::isfinite(value)) {
            refuseTrust(text("the widths of pole and stitching zone must be 0 or more, not ", value));
        }
    }
    if (!(coarseness >= 1) || !std::isfinite(coarseness)) {
        refuseTrust(text("the coarseness must be 1 or more, not ", coarseness));
    }
}

PixelTrust pixelTrust(const ViewGeometry& view, const ViewEvidence& evidence, const TrustOptions& options,
                      WorkerPool& pool, int threads) {
    view.validate();
    options.validate();
    const CameraModel& camera = view.rays.camera();
    if (options.overlays != nullptr &&
        (options.overlays->width() != camera.width() || options.overlays->height() != camera.height())) {
        refuseTrust(text("the overlays' mask has ", options.overlays->width(), " x ",
                         options.overlays->height(), " pixels, the view ", camera.width(), " x ",
                         camera.height()));
    }
    PixelTrust result{Image<float, 1>(camera.width(), camera.height()),
                      MaskImage(camera.width(), camera.height())};
    const TrustRows rows(view, evidence, options);
    pool.run((camera.height() + kTrustRows - 1) / kTrustRows, threads, [&](int band, int) {
        rows.compute(kTrustRows * band, std::min(kTrustRows * (band + 1), camera.height()), result);
    });
    return result;
}

} // namespace spherewalk::render
