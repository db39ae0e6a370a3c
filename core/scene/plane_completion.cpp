// SPDX-License-Identifier: GPL-3.0-or-later
#include "plane_filters.h"

#include "spherewalk/base/parallel.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <vector>

namespace spherewalk::scene {

using Eigen::Matrix3f;
using Eigen::Vector2f;
using Eigen::Vector3f;
using Eigen::Vector4f;

namespace {

constexpr float kEdge = 6;         ///< Grey levels between two pixels at which they are tied half as firmly.
constexpr float kLeastTie = 1e-3F; ///< Neighbours are always tied a little, so that nothing stands alone.
constexpr int kWidthOfReach = 1024;
constexpr int kBehind = 32;      ///< Reach in pixels of a picture of that width; see tieBehind().
constexpr float kNearer = 1.08F; ///< What is nearer by this factor is another thing.
constexpr float kTieToNearer = 0.1F;
constexpr float kWeight = 30;    ///< Of a known value in a picture of that width, to ties of 1.
constexpr float kPrior = 2e-5F;  ///< Likewise of the usual value.
constexpr float kFadeRad = 0.5F; ///< Within about this angle from what is known planes fade.
constexpr float kOverRelaxed = 1.5F;
constexpr int kCoarsestWidth = 32;

/// One size of the problem.
struct Level {
    Level(int widthPx, int heightPx)
        : width(widthPx),
          height(heightPx),
          right(widthPx, heightPx),
          down(widthPx, heightPx),
          vectors(widthPx, heightPx),
          pull(widthPx, heightPx),
          even(widthPx, heightPx),
          solve(static_cast<std::size_t>(widthPx) * static_cast<std::size_t>(heightPx)) {
        for (int x = 0; x < width; ++x) {
            const double azimuth = std::numbers::pi - 2 * std::numbers::pi / width * (x + 0.5);
            headings.emplace_back(static_cast<float>(std::cos(azimuth)),
                                  static_cast<float>(std::sin(azimuth)));
        }
        for (int y = 0; y < height; ++y) {
            const double elevation = std::numbers::pi / 2 - std::numbers::pi / height * (y + 0.5);
            rises.emplace_back(static_cast<float>(std::cos(elevation)),
                               static_cast<float>(std::sin(elevation)));
        }
    }

    /// The direction of a pixel, and 0.
    Vector4f ray(int x, int y) const {
        const Vector2f heading = headings[static_cast<std::size_t>(x)];
        const Vector2f rise = rises[static_cast<std::size_t>(y)];
        return {rise.x() * heading.x(), rise.x() * heading.y(), rise.y(), 0};
    }

    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }

    int width;
    int height;
    std::vector<Vector2f> headings; ///< Cosine and sine of each column's azimuth.
    std::vector<Vector2f> rises;    ///< Cosine and sine of each row's elevation.
    Plane right;                    ///< How firmly a pixel is tied to the one on its right, from 0 to 1.
    Plane down;
    Image<float, 4> vectors;     ///< And how much is known about, from 0 to 1.
    Image<float, 4> pull;        ///< The sum of weight x value x direction, and of weight.
    Plane even;                  ///< The value that changes least from pixel to pixel.
    std::vector<Matrix3f> solve; ///< First the sum of weight x direction x direction, then its inverse.
};

/// How a row's pixels are tied to those beside and below, by their shape on the sphere.
struct RowShape {
    RowShape(int y, int height)
        : cosine(cosineAt(y + 0.5, height)),
          across(1 / std::max(kLeastCosine, cosine)),
          above(std::max(kLeastCosine, cosineAt(y, height))),
          below(std::max(kLeastCosine, cosineAt(y + 1, height))) {}

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

/// The least known value about each pixel; HUGE_VALF if none is near.
Plane farthestAbout(const Plane& known, const Plane& weight, int threads) {
    Plane plane(known.width(), known.height());
    for (std::size_t i = 0; i < plane.values().size(); ++i) {
        plane.values()[i] = weight.values()[i] > 0 ? known.values()[i] : HUGE_VALF;
    }
    for (int reach = 1; 2 * reach <= kBehind * known.width() / kWidthOfReach; reach *= 2) {
        Plane last = plane;
        parallelFor(plane.height(), 16, threads, [&](int begin, int end) {
            for (int y = begin; y < end; ++y) {
                const float* above = last.at(0, std::max(0, y - reach));
                const float* below = last.at(0, std::min(y + reach, plane.height() - 1));
                const float* here = last.at(0, y);
                float* out = plane.at(0, y);
                for (int x = 0; x < plane.width(); ++x) {
                    const int left = x < reach ? x - reach + plane.width() : x - reach;
                    const int right = x + reach < plane.width() ? x + reach : x + reach - plane.width();
                    out[x] = std::min({here[x], above[x], below[x], here[left], here[right]});
                }
            }
        });
    }
    return plane;
}

/// Ties in line: half of the first, all of the middle one, half of the last.
float inLine(float first, float middle, float last) {
    return 2 / (0.5F / first + 1 / middle + 0.5F / last);
}

class Completion {
  public:
    Completion(const Plane& known, const Plane& weight, const RgbImage& picture, const CompletionRange& range,
               int threads)
        : m_range(range), m_threads(threads) {
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
                *level.right.at(x, y) = tieOf(picture, x, y, (x + 1) % level.width, y);
                *level.down.at(x, y) = tieOf(picture, x, y, x, std::min(y + 1, level.height - 1));
            }
        });
    }

    /// What photos beside do not confirm is mostly hidden from them by a thing in front of it. So it is tied
    /// less to what is known and nearer than other known things about.
    void tieBehind(const Plane& known, const Plane& weight) {
        Level& level = m_levels.front();
        const Plane farthest = farthestAbout(known, weight, m_threads);
        const auto isNearer = [&](std::size_t a, std::size_t b) {
            return weight.values()[a] > 0 && weight.values()[b] <= 0 &&
                   known.values()[a] > kNearer * farthest.values()[b];
        };
        forRows(level, [&](int y) {
            for (int x = 0; x < level.width; ++x) {
                const std::size_t here = level.index(x, y);
                const std::size_t beside = level.index((x + 1) % level.width, y);
                const std::size_t below = level.index(x, std::min(y + 1, level.height - 1));
                *level.right.at(x, y) *= isNearer(here, beside) || isNearer(beside, here) ? kTieToNearer : 1;
                *level.down.at(x, y) *= isNearer(here, below) || isNearer(below, here) ? kTieToNearer : 1;
            }
        });
    }

    void gather(const Plane& known, const Plane& weight) {
        Level& level = m_levels.front();
        forRows(level, [&](int y) {
            const float area = RowShape(y, level.height).cosine * kWeight * perArea(level);
            for (int x = 0; x < level.width; ++x) {
                const Vector3f ray(level.ray(x, y).data());
                const float pull = area * *weight.at(x, y);
                level.solve[level.index(x, y)] = pull * ray * ray.transpose();
                Eigen::Map<Vector3f>(level.pull.at(x, y)) = pull * *known.at(x, y) * ray;
                level.pull.at(x, y)[3] = pull;
            }
        });
    }

    Level coarser(const Level& fine) const {
        Level level(fine.width / 2, fine.height / 2);
        forRows(level, [&](int y) {
            for (int x = 0; x < level.width; ++x) {
                Matrix3f& solve = level.solve[level.index(x, y)];
                solve.setZero();
                Eigen::Map<Vector4f> pull(level.pull.at(x, y));
                for (int i = 0; i < 4; ++i) {
                    solve += fine.solve[fine.index(2 * x + i % 2, 2 * y + i / 2)];
                    pull += Eigen::Map<const Vector4f>(fine.pull.at(2 * x + i % 2, 2 * y + i / 2));
                }
                for (int i = 0; i < 2; ++i) {
                    const int row = std::min(2 * y + 2, fine.height - 1);
                    *level.right.at(x, y) +=
                        0.5F * inLine(*fine.right.at(2 * x, 2 * y + i), *fine.right.at(2 * x + 1, 2 * y + i),
                                      *fine.right.at((2 * x + 2) % fine.width, 2 * y + i));
                    *level.down.at(x, y) +=
                        0.5F * inLine(*fine.down.at(2 * x + i, 2 * y), *fine.down.at(2 * x + i, 2 * y + 1),
                                      *fine.down.at(2 * x + i, row));
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
                Eigen::Map<Vector4f> vector(level.vectors.at(x, y));
                if (k + 1 == m_levels.size()) {
                    vector = m_range.usual * level.ray(x, y);
                    *level.even.at(x, y) = m_range.usual;
                } else {
                    vector = Eigen::Map<const Vector4f>(m_levels[k + 1].vectors.at(x / 2, y / 2));
                    *level.even.at(x, y) = *m_levels[k + 1].even.at(x / 2, y / 2);
                }
            }
        });
    }

    /// The ties of a pixel to those on its left and right, above and below.
    static std::array<float, 4> ties(const Level& level, const RowShape& shape, int x, int y) {
        return {shape.across * *level.right.at((x + level.width - 1) % level.width, y),
                shape.across * *level.right.at(x, y), y > 0 ? shape.above * *level.down.at(x, y - 1) : 0,
                y + 1 < level.height ? shape.below * *level.down.at(x, y) : 0};
    }

    void invert(Level& level) {
        forRows(level, [&](int y) {
            const RowShape shape(y, level.height);
            const float area = kPrior * perArea(level) * shape.cosine;
            for (int x = 0; x < level.width; ++x) {
                const auto [left, right, above, below] = ties(level, shape, x, y);
                Matrix3f& solve = level.solve[level.index(x, y)];
                solve.diagonal().array() += left + right + above + below + area;
                solve = solve.cast<double>().inverse().cast<float>().eval();
            }
        });
    }

    /// Solves every second pixel, as on a chess board, for given neighbours.
    void relax(Level& level, int colour) {
        const auto at = [&](int x, int y) { return Eigen::Map<Vector4f>(level.vectors.at(x, y)); };
        const auto even = [&](int x, int y) -> float& { return *level.even.at(x, y); };
        forRows(level, [&](int y) {
            const RowShape shape(y, level.height);
            const float prior = kPrior * perArea(level) * shape.cosine;
            const float pixelRad = 2 * std::numbers::pi_v<float> / static_cast<float>(level.width);
            const float fade = shape.cosine * pixelRad * pixelRad / (kFadeRad * kFadeRad);
            for (int x = (y + colour) % 2; x < level.width; x += 2) {
                const auto [left, right, above, below] = ties(level, shape, x, y);
                const int onLeft = (x + level.width - 1) % level.width;
                const int onRight = (x + 1) % level.width;
                const int higher = std::max(0, y - 1);
                const int lower = std::min(y + 1, level.height - 1);
                const Eigen::Map<const Vector4f> own(level.pull.at(x, y));
                Vector4f pull = own;
                pull += left * at(onLeft, y) + right * at(onRight, y);
                pull += above * at(x, higher) + below * at(x, lower);
                pull += prior * m_range.usual * level.ray(x, y);
                const Matrix3f& solve = level.solve[level.index(x, y)];
                const Vector3f vector =
                    solve.col(0) * pull[0] + solve.col(1) * pull[1] + solve.col(2) * pull[2];
                const float tied = own[3] + left + right + above + below;
                const Vector4f found(vector.x(), vector.y(), vector.z(), pull[3] / (tied + fade));
                at(x, y) += kOverRelaxed * (found - at(x, y));
                const float evenPull = own.dot(level.ray(x, y)) + left * even(onLeft, y) +
                                       right * even(onRight, y) + above * even(x, higher) +
                                       below * even(x, lower) + prior * m_range.usual;
                even(x, y) += kOverRelaxed * (evenPull / (tied + prior) - even(x, y));
            }
        });
    }

    Plane values() const {
        const Level& level = m_levels.front();
        Plane result(level.width, level.height);
        forRows(level, [&](int y) {
            for (int x = 0; x < level.width; ++x) {
                const Eigen::Map<const Vector4f> vector(level.vectors.at(x, y));
                const float value = std::clamp(vector.dot(level.ray(x, y)), m_range.least, m_range.most);
                const float even = std::clamp(*level.even.at(x, y), m_range.least, m_range.most);
                *result.at(x, y) = even + std::clamp(vector[3], 0.0F, 1.0F) * (value - even);
            }
        });
        return result;
    }

    CompletionRange m_range;
    int m_threads;
    std::vector<Level> m_levels;
};

} // namespace

Plane completedByPlanes(const Plane& known, const Plane& weight, const RgbImage& picture,
                        const CompletionRange& range, int threads) {
    return Completion(known, weight, picture, range, threads).run();
}

} // namespace spherewalk::scene
