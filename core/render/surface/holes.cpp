// SPDX-License-Identifier: Apache-2.0
#include "surface/coordinates.h"
#include "surface/surface_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

namespace spherewalk::render {

namespace {

/// What was taken from a photo and does not fit into narrow holes.
class NarrowHoles {
  public:
    NarrowHoles(const SurfaceCoordinates& coordinates, std::uint8_t photo, int width, int height)
        : m_coordinates(coordinates), m_photo(photo), m_width(width), m_height(height) {}

    /// Adds the pixels of a cell that do not fit, as places in the buffers.
    void find(int column, int row, std::vector<std::size_t>& misfits) const {
        std::array<Sides, SurfaceCoordinates::kCellPixels> sides;
        for (int i = 0; i < kCell; ++i) {
            addRuns(column * kCell, row * kCell + i, 1, 0, &sides[static_cast<std::size_t>(i) * kCell], 1);
            addRuns(column * kCell + i, row * kCell, 0, 1, &sides[static_cast<std::size_t>(i)], kCell);
        }
        for (std::size_t i = 0; i < sides.size(); ++i) {
            const int x = column * kCell + static_cast<int>(i) % kCell;
            const int y = row * kCell + static_cast<int>(i) / kCell;
            if (isTaken(x, y) && !sides[i].fits(*m_coordinates.inverse.at(x, y))) {
                misfits.push_back(static_cast<std::size_t>(y) *
                                      static_cast<std::size_t>(m_coordinates.inverse.width()) +
                                  static_cast<std::size_t>(x));
            }
        }
    }

  private:
    /// 1 / s to the sides of a hole.
    struct Sides {
        float least = HUGE_VALF;
        float most = 0;      ///< This is 0 where the hole is not narrow.
        bool isTiny = false; ///< Whatever is in the hole, it shows as a speck.

        bool fits(float inverse) const {
            constexpr float kLeastFit = 0.85F;
            constexpr float kMostFit = 1.1F;
            return !isTiny && (most == 0 || (inverse >= kLeastFit * least && inverse <= kMostFit * most));
        }
    };

    bool isInView(int x, int y) const { return x >= 0 && y >= 0 && x < m_width && y < m_height; }

    bool isTaken(int x, int y) const { return isInView(x, y) && *m_coordinates.source.at(x, y) == m_photo; }

    bool isSide(int x, int y) const {
        return isInView(x, y) && !isTaken(x, y) && *m_coordinates.inverse.at(x, y) > 0;
    }

    /// The steps to the side of a hole, or beyond the view.
    int stepsToSide(int x, int y, int right, int down) const {
        int steps = 1;
        while (steps < kReach && isInView(x + steps * right, y + steps * down) &&
               !isSide(x + steps * right, y + steps * down)) {
            ++steps;
        }
        return steps;
    }

    /// Tells what was taken in a row or a column of a cell, from its first pixel on, the sides of its holes.
    void addRuns(int x, int y, int right, int down, Sides* sides, int pitch) const {
        for (int i = 0; i < kCell; ++i) {
            const int atX = x + i * right;
            const int atY = y + i * down;
            if (!isTaken(atX, atY)) {
                continue;
            }
            const int before = stepsToSide(atX, atY, -right, -down);
            const int after = stepsToSide(atX, atY, right, down);
            const int end = std::min(kCell, i + after);
            if (before + after <= kReach && isSide(atX - before * right, atY - before * down) &&
                isSide(atX + after * right, atY + after * down)) {
                const float one = *m_coordinates.inverse.at(atX - before * right, atY - before * down);
                const float other = *m_coordinates.inverse.at(atX + after * right, atY + after * down);
                for (int k = i; k < end; ++k) {
                    Sides& at = sides[std::ptrdiff_t{k} * pitch];
                    at.least = std::min(at.least, std::min(one, other));
                    at.most = std::max(at.most, std::max(one, other));
                    at.isTiny = at.isTiny || before + after - 1 <= kTiny;
                }
            }
            i = end - 1;
        }
    }

    static constexpr int kReach = 32;
    static constexpr int kTiny = 8; ///< Width of a hole, pixels.

    const SurfaceCoordinates& m_coordinates;
    std::uint8_t m_photo;
    int m_width;
    int m_height;
};

constexpr int kFarthestPx = 96;
constexpr int kNoEnd = kFarthestPx + 1; ///< The steps to an end that is too far or beyond the picture.
/// Ends that are so many times farther than both sides of a hole have no say.
constexpr int kFarther = 4;
/// One worker fills so many rows in turn: a pixel's end above is that of the pixel above.
constexpr int kFillRows = 16;

struct Direction {
    int right, down;
};

/// Opposite directions follow each other, the one that goes on in the picture first.
constexpr std::array<Direction, 8> kDirections{
    {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {-1, 1}, {1, -1}}};
constexpr std::size_t kRight = 0;
constexpr std::size_t kLeft = 1;

/// What lies at the end of a hole in one direction.
struct End {
    const std::uint8_t* colour = nullptr;
    float inverse = 0;
    float distance = 0;
    int steps = kNoEnd;
};

/// Fills some rows one after the other. Known pixels are only read, and the others only written.
class Filler {
  public:
    Filler(const MaskImage& known, const InverseBuffer& inverse, RgbImage& picture)
        : m_known(known), m_inverse(inverse), m_picture(picture) {
        for (std::size_t i = kLeft; i < kDirections.size(); i += 2) {
            m_above[i].resize(static_cast<std::size_t>(picture.width()));
            m_own[i].resize(m_above[i].size());
        }
    }

    void fillRow(int y) {
        const std::uint8_t* begin = m_known.at(0, y);
        const std::uint8_t* end = begin + m_picture.width();
        const auto holeFrom = [&](const std::uint8_t* at) {
            const void* hole =
                std::memchr(at, static_cast<int>(Known::Nothing), static_cast<std::size_t>(end - at));
            return static_cast<const std::uint8_t*>(hole);
        };
        m_toRight = 0;
        for (const std::uint8_t* hole = holeFrom(begin); hole != nullptr; hole = holeFrom(hole + 1)) {
            const int x = static_cast<int>(hole - begin);
            fill(x, y, m_picture.at(x, y));
        }
        m_above.swap(m_own);
        m_hasAbove = true;
    }

  private:
    bool is(Known what, int x, int y) const { return *m_known.at(x, y) == static_cast<std::uint8_t>(what); }

    /// The colour of a pixel that is not known. It stays if no direction leads to a known one.
    void fill(int x, int y, std::uint8_t* out) {
        std::array<End, kDirections.size()> ends;
        int farthest = kFarthestPx;
        for (std::size_t i = 0; i < ends.size(); i += 2) {
            const int back = m_own[i + 1][static_cast<std::size_t>(x)] =
                static_cast<std::uint8_t>(stepsBack(x, y, i + 1));
            const int on = i == kRight ? stepsRight(x, y) : steps(x, y, i, farthest);
            ends[i] = end(x, y, i, on, farthest);
            ends[i + 1] = end(x, y, i + 1, back, farthest);
            if (ends[i].colour != nullptr && ends[i + 1].colour != nullptr) {
                farthest = std::min(farthest, kFarther * std::max(ends[i].steps, ends[i + 1].steps));
            }
        }
        mix(ends, farthest, out);
    }

    static void mix(std::array<End, kDirections.size()>& ends, int farthest, std::uint8_t* out) {
        float least = HUGE_VALF;
        for (End& at : ends) {
            if (at.steps > farthest) {
                at.colour = nullptr;
            }
            least = at.colour != nullptr ? std::min(least, at.inverse) : least;
        }
        std::array<float, 3> sum{};
        float total = 0;
        for (const End& at : ends) {
            if (at.colour == nullptr) {
                continue;
            }
            const float farness = least / at.inverse;
            const float cube = farness * farness * farness;
            const float weight = cube * cube / (at.distance * at.distance);
            total += weight;
            for (std::size_t channel = 0; channel < 3; ++channel) {
                sum[channel] += weight * at.colour[channel];
            }
        }
        for (std::size_t channel = 0; channel < 3 && total > 0; ++channel) {
            out[channel] = static_cast<std::uint8_t>(sum[channel] / total + 0.5F);
        }
    }

    /// The steps to the nearest known pixel in a direction; kNoEnd if it is farther than `farthest`.
    int steps(int x, int y, std::size_t direction, int farthest) const {
        const auto [right, down] = kDirections[direction];
        const auto toBorder = [](int at, int step, int count) {
            return step > 0 ? count - 1 - at : step < 0 ? at : kFarthestPx;
        };
        const int most = std::min(
            {farthest, toBorder(x, right, m_picture.width()), toBorder(y, down, m_picture.height())});
        const std::ptrdiff_t stride = std::ptrdiff_t{down} * m_known.width() + right;
        const std::uint8_t* known = m_known.at(x, y);
        for (int step = 1; step <= most; ++step) {
            if (known[step * stride] == static_cast<std::uint8_t>(Known::Seen)) {
                return step;
            }
        }
        return kNoEnd;
    }

    /// The same in a direction from which rows come, and as far as any: the pixel before it is one nearer.
    int stepsBack(int x, int y, std::size_t direction) const {
        const int beforeX = x + kDirections[direction].right;
        const int beforeY = y + kDirections[direction].down;
        if (beforeX < 0 || beforeX >= m_picture.width() || beforeY < 0) {
            return kNoEnd;
        }
        if (is(Known::Seen, beforeX, beforeY)) {
            return 1;
        }
        if (!is(Known::Nothing, beforeX, beforeY) || (direction != kLeft && !m_hasAbove)) {
            return steps(x, y, direction, kFarthestPx);
        }
        const auto& before = direction == kLeft ? m_own[direction] : m_above[direction];
        return std::min(before[static_cast<std::size_t>(beforeX)] + 1, kNoEnd);
    }

    /// The same to the right: the known pixel is that of the pixel before, until the hole ends.
    int stepsRight(int x, int y) {
        if (m_toRight <= x) {
            const int found = steps(x, y, kRight, kFarthestPx);
            if (found == kNoEnd) {
                return kNoEnd;
            }
            m_toRight = x + found;
        }
        return m_toRight - x;
    }

    End end(int x, int y, std::size_t direction, int steps, int farthest) const {
        if (steps > farthest) {
            return {};
        }
        const auto [right, down] = kDirections[direction];
        const int atX = x + steps * right;
        const int atY = y + steps * down;
        const float length = right != 0 && down != 0 ? 1.41421356F : 1;
        return {m_picture.at(atX, atY), *m_inverse.at(atX, atY), length * static_cast<float>(steps), steps};
    }

    using Steps = std::array<std::vector<std::uint8_t>, kDirections.size()>;

    const MaskImage& m_known;
    const InverseBuffer& m_inverse;
    RgbImage& m_picture;
    Steps m_above; ///< The steps of holes of the row above, in the directions from which rows come.
    Steps m_own;   ///< The same for this row.
    bool m_hasAbove = false;
    int m_toRight = 0; ///< The known pixel that is next on the right of the last hole of this row.
};

} // namespace

void SurfaceCoordinates::reopenNarrow(std::uint8_t photo, int width, int height, WorkerPool& pool,
                                      int threads) {
    const NarrowHoles holes(*this, photo, width, height);
    std::vector<std::vector<std::size_t>> misfits(static_cast<std::size_t>(rows()));
    pool.run(rows(), threads, [&](int row, int) {
        for (int column = 0; column < columns(); ++column) {
            if ((sources[index(column, row)] >> photo & 1U) != 0) {
                holes.find(column, row, misfits[static_cast<std::size_t>(row)]);
            }
        }
    });
    for (const std::vector<std::size_t>& ofRow : misfits) {
        for (const std::size_t at : ofRow) {
            inverse.values()[at] = 0;
            source.values()[at] = 0;
        }
    }
}

void fillSoftly(const MaskImage& known, const InverseBuffer& inverse, WorkerPool& pool, int threads,
                RgbImage& picture) {
    pool.run((picture.height() + kFillRows - 1) / kFillRows, threads, [&](int band, int) {
        Filler filler(known, inverse, picture);
        for (int y = band * kFillRows; y < std::min((band + 1) * kFillRows, picture.height()); ++y) {
            filler.fillRow(y);
        }
    });
}

} // namespace spherewalk::render
