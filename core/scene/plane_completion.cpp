// SPDX-License-Identifier: GPL-3.0-or-later
#include "plane_filters.h"
#include "vector_math.h"

#include "spherewalk/base/parallel.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <vector>

namespace spherewalk::scene {

using Eigen::Matrix3d;
using Eigen::Vector3f;

namespace {

constexpr float kEdge = 6;         ///< Grey levels between two pixels at which they are tied half as firmly.
constexpr float kLeastTie = 1e-3F; ///< Neighbours are always tied a little, so that nothing stands alone.
constexpr int kWidthOfReach = 1024;
constexpr float kNearer = 1.08F; ///< What is nearer by this factor is another thing.
constexpr float kTieToNearer = 0.1F;
constexpr float kWeight = 30;    ///< Of a known value in a picture of that width, to ties of 1.
constexpr float kPrior = 2e-5F;  ///< Likewise of the usual value.
constexpr float kFadeRad = 0.5F; ///< Within about this angle from what is known planes fade.
constexpr float kOverRelaxed = 1.5F;
constexpr int kCoarsestWidth = 32;

/// One number a pixel. In a row the pixels of even columns come first, then those of odd ones. Of one half of
/// each row, if halves take turns from row to row, no pixel is beside another: all can be solved at once.
class Halves {
  public:
    Halves() = default;

    Halves(int width, int height) : m_values(width, height) {}

    float& at(int x, int y) { return half(x % 2, y)[x / 2]; }

    float at(int x, int y) const { return half(x % 2, y)[x / 2]; }

    /// The pixels of even (0) or of odd columns (1).
    float* half(int which, int y) { return m_values.at(which * (m_values.width() / 2), y); }

    const float* half(int which, int y) const { return m_values.at(which * (m_values.width() / 2), y); }

  private:
    Plane m_values;
};

/// What is solved for at each pixel: the three numbers of a plane's vector, and these.
constexpr std::size_t kShareKnown = 3; ///< How much is known about, from 0 to 1.
constexpr std::size_t kEven = 4;       ///< The value that changes least from pixel to pixel.
constexpr std::size_t kSolved = 5;

/// One size of the problem.
struct Level {
    Level(int widthPx, int heightPx)
        : width(widthPx),
          height(heightPx),
          cosAzimuth(widthPx, 1),
          sinAzimuth(widthPx, 1),
          right(widthPx, heightPx),
          down(widthPx, heightPx) {
        const PixelAngles angles(width);
        for (int x = 0; x < width; ++x) {
            cosAzimuth.at(x, 0) = angles.cosAzimuth[static_cast<std::size_t>(x)];
            sinAzimuth.at(x, 0) = angles.sinAzimuth[static_cast<std::size_t>(x)];
        }
        cosElevation = angles.cosElevation;
        sinElevation = angles.sinElevation;
        found.fill(right);
        pull.fill(right);
        solve.fill(right);
    }

    /// The direction of a pixel.
    Vector3f ray(int x, int y) const {
        const float cosine = cosElevation[static_cast<std::size_t>(y)];
        return {cosine * cosAzimuth.at(x, 0), cosine * sinAzimuth.at(x, 0),
                sinElevation[static_cast<std::size_t>(y)]};
    }

    int width;
    int height;
    Halves cosAzimuth;
    Halves sinAzimuth;
    std::vector<float> cosElevation;
    std::vector<float> sinElevation;
    Halves right; ///< How firmly a pixel is tied to the one on its right, from 0 to 1.
    Halves down;
    std::array<Halves, kSolved> found;
    std::array<Halves, 4> pull; ///< The sum of weight x value x direction, and of weight.
    /// First the sum of weight x direction x direction, then the inverse of what is to be solved. A symmetric
    /// matrix: its upper triangle, row by row.
    std::array<Halves, 6> solve;
};

/// How a row's pixels are tied to those beside and below, by their shape on the sphere.
struct RowShape {
    RowShape(int y, int height)
        : cosine(cosineAt(y + 0.5, height)),
          across(1 / std::max(kLeastCosine, cosine)),
          above(y > 0 ? std::max(kLeastCosine, cosineAt(y, height)) : 0),
          below(y + 1 < height ? std::max(kLeastCosine, cosineAt(y + 1, height)) : 0) {}

    static float cosineAt(double row, int height) {
        return static_cast<float>(std::max(0.0, std::sin(std::numbers::pi * row / height)));
    }

    /// Nearer to the poles pixels are tied as here; else it would take many rounds to tie one row to the
    /// next.
    static constexpr float kLeastCosine = 0.25F;

    float cosine;
    float across;
    float above;
    float below;
};

/// The area of a pixel, in those of a picture of the usual width.
float perArea(const Level& level) {
    const float side = static_cast<float>(kWidthOfReach) / static_cast<float>(level.width);
    return side * side;
}

float tieOf(const RgbImage& picture, int x, int y, int besideX, int besideY) {
    int most = 0;
    for (int c = 0; c < 3; ++c) {
        most = std::max(most, std::abs(picture.at(x, y)[c] - picture.at(besideX, besideY)[c]));
    }
    const float edge = static_cast<float>(most) / kEdge;
    return std::max(kLeastTie, 1 / (1 + edge * edge * edge * edge));
}

/// Ties in line: half of the first, all of the middle one, half of the last.
float inLine(float first, float middle, float last) {
    return 2 / (0.5F / first + 1 / middle + 0.5F / last);
}

/// Some pixels of a half row that are solved, and what this takes. Arrays have a value a pixel.
struct Strip {
    using Values = std::array<const float*, kSolved>;

    Values left; ///< Of the pixels beside.
    Values right;
    Values above;
    Values below;
    std::array<const float*, 4> ties; ///< To those beside, in this order,
    std::array<float, 4> shape;       ///< and what they are multiplied by.
    std::array<const float*, 4> pull;
    std::array<const float*, 6> solve;
    const float* cosAzimuth;
    const float* sinAzimuth;
    float cosElevation;
    float sinElevation;
    float prior;
    float priorOfEven;
    float usual;
    float fade;
};

/// Solves pixels for given ones beside.
SPHEREWALK_VECTOR_CLONES
void relaxStrip(const Strip& strip, int count, float* __restrict vectorX, float* __restrict vectorY,
                float* __restrict vectorZ, float* __restrict share, float* __restrict even) {
    const Strip s = strip; // No store can change the copy.
    for (int i = 0; i < count; ++i) {
        const float left = s.shape[0] * s.ties[0][i];
        const float right = s.shape[1] * s.ties[1][i];
        const float above = s.shape[2] * s.ties[2][i];
        const float below = s.shape[3] * s.ties[3][i];
        const auto beside = [&](std::size_t k) __attribute__((always_inline)) {
            return left * s.left[k][i] + right * s.right[k][i] +
                   (above * s.above[k][i] + below * s.below[k][i]);
        };
        const float rayX = s.cosElevation * s.cosAzimuth[i];
        const float rayY = s.cosElevation * s.sinAzimuth[i];
        const float rayZ = s.sinElevation;
        const float prior = s.prior * s.usual;
        const float x = s.pull[0][i] + beside(0) + prior * rayX;
        const float y = s.pull[1][i] + beside(1) + prior * rayY;
        const float z = s.pull[2][i] + beside(2) + prior * rayZ;
        vectorX[i] += kOverRelaxed * (s.solve[0][i] * x + s.solve[1][i] * y + s.solve[2][i] * z - vectorX[i]);
        vectorY[i] += kOverRelaxed * (s.solve[1][i] * x + s.solve[3][i] * y + s.solve[4][i] * z - vectorY[i]);
        vectorZ[i] += kOverRelaxed * (s.solve[2][i] * x + s.solve[4][i] * y + s.solve[5][i] * z - vectorZ[i]);
        const float tied = s.pull[3][i] + left + right + above + below;
        share[i] += kOverRelaxed * ((s.pull[3][i] + beside(kShareKnown)) / (tied + s.fade) - share[i]);
        const float known = s.pull[0][i] * rayX + s.pull[1][i] * rayY + s.pull[2][i] * rayZ;
        even[i] += kOverRelaxed *
                   ((known + beside(kEven) + s.priorOfEven * s.usual) / (tied + s.priorOfEven) - even[i]);
    }
}

class Completion {
  public:
    Completion(const Plane& known, const Plane& weight, const RgbImage& picture, const Plane& base,
               const CompletionRange& range, int threads)
        : m_base(base), m_range(range), m_threads(threads) {
        m_levels.emplace_back(known.width(), known.height());
        tie(picture);
        tieBehind(known, weight);
        gather(known, weight);
        while (m_levels.back().width > kCoarsestWidth && m_levels.back().width % 4 == 0) {
            m_levels.push_back(coarser(m_levels.back()));
        }
    }

    Plane run() {
        for (std::size_t k = m_levels.size(); k-- > 0;) {
            Level& level = m_levels[k];
            begin(k);
            invert(level);
            const int rounds = k + 1 == m_levels.size() ? 100
                               : level.width <= 128     ? 40
                               : level.width <= 512     ? 10
                                                        : 3;
            for (int round = 0; round < 2 * rounds; ++round) {
                relax(level, round % 2);
            }
        }
        return values();
    }

  private:
    float baseAt(int x, int y) const { return m_base.empty() ? 0.0F : *m_base.at(x, y); }

    template <class Row>
    void forRows(const Level& level, const Row& row) const {
        parallelFor(level.height, 8, m_threads, [&](int begin, int end) {
            for (int y = begin; y < end; ++y) {
                row(y);
            }
        });
    }

    void tie(const RgbImage& picture) {
        Level& level = m_levels.front();
        forRows(level, [&](int y) {
            for (int x = 0; x < level.width; ++x) {
                level.right.at(x, y) = tieOf(picture, x, y, (x + 1) % level.width, y);
                level.down.at(x, y) = tieOf(picture, x, y, x, std::min(y + 1, level.height - 1));
            }
        });
    }

    /// What photos beside do not confirm is mostly hidden from them by a thing in front of it. So it is tied
    /// less to what is known and nearer than other known things about.
    void tieBehind(const Plane& known, const Plane& weight) {
        Level& level = m_levels.front();
        const Plane farthest = leastKnownAbout(known, weight, m_threads);
        const auto isHidden = [&](int x, int y, int byX, int byY) {
            return *weight.at(byX, byY) > 0 && *weight.at(x, y) <= 0 &&
                   *known.at(byX, byY) > kNearer * *farthest.at(x, y);
        };
        forRows(level, [&](int y) {
            for (int x = 0; x < level.width; ++x) {
                const int beside = (x + 1) % level.width;
                const int below = std::min(y + 1, level.height - 1);
                level.right.at(x, y) *=
                    isHidden(x, y, beside, y) || isHidden(beside, y, x, y) ? kTieToNearer : 1;
                level.down.at(x, y) *=
                    isHidden(x, y, x, below) || isHidden(x, below, x, y) ? kTieToNearer : 1;
            }
        });
    }

    void gather(const Plane& known, const Plane& weight) {
        Level& level = m_levels.front();
        forRows(level, [&](int y) {
            const float area = RowShape(y, level.height).cosine * kWeight * perArea(level);
            for (int x = 0; x < level.width; ++x) {
                const Vector3f ray = level.ray(x, y);
                const float pull = area * *weight.at(x, y);
                const float beyond = *known.at(x, y) - baseAt(x, y);
                std::size_t at = 0;
                for (int i = 0; i < 3; ++i) {
                    level.pull[static_cast<std::size_t>(i)].at(x, y) = pull * beyond * ray[i];
                    for (int j = i; j < 3; ++j) {
                        level.solve[at++].at(x, y) = pull * ray[i] * ray[j];
                    }
                }
                level.pull[3].at(x, y) = pull;
            }
        });
    }

    Level coarser(const Level& fine) const {
        Level level(fine.width / 2, fine.height / 2);
        const auto sum = [&](const Halves& of, int x, int y) {
            return of.at(2 * x, 2 * y) + of.at(2 * x + 1, 2 * y) + of.at(2 * x, 2 * y + 1) +
                   of.at(2 * x + 1, 2 * y + 1);
        };
        forRows(level, [&](int y) {
            const int row = std::min(2 * y + 2, fine.height - 1);
            for (int x = 0; x < level.width; ++x) {
                for (std::size_t i = 0; i < level.solve.size(); ++i) {
                    level.solve[i].at(x, y) = sum(fine.solve[i], x, y);
                }
                for (std::size_t i = 0; i < level.pull.size(); ++i) {
                    level.pull[i].at(x, y) = sum(fine.pull[i], x, y);
                }
                for (int i = 0; i < 2; ++i) {
                    level.right.at(x, y) +=
                        0.5F * inLine(fine.right.at(2 * x, 2 * y + i), fine.right.at(2 * x + 1, 2 * y + i),
                                      fine.right.at((2 * x + 2) % fine.width, 2 * y + i));
                    level.down.at(x, y) +=
                        0.5F * inLine(fine.down.at(2 * x + i, 2 * y), fine.down.at(2 * x + i, 2 * y + 1),
                                      fine.down.at(2 * x + i, row));
                }
            }
        });
        return level;
    }

    /// A level begins with what the coarser one found.
    void begin(std::size_t k) {
        Level& level = m_levels[k];
        forRows(level, [&](int y) {
            for (int x = 0; x < level.width; ++x) {
                if (k + 1 < m_levels.size()) {
                    for (std::size_t i = 0; i < kSolved; ++i) {
                        level.found[i].at(x, y) = m_levels[k + 1].found[i].at(x / 2, y / 2);
                    }
                } else {
                    const Vector3f vector = m_range.usual * level.ray(x, y);
                    for (std::size_t i = 0; i < 3; ++i) {
                        level.found[i].at(x, y) = vector[static_cast<int>(i)];
                    }
                    level.found[kEven].at(x, y) = m_range.usual;
                }
            }
        });
    }

    void invert(Level& level) {
        forRows(level, [&](int y) {
            const RowShape shape(y, level.height);
            const float area = kPrior * perArea(level) * shape.cosine;
            for (int x = 0; x < level.width; ++x) {
                const int left = (x + level.width - 1) % level.width;
                const float tied = shape.across * (level.right.at(left, y) + level.right.at(x, y)) +
                                   shape.above * level.down.at(x, std::max(0, y - 1)) +
                                   shape.below * level.down.at(x, y);
                Matrix3d solve;
                std::size_t at = 0;
                for (int i = 0; i < 3; ++i) {
                    for (int j = i; j < 3; ++j) {
                        solve(i, j) = solve(j, i) =
                            static_cast<double>(level.solve[at++].at(x, y) + (i == j ? tied + area : 0));
                    }
                }
                solve = solve.inverse().eval();
                at = 0;
                for (int i = 0; i < 3; ++i) {
                    for (int j = i; j < 3; ++j) {
                        level.solve[at++].at(x, y) = static_cast<float>(solve(i, j));
                    }
                }
            }
        });
    }

    /// Solves every second pixel, as on a chess board, for given neighbours.
    void relax(Level& level, int colour) {
        forRows(level, [&](int y) {
            const int which = (y + colour) % 2;
            const int count = level.width / 2;
            // The first even pixel and the last odd one are beside each other, round the seam.
            relax(level, y, which, which == 0 ? 1 : 0, count - 1, 0, 1);
            relax(level, y, which, which == 0 ? 0 : count - 1, 1, count - 1, 0);
        });
    }

    template <std::size_t kCount>
    static std::array<const float*, kCount> from(const std::array<Halves, kCount>& planes, int which, int y,
                                                 int first) {
        std::array<const float*, kCount> result;
        std::transform(planes.begin(), planes.end(), result.begin(),
                       [&](const Halves& plane) { return plane.half(which, y) + first; });
        return result;
    }

    /// Solves pixels of a half row. left, right: where those beside the first one are in the other half.
    void relax(Level& level, int y, int which, int first, int count, int left, int right) {
        const RowShape shape(y, level.height);
        const int above = y > 0 ? y - 1 : 1;
        const int below = y + 1 < level.height ? y + 1 : y - 1;
        const float pixelRad = 2 * std::numbers::pi_v<float> / static_cast<float>(level.width);
        const float fade = shape.cosine * pixelRad * pixelRad / (kFadeRad * kFadeRad);
        const auto found = [&](std::size_t k) { return level.found[k].half(which, y) + first; };
        const Strip strip{.left = from(level.found, 1 - which, y, left),
                          .right = from(level.found, 1 - which, y, right),
                          .above = from(level.found, which, above, first),
                          .below = from(level.found, which, below, first),
                          .ties = {level.right.half(1 - which, y) + left, level.right.half(which, y) + first,
                                   level.down.half(which, above) + first, level.down.half(which, y) + first},
                          .shape = {shape.across, shape.across, shape.above, shape.below},
                          .pull = from(level.pull, which, y, first),
                          .solve = from(level.solve, which, y, first),
                          .cosAzimuth = level.cosAzimuth.half(which, 0) + first,
                          .sinAzimuth = level.sinAzimuth.half(which, 0) + first,
                          .cosElevation = level.cosElevation[static_cast<std::size_t>(y)],
                          .sinElevation = level.sinElevation[static_cast<std::size_t>(y)],
                          .prior = kPrior * perArea(level) * shape.cosine,
                          .priorOfEven = m_base.empty() ? kPrior * perArea(level) * shape.cosine : fade,
                          .usual = m_range.usual,
                          .fade = fade};
        relaxStrip(strip, count, found(0), found(1), found(2), found(kShareKnown), found(kEven));
    }

    Plane values() const {
        const Level& level = m_levels.front();
        Plane result(level.width, level.height);
        const auto within = [&](float value) { return std::clamp(value, m_range.least, m_range.most); };
        forRows(level, [&](int y) {
            for (int x = 0; x < level.width; ++x) {
                const Vector3f vector(level.found[0].at(x, y), level.found[1].at(x, y),
                                      level.found[2].at(x, y));
                const float base = baseAt(x, y);
                const float even = within(base + level.found[kEven].at(x, y));
                const float share = std::clamp(level.found[kShareKnown].at(x, y), 0.0F, 1.0F);
                *result.at(x, y) = even + share * (within(base + vector.dot(level.ray(x, y))) - even);
            }
        });
        return result;
    }

    const Plane& m_base;
    CompletionRange m_range;
    int m_threads;
    std::vector<Level> m_levels;
};

} // namespace

Plane completedByPlanes(const Plane& known, const Plane& weight, const RgbImage& picture, const Plane& base,
                        const CompletionRange& range, int threads) {
    return Completion(known, weight, picture, base, range, threads).run();
}

} // namespace spherewalk::scene
