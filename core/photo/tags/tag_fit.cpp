// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/photo/tag_fit.h"

#include "spherewalk/base/statistics.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace spherewalk::photo {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kCornerNumbers = 8;
constexpr int kBlur = kCornerNumbers;
constexpr int kLight = kBlur + 1;
constexpr int kLights = 7;
constexpr int kUnknowns = kLight + kLights;

using Unknowns = Eigen::Matrix<double, kUnknowns, 1>;
using Normal = Eigen::Matrix<double, kUnknowns, kUnknowns>;

constexpr double kFirstBlurPx = 0.5;
constexpr double kLeastBlurPx = 0.08;
constexpr double kMostBlurPx = 3;
constexpr double kRim = 0.7;          ///< Of the white rim, in cells, so much is compared.
constexpr double kLeastContrast = 12; ///< Grey levels between black and white.
constexpr double kMostMisfit = 0.15;  ///< Root mean square, as a share of the contrast.
constexpr double kMostMove = 1.5;     ///< Cells.
constexpr int kRounds = 25;
/// Errors of neighbouring pixels are alike: pictures are resampled, compressed and sharpened.
constexpr double kAlike = 2;
/// Edges that no lens blurs tell least of where they lie within a pixel. From there to where a lens blurs
/// them by half a pixel, what the fit itself cannot know of the corners' error falls to nothing.
constexpr double kLensBlurPx = 0.45;
constexpr double kSharpErrorPx = 0.04;

/// The tag's corner in cells.
Vector2d cellCorner(int corner) {
    return {corner == 1 || corner == 2 ? kTagCells : 0, corner >= 2 ? kTagCells : 0};
}

/// The homography that takes the plane to the tag's cells.
Matrix3d cellsFromPlane(const Unknowns& unknowns) {
    Eigen::Matrix<double, 8, 8> matrix;
    Eigen::Matrix<double, 8, 1> right;
    for (int i = 0; i < 4; ++i) {
        const Vector2d cell = cellCorner(i);
        const double x = unknowns[2 * i];
        const double y = unknowns[2 * i + 1];
        matrix.row(2 * i) << x, y, 1, 0, 0, 0, -cell.x() * x, -cell.x() * y;
        matrix.row(2 * i + 1) << 0, 0, 0, x, y, 1, -cell.y() * x, -cell.y() * y;
        right.segment<2>(2 * i) = cell;
    }
    const Eigen::Matrix<double, 8, 1> h = matrix.partialPivLu().solve(right);
    Matrix3d homography;
    homography << h[0], h[1], h[2], h[3], h[4], h[5], h[6], h[7], 1;
    return homography;
}

/// How much of each cell about a place its blurred point takes, along one axis, and the derivative of that.
struct Shares {
    static constexpr int kCount = 5;
    int first = 0;
    std::array<double, kCount> share{};
    std::array<double, kCount> slope{};
};

/// A blur along one axis, in cells: a Gaussian, and the pixel's own square.
struct Blur {
    double sigma = 0;
    double box = 0;
};

/// The share of the blur that lies below `far`, and its density there.
std::pair<double, double> below(double far, const Blur& blur) {
    const auto normal = [](double t) { return 0.5 * std::erfc(-t / std::numbers::sqrt2); };
    const auto integral = [&](double t) {
        return t * normal(t) + std::exp(-0.5 * t * t) / std::sqrt(2 * std::numbers::pi);
    };
    const double upper = (far + blur.box / 2) / blur.sigma;
    const double lower = (far - blur.box / 2) / blur.sigma;
    return {(integral(upper) - integral(lower)) * blur.sigma / blur.box,
            (normal(upper) - normal(lower)) / blur.box};
}

Shares sharesOf(double at, const Blur& blur) {
    Shares made;
    made.first = static_cast<int>(std::floor(at)) - Shares::kCount / 2;
    double before = 0;
    double slopeBefore = 0;
    for (int i = 0; i < Shares::kCount; ++i) {
        const bool isLast = i + 1 == Shares::kCount;
        const auto [upTo, density] = isLast ? std::pair(1.0, 0.0) : below(made.first + i + 1 - at, blur);
        made.share[static_cast<std::size_t>(i)] = upTo - before;
        made.slope[static_cast<std::size_t>(i)] = slopeBefore - density;
        before = upTo;
        slopeBefore = density;
    }
    return made;
}

/// The blurred pattern at a place, 0 for black and 1 for white, with its slopes.
struct Shade {
    double value = 0;
    Vector2d slope = Vector2d::Zero();
};

class Pattern {
  public:
    explicit Pattern(const TagCells& cells) : m_cells(cells) {}

    Shade shade(const Vector2d& cell, const std::array<Blur, 2>& blur) const {
        const Shares across = sharesOf(cell.x(), blur[0]);
        const Shares down = sharesOf(cell.y(), blur[1]);
        Shade made;
        for (int j = 0; j < Shares::kCount; ++j) {
            const auto row = static_cast<std::size_t>(j);
            for (int i = 0; i < Shares::kCount; ++i) {
                const auto column = static_cast<std::size_t>(i);
                if (isWhite(down.first + j, across.first + i)) {
                    made.value += down.share[row] * across.share[column];
                    made.slope.x() += down.share[row] * across.slope[column];
                    made.slope.y() += down.slope[row] * across.share[column];
                }
            }
        }
        return made;
    }

  private:
    bool isWhite(int row, int column) const {
        const int cell = row * kTagCells + column;
        return row < 0 || column < 0 || row >= kTagCells || column >= kTagCells ||
               m_cells[static_cast<std::size_t>(cell)];
    }

    TagCells m_cells;
};

using Lights = Eigen::Matrix<double, kLights, 1>;

/// From -1 to 1 across the tag and down.
Vector2d placeOnTag(const Vector2d& cell) {
    return 2 * cell / kTagCells - Vector2d::Ones();
}

/// What the lights multiply: black, contrast, the shoulder that makes white spread, and gradients of contrast
/// and of black.
Lights lightFactors(double shade, const Vector2d& cell) {
    const Vector2d at = placeOnTag(cell);
    return Lights{{1, shade, shade * (1 - shade), shade * at.x(), shade * at.y(), at.x(), at.y()}};
}

/// How the grey changes with the shade alone.
double greyByShade(const Lights& lights, double shade, const Vector2d& cell) {
    return lights[1] + lights[2] * (1 - 2 * shade) + lights.segment<2>(3).dot(placeOnTag(cell));
}

/// How the grey changes with the place on the tag, in cells.
Vector2d greyByCell(const Lights& lights, const Shade& shade, const Vector2d& cell) {
    return greyByShade(lights, shade.value, cell) * shade.slope +
           2.0 / kTagCells * (shade.value * lights.segment<2>(3) + lights.tail<2>());
}

class Fit {
  public:
    Fit(const TagCells& cells, std::span<const TagPixel> pixels, double pitch,
        const TagCorners<Vector2d>& about)
        : m_pattern(cells), m_pixels(pixels), m_pitch(pitch) {
        for (int i = 0; i < 4; ++i) {
            m_now.segment<2>(2 * i) = about[static_cast<std::size_t>(i)];
        }
        m_now[kBlur] = kFirstBlurPx;
        m_first = m_now;
    }

    std::optional<TagFit> run() {
        if (!choosePixels() || !findLight()) {
            return std::nullopt;
        }
        Sums sums = sumsAt(m_now);
        double damping = 1e-3;
        for (int round = 0; round < kRounds; ++round) {
            Normal damped = sums.normal;
            damped.diagonal() *= 1 + damping;
            Unknowns next = m_now - damped.ldlt().solve(sums.gradient);
            next[kBlur] = std::clamp(next[kBlur], kLeastBlurPx, kMostBlurPx);
            if (!next.allFinite()) {
                return std::nullopt;
            }
            const Sums tried = sumsAt(next);
            if (!(tried.cost < sums.cost)) {
                damping *= 10;
                if (damping > 1e6) {
                    break;
                }
                continue;
            }
            const double gain = 1 - tried.cost / sums.cost;
            m_now = next;
            sums = tried;
            damping = std::max(damping / 10, 1e-9);
            if (round == 4) { // What lies over the tag is down-weighted from now on.
                weigh();
                sums = sumsAt(m_now);
            } else if (round > 6 && gain < 1e-9) {
                break;
            }
        }
        return result(sums);
    }

  private:
    struct Sums {
        Normal normal = Normal::Zero();
        Unknowns gradient = Unknowns::Zero();
        double cost = 0;
    };

    struct Used {
        TagPixel pixel;
        double weight = 1;
    };

    /// The pixels on the tag and its rim; not more than it takes.
    bool choosePixels() {
        constexpr std::size_t kMost = 10000;
        constexpr std::size_t kFewest = 120;
        const Matrix3d homography = cellsFromPlane(m_now);
        for (const TagPixel& pixel : m_pixels) {
            const Vector2d cell = (homography * pixel.at.homogeneous()).hnormalized();
            if (cell.minCoeff() > -kRim && cell.maxCoeff() < kTagCells + kRim) {
                m_used.push_back({pixel});
            }
        }
        if (m_used.size() > kMost) {
            const std::size_t every = m_used.size() / kMost + 1;
            std::vector<Used> fewer;
            for (std::size_t i = 0; i < m_used.size(); i += every) {
                fewer.push_back(m_used[i]);
            }
            m_used = std::move(fewer);
        }
        return m_used.size() >= kFewest;
    }

    /// blurPx: of the Gaussian. A pixel that lies aslant has two sides along each axis of the tag; the
    /// smaller one goes into the Gaussian.
    std::array<Blur, 2> blurInCells(const Matrix3d& homography, const Vector2d& at, const Vector2d& cell,
                                    double blurPx) const {
        const double depth = homography.row(2).dot(at.homogeneous());
        const Eigen::Matrix2d sides =
            m_pitch * (homography.topLeftCorner<2, 2>() - cell * homography.bottomLeftCorner<1, 2>()) / depth;
        std::array<Blur, 2> made;
        for (int axis = 0; axis < 2; ++axis) {
            const Vector2d side = sides.row(axis).cwiseAbs();
            made[static_cast<std::size_t>(axis)] = {
                std::hypot(blurPx * side.norm(), side.minCoeff() / std::sqrt(12.0)), side.maxCoeff()};
        }
        return made;
    }

    /// The light by linear least squares, with the geometry as it is.
    bool findLight() {
        const Matrix3d homography = cellsFromPlane(m_now);
        Eigen::Matrix<double, kLights, kLights> matrix = decltype(matrix)::Identity() * 1e-6;
        Lights right = Lights::Zero();
        for (const Used& used : m_used) {
            const Vector2d cell = (homography * used.pixel.at.homogeneous()).hnormalized();
            const Shade shade =
                m_pattern.shade(cell, blurInCells(homography, used.pixel.at, cell, m_now[kBlur]));
            const auto factors = lightFactors(shade.value, cell);
            matrix += factors * factors.transpose();
            right += factors * used.pixel.grey;
        }
        m_now.tail<kLights>() = matrix.ldlt().solve(right);
        return m_now[kLight + 1] > kLeastContrast;
    }

    /// Pairs the model's derivatives with what it misses by.
    Sums sumsAt(const Unknowns& unknowns) {
        const Matrix3d homography = cellsFromPlane(unknowns);
        std::array<Matrix3d, kCornerNumbers> moved;
        const double step = 1e-4 * m_pitch;
        for (int i = 0; i < kCornerNumbers; ++i) {
            Unknowns other = unknowns;
            other[i] += step;
            moved[static_cast<std::size_t>(i)] = cellsFromPlane(other);
        }
        Sums sums;
        for (const Used& used : m_used) {
            const Eigen::Vector3d at = used.pixel.at.homogeneous();
            const Vector2d cell = (homography * at).hnormalized();
            constexpr double kMoreBlur = 1.01;
            const auto shadeBy = [&](double blurPx) {
                return m_pattern.shade(cell, blurInCells(homography, used.pixel.at, cell, blurPx));
            };
            const Shade shade = shadeBy(unknowns[kBlur]);
            const Shade blurred = shadeBy(kMoreBlur * unknowns[kBlur]);
            const Lights lights = unknowns.tail<kLights>();
            const Lights factors = lightFactors(shade.value, cell);
            const Vector2d byCell = greyByCell(lights, shade, cell);
            Unknowns by;
            for (int i = 0; i < kCornerNumbers; ++i) {
                by[i] = byCell.dot((moved[static_cast<std::size_t>(i)] * at).hnormalized() - cell) / step;
            }
            by[kBlur] = greyByShade(lights, shade.value, cell) * (blurred.value - shade.value) /
                        ((kMoreBlur - 1) * unknowns[kBlur]);
            by.tail<kLights>() = factors;
            const double miss = lights.dot(factors) - used.pixel.grey;
            sums.normal += used.weight * by * by.transpose();
            sums.gradient += used.weight * miss * by;
            sums.cost += used.weight * miss * miss;
        }
        return sums;
    }

    std::vector<double> misses() const {
        const Matrix3d homography = cellsFromPlane(m_now);
        std::vector<double> made;
        for (const Used& used : m_used) {
            const Vector2d cell = (homography * used.pixel.at.homogeneous()).hnormalized();
            const Shade shade =
                m_pattern.shade(cell, blurInCells(homography, used.pixel.at, cell, m_now[kBlur]));
            made.push_back(
                std::abs(m_now.tail<kLights>().dot(lightFactors(shade.value, cell)) - used.pixel.grey));
        }
        return made;
    }

    void weigh() {
        const std::vector<double> missed = misses();
        const double scale = std::max(1.0, 1.4826 * median(missed));
        for (std::size_t i = 0; i < missed.size(); ++i) {
            m_used[i].weight = 1 / (1 + std::pow(missed[i] / (4 * scale), 2));
        }
    }

    std::optional<TagFit> result(const Sums& sums) const {
        const double contrast = m_now[kLight + 1];
        const double variance = sums.cost / static_cast<double>(m_used.size());
        double squares = 0; // Of all pixels alike, so that what covers the tag counts in full.
        for (const double miss : misses()) {
            squares += miss * miss / static_cast<double>(m_used.size());
        }
        const double cell =
            (m_first.head<2>() - m_first.segment<2>(4)).norm() / (std::numbers::sqrt2 * kTagCells);
        const bool isMoved =
            (m_now - m_first).head<kCornerNumbers>().cwiseAbs().maxCoeff() > kMostMove * cell;
        if (contrast < kLeastContrast || std::sqrt(squares) > kMostMisfit * contrast || isMoved) {
            return std::nullopt;
        }
        const Normal covariance = sums.normal.ldlt().solve(Normal::Identity()) * std::max(variance, 1 / 12.0);
        TagFit fit;
        for (int i = 0; i < 4; ++i) {
            fit.corners[static_cast<std::size_t>(i)] = m_now.segment<2>(2 * i);
        }
        const double sharp = std::max(0.0, 1 - m_now[kBlur] / kLensBlurPx);
        fit.sigma = std::hypot(
            kAlike * std::sqrt(covariance.diagonal().head<kCornerNumbers>().sum() / kCornerNumbers),
            sharp * kSharpErrorPx * m_pitch);
        return std::isfinite(fit.sigma) ? std::optional(fit) : std::nullopt;
    }

    Pattern m_pattern;
    std::span<const TagPixel> m_pixels;
    double m_pitch;
    std::vector<Used> m_used;
    Unknowns m_now = Unknowns::Zero();
    Unknowns m_first = Unknowns::Zero();
};

} // namespace

std::optional<TagFit> fittedTag(const TagCells& cells, std::span<const TagPixel> pixels, double pitch,
                                const TagCorners<Vector2d>& about) {
    return Fit(cells, pixels, pitch, about).run();
}

} // namespace spherewalk::photo
