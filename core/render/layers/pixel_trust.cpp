// SPDX-License-Identifier: Apache-2.0
#include "layers/shown_errors.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace spherewalk::render {

using Eigen::Vector3d;

namespace {

/// One worker does so many rows in turn. They are a row of the squares of PixelRays.
constexpr int kTrustRows = PixelRays::kSquare;

/// Errors are told for blocks of pixels in large views. Returns a block's pixels along an axis, of which
/// kTrustRows is a multiple: a power of two, at most an eightieth of the view's width.
int blockOf(int width) {
    constexpr int kInRow = 80;
    return std::clamp(static_cast<int>(std::bit_floor(static_cast<unsigned>(width / kInRow))), 1, kTrustRows);
}

[[noreturn]] void refuseTrust(const std::string& what) {
    throw Error(ErrorKind::InvalidInput, text("The trust of the view's pixels cannot be told: ", what, "."));
}

std::uint8_t bits(const ShownError& error) {
    return static_cast<std::uint8_t>((error.isFilled ? static_cast<unsigned>(PixelFlag::Filled) : 0U) |
                                     (error.isUnsure ? static_cast<unsigned>(PixelFlag::Unsure) : 0U));
}

/// A pixel's ray, and where the photo sees what the pixel shows.
struct Seen {
    Vector3d ray;     ///< Frame: optical. It is zero where the lens sees nothing.
    Vector3d inPhoto; ///< A unit vector of the photo's frame.
};

/// What follows from where the photo sees things: flags and blur. Threads: const functions may run on any
/// number at a time.
class PlacesInPhoto {
  public:
    PlacesInPhoto(const ViewGeometry& view, const TrustOptions& options)
        : m_rays(view.rays),
          m_scene(view.roomFromCamera, view.roomFromPhoto, view.scene, view.sphereRadiusM),
          m_coarseness(options.coarseness),
          m_photoPixel(2 * std::numbers::pi / view.photo.width),
          m_sinPole(std::sin(std::min(Radians(options.poleRadius).value(), std::numbers::pi / 2))),
          m_sinStitching(
              std::sin(std::min(Radians(options.stitchingHalfWidth).value(), std::numbers::pi / 2))) {}

    const SceneRays& scene() const { return m_scene; }

    /// Only a picture that is coarser than the photo is blurred.
    bool mayBlur() const { return m_coarseness > 1; }

    Seen seen(int x, int y) const {
        const Vector3d ray = m_rays.ray(x, y);
        return {ray, m_scene.directionInPhoto(ray)};
    }

    /// How far the places of a square's pixels are from that of its middle at most, as a chord. It is
    /// +infinity where nothing is known of that.
    double reach(int column, int row) const {
        const double ofRays = m_rays.reach(column, row);
        constexpr double kArc = 1.05; // of a chord of up to 1
        constexpr double kRounding = 1e-9;
        return ofRays < 1 ? m_scene.mostTurn() * kArc * ofRays + kRounding
                          : std::numeric_limits<double>::infinity();
    }

    /// The flags of all pixels whose places are within a chord of that of pixel (x, y). Nothing if the flags
    /// may differ, or if blur must be computed. mostFootprint: no pixel's footprint exceeds it.
    std::optional<std::uint8_t> flagsWithin(double reach, int x, int y, double mostFootprint) const;

    /// Whether reach() of half a square is half of that.
    bool halves() const { return m_rays.camera().intrinsics().lens == LensModel::Pinhole; }

    /// The angle in the photo between a pixel and its neighbours, along the axis of the view that has more.
    /// seenAt: what a pixel shows.
    template <class SeenAt>
    double footprint(const Seen& own, int x, int y, const SeenAt& seenAt) const;

    /// View pixels by which the picture is blurred about a pixel.
    double blurPx(double footprint) const {
        const double full = m_photoPixel / footprint; // view pixels that one pixel of the photo spans
        return 0.5 * std::max(0.0, m_coarseness * full - std::max(1.0, full));
    }

    /// The flags of a pixel that do not depend on its neighbours.
    unsigned flagsOfPlace(const Vector3d& inPhoto) const {
        return (inPhoto.head<2>().norm() < m_sinPole ? static_cast<unsigned>(PixelFlag::Pole) : 0U) |
               (std::abs(inPhoto.x()) < m_sinStitching ? static_cast<unsigned>(PixelFlag::Stitching) : 0U);
    }

    /// Whether bilinear samples of a pixel with such a footprint lie on both sides of the photo's seam.
    bool isAtSeam(const Vector3d& inPhoto, double footprint) const {
        return inPhoto.x() <= 0 &&
               std::abs(inPhoto.y()) <= 0.5 * (footprint + inPhoto.head<2>().norm() * m_photoPixel);
    }

    /// A footprint that no pixel exceeds whose neighbours lie within a chord of it.
    double mostFootprint(double chord) const { return std::max(chord, footprintAlone()); }

  private:
    /// The footprint of a pixel without neighbours.
    double footprintAlone() const {
        const CameraIntrinsics& k = m_rays.camera().intrinsics();
        return 1 / std::min(k.fx, k.fy);
    }

    const PixelRays& m_rays;
    SceneRays m_scene;
    double m_coarseness;
    double m_photoPixel; ///< Radians that a pixel of the photo spans at the equator.
    double m_sinPole;
    double m_sinStitching;
};

std::optional<std::uint8_t> PlacesInPhoto::flagsWithin(double reach, int x, int y,
                                                       double mostFootprint) const {
    if (mayBlur() || !std::isfinite(reach)) {
        return std::nullopt;
    }
    const Vector3d at = seen(x, y).inPhoto;
    const double level = at.head<2>().norm();
    const double seam = 0.5 * (mostFootprint + (level + reach) * m_photoPixel);
    const bool maySeam = at.x() <= reach && std::abs(at.y()) <= seam + reach;
    if (std::abs(level - m_sinPole) <= reach || std::abs(std::abs(at.x()) - m_sinStitching) <= reach ||
        maySeam) {
        return std::nullopt;
    }
    return static_cast<std::uint8_t>(flagsOfPlace(at));
}

template <class SeenAt>
double PlacesInPhoto::footprint(const Seen& own, int x, int y, const SeenAt& seenAt) const {
    double most = 0;
    const auto measure = [&](const Seen& neighbour) {
        if (!neighbour.ray.isZero(0)) {
            most = std::max(most, (neighbour.inPhoto - own.inPhoto).squaredNorm());
        }
    };
    const int width = m_rays.camera().width();
    const int height = m_rays.camera().height();
    if (width > 1) {
        measure(seenAt(x + 1 < width ? x + 1 : x - 1, y));
    }
    if (height > 1) {
        measure(seenAt(x, y + 1 < height ? y + 1 : y - 1));
    }
    return most > 0 ? std::sqrt(most) : footprintAlone();
}

/// Rows of pixels with what they show. Blur needs each pixel and its neighbours.
class SeenRows {
  public:
    /// The rows [begin, end), and one beside the last.
    SeenRows(const PlacesInPhoto& places, const CameraModel& camera, int begin, int end)
        : m_first(std::max(0, std::min(begin, camera.height() - 2))), m_width(camera.width()) {
        for (int y = m_first; y < std::min(end + 1, camera.height()); ++y) {
            for (int x = 0; x < m_width; ++x) {
                m_seen.push_back(places.seen(x, y));
            }
        }
    }

    const Seen& operator()(int x, int y) const {
        return m_seen[static_cast<std::size_t>(y - m_first) * static_cast<std::size_t>(m_width) +
                      static_cast<std::size_t>(x)];
    }

  private:
    int m_first;
    int m_width;
    std::vector<Seen> m_seen;
};

/// Tells the trust of a view, one band of rows after the other. Threads: const functions may run on any
/// number at a time.
class TrustBands {
  public:
    TrustBands(const ViewGeometry& view, const ViewEvidence& evidence, const TrustOptions& options,
               PixelTrust& trust)
        : m_rays(view.rays),
          m_places(view, options),
          m_errors(m_places.scene(), view, evidence),
          m_overlays(options.overlays),
          m_trust(trust),
          m_width(view.rays.camera().width()),
          m_height(view.rays.camera().height()),
          m_block(blockOf(m_width)) {}

    void compute(int band) const;

  private:
    /// The errors of one row of blocks after the other.
    using Errors = std::vector<ShownError>;

    int blocks() const { return (m_width + m_block - 1) / m_block; }

    void addErrorsOfRow(int top, Errors& errors) const;
    void fillRow(int top, int end, std::span<const ShownError> errors) const;

    /// Pixels of a band, the last ones not included.
    struct Part {
        int left, top, right, bottom;
    };

    Part part(int left, int top, int size) const {
        return {left, top, std::min(left + size, m_width), std::min(top + size, m_height)};
    }

    void setSquare(int column, int band, const Errors& errors) const;
    bool setTogether(const Part& part, const Eigen::Vector2i& middle, double reach,
                     double mostFootprint) const;
    template <class SeenAt>
    void setPixels(const Part& part, double mostFootprint, const Errors& errors, const SeenAt& seenAt) const;
    template <class SeenAt>
    void setPixel(int x, int y, double mostFootprint, const ShownError& error, const SeenAt& seenAt) const;

    const PixelRays& m_rays;
    PlacesInPhoto m_places;
    ShownErrors m_errors;
    const MaskImage* m_overlays;
    PixelTrust& m_trust;
    int m_width;
    int m_height;
    int m_block;
};

/// Adds the errors of a row of blocks: each that of the pixel in its middle, or of another one that is seen.
void TrustBands::addErrorsOfRow(int top, Errors& errors) const {
    const int y = std::min(top + m_block / 2, m_height - 1);
    std::vector<ViewPixel> pixels;
    std::vector<std::size_t> ofPixels;
    const std::size_t first = errors.size();
    for (int left = 0; left < m_width; left += m_block) {
        const int end = std::min(m_width, left + m_block);
        ViewPixel pixel{(left + end) / 2, y, m_rays.ray((left + end) / 2, y)};
        for (int x = left; x < end && pixel.ray.isZero(0); ++x) {
            pixel = {x, y, m_rays.ray(x, y)};
        }
        if (!pixel.ray.isZero(0)) {
            ofPixels.push_back(first + static_cast<std::size_t>(left / m_block));
            pixels.push_back(pixel);
        }
    }
    errors.resize(first + static_cast<std::size_t>(blocks()));
    const std::vector<ShownError> found = m_errors.of(pixels);
    for (std::size_t i = 0; i < found.size(); ++i) {
        errors[ofPixels[i]] = found[i];
    }
}

/// Gives all pixels of a row of blocks their blocks' errors.
void TrustBands::fillRow(int top, int end, std::span<const ShownError> errors) const {
    float* px = m_trust.errorPx.at(0, top);
    std::uint8_t* flags = m_trust.flags.at(0, top);
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const int left = static_cast<int>(i) * m_block;
        const int count = std::min(m_block, m_width - left);
        std::fill_n(px + left, count, static_cast<float>(errors[i].px));
        std::fill_n(flags + left, count, bits(errors[i]));
    }
    for (int y = top + 1; y < end; ++y) {
        std::copy_n(px, m_width, m_trust.errorPx.at(0, y));
        std::copy_n(flags, m_width, m_trust.flags.at(0, y));
    }
}

template <class SeenAt>
void TrustBands::setPixel(int x, int y, double mostFootprint, const ShownError& error,
                          const SeenAt& seenAt) const {
    const Seen& own = seenAt(x, y);
    if (own.ray.isZero(0)) {
        *m_trust.errorPx.at(x, y) = std::numeric_limits<float>::infinity();
        *m_trust.flags.at(x, y) = static_cast<std::uint8_t>(PixelFlag::Unseen);
        return;
    }
    unsigned flags = m_places.flagsOfPlace(own.inPhoto);
    if (m_places.mayBlur() || m_places.isAtSeam(own.inPhoto, mostFootprint)) {
        const double footprint = m_places.footprint(own, x, y, seenAt);
        const double blur = m_places.blurPx(footprint);
        *m_trust.errorPx.at(x, y) = static_cast<float>(error.px + blur);
        flags |= (m_places.isAtSeam(own.inPhoto, footprint) ? static_cast<unsigned>(PixelFlag::Seam) : 0U) |
                 (blur > 0 ? static_cast<unsigned>(PixelFlag::Coarse) : 0U);
    }
    *m_trust.flags.at(x, y) |= static_cast<std::uint8_t>(flags);
}

template <class SeenAt>
void TrustBands::setPixels(const Part& part, double mostFootprint, const Errors& errors,
                           const SeenAt& seenAt) const {
    for (int y = part.top; y < part.bottom; ++y) {
        const auto row = static_cast<std::size_t>(y % kTrustRows / m_block * blocks());
        for (int x = part.left; x < part.right; ++x) {
            setPixel(x, y, mostFootprint, errors[row + static_cast<std::size_t>(x / m_block)], seenAt);
        }
    }
}

/// Adds to some pixels what depends on where the photo sees them, if that is the same for all of them.
/// Returns whether it is. reach: how far the pixels are from that in the middle at most.
bool TrustBands::setTogether(const Part& part, const Eigen::Vector2i& middle, double reach,
                             double mostFootprint) const {
    const std::optional<std::uint8_t> all =
        m_places.flagsWithin(reach, middle.x(), middle.y(), mostFootprint);
    for (int y = part.top; y < part.bottom && all.value_or(0) != 0; ++y) {
        std::uint8_t* flags = m_trust.flags.at(0, y);
        for (int x = part.left; x < part.right; ++x) {
            flags[x] |= *all;
        }
    }
    return all.has_value();
}

/// Adds to a square's pixels what depends on where the photo sees them.
void TrustBands::setSquare(int column, int band, const Errors& errors) const {
    constexpr int kHalf = kTrustRows / 2;
    const double reach = m_places.reach(column, band);
    const double mostFootprint = m_places.mostFootprint(2 * reach);
    const auto seenAt = [&](int x, int y) { return m_places.seen(x, y); };
    const int left = column * kTrustRows;
    const int top = band * kTrustRows;
    const Part square = part(left, top, kTrustRows);
    if (setTogether(square, m_rays.middle(column, band), reach, mostFootprint)) {
        return;
    }
    if (!m_places.halves()) {
        setPixels(square, mostFootprint, errors, seenAt);
        return;
    }
    for (int y = top; y < square.bottom; y += kHalf) {
        for (int x = left; x < square.right; x += kHalf) {
            const Part quarter = part(x, y, kHalf);
            const Eigen::Vector2i middle((x + quarter.right) / 2, (y + quarter.bottom) / 2);
            if (!setTogether(quarter, middle, 0.5 * reach, mostFootprint)) {
                setPixels(quarter, mostFootprint, errors, seenAt);
            }
        }
    }
}

void TrustBands::compute(int band) const {
    const int begin = band * kTrustRows;
    const int end = std::min(begin + kTrustRows, m_height);
    Errors errors;
    for (int top = begin; top < end; top += m_block) {
        const std::size_t first = errors.size();
        addErrorsOfRow(top, errors);
        fillRow(top, std::min(top + m_block, end), std::span(errors).subspan(first));
    }
    std::optional<SeenRows> rows;
    if (m_places.mayBlur()) {
        rows.emplace(m_places, m_rays.camera(), begin, end);
    }
    for (int column = 0; column * kTrustRows < m_width; ++column) {
        if (rows) {
            const double most = std::numeric_limits<double>::infinity();
            setPixels(part(column * kTrustRows, begin, kTrustRows), most, errors, *rows);
        } else {
            setSquare(column, band, errors);
        }
    }
    for (int y = begin; y < end && m_overlays != nullptr; ++y) {
        const std::uint8_t* covered = m_overlays->at(0, y);
        std::uint8_t* flags = m_trust.flags.at(0, y);
        for (int x = 0; x < m_width; ++x) {
            flags[x] |= covered[x] != 0 ? static_cast<std::uint8_t>(PixelFlag::Overlay) : std::uint8_t{0};
        }
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
                      WorkerPool& pool, int threads, PixelTrust memory) {
    view.validate();
    options.validate();
    const CameraModel& camera = view.rays.camera();
    if (options.overlays != nullptr &&
        (options.overlays->width() != camera.width() || options.overlays->height() != camera.height())) {
        refuseTrust(text("the overlays' mask has ", options.overlays->width(), " x ",
                         options.overlays->height(), " pixels, the view ", camera.width(), " x ",
                         camera.height()));
    }
    PixelTrust trust = std::move(memory);
    if (trust.flags.width() != camera.width() || trust.flags.height() != camera.height()) {
        trust = {Image<float, 1>(camera.width(), camera.height()),
                 MaskImage(camera.width(), camera.height())};
    }
    const TrustBands bands(view, evidence, options, trust);
    pool.run((camera.height() + kTrustRows - 1) / kTrustRows, threads,
             [&](int band, int) { bands.compute(band); });
    return trust;
}

} // namespace spherewalk::render
