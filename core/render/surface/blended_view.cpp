// SPDX-License-Identifier: Apache-2.0
#include "pixels/sampler.h"
#include "surface/surface_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <utility>

namespace spherewalk::render {

namespace {

constexpr int kFarthestPx = 96;
/// Ends that are so many times farther than both sides of a hole have no say.
constexpr int kFarther = 4;
/// Opposite directions follow each other.
constexpr std::array<std::pair<int, int>, 8> kDirections{
    {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {-1, 1}, {1, -1}}};

/// What lies at the end of a hole in one direction.
struct End {
    const std::uint8_t* colour = nullptr;
    float inverse = 0;
    float distance = 0;
    int steps = 0;
};

class Filler {
  public:
    Filler(const MaskImage& known, const InverseBuffer& inverse, const RgbImage& picture)
        : m_known(known), m_inverse(inverse), m_picture(picture) {}

    /// The colour of a pixel that is not known; nothing if no direction leads to a known one.
    bool fill(int x, int y, std::uint8_t* out) const {
        std::array<End, kDirections.size()> ends;
        int farthest = kFarthestPx;
        for (std::size_t i = 0; i < ends.size(); i += 2) {
            End& one = ends[i] = end(x, y, kDirections[i], farthest);
            End& opposite = ends[i + 1] = end(x, y, kDirections[i + 1], farthest);
            if (one.colour != nullptr && opposite.colour != nullptr) {
                farthest = std::min(farthest, kFarther * std::max(one.steps, opposite.steps));
            }
        }
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
        return total > 0;
    }

  private:
    End end(int x, int y, std::pair<int, int> direction, int farthest) const {
        const auto [right, down] = direction;
        const auto toBorder = [](int at, int step, int count) {
            return step > 0 ? count - 1 - at : step < 0 ? at : kFarthestPx;
        };
        const int steps = std::min(
            {farthest, toBorder(x, right, m_picture.width()), toBorder(y, down, m_picture.height())});
        const std::ptrdiff_t stride = std::ptrdiff_t{down} * m_known.width() + right;
        const std::uint8_t* known = m_known.at(x, y);
        for (int step = 1; step <= steps; ++step) {
            if (known[step * stride] == static_cast<std::uint8_t>(Known::Seen)) {
                const int atX = x + step * right;
                const int atY = y + step * down;
                const float length = right != 0 && down != 0 ? 1.41421356F : 1;
                return {m_picture.at(atX, atY), *m_inverse.at(atX, atY), length * static_cast<float>(step),
                        step};
            }
        }
        return {};
    }

    const MaskImage& m_known;
    const InverseBuffer& m_inverse;
    const RgbImage& m_picture;
};

} // namespace

void fillSoftly(const MaskImage& known, const InverseBuffer& inverse, WorkerPool& pool, int threads,
                RgbImage& picture) {
    // Only known pixels are read and only the others are written, so rows may be filled in any order.
    const Filler filler(known, inverse, picture);
    pool.run(picture.height(), threads, [&](int y, int) {
        const std::uint8_t* begin = known.at(0, y);
        const std::uint8_t* end = begin + picture.width();
        const auto holeFrom = [&](const std::uint8_t* at) {
            const void* hole =
                std::memchr(at, static_cast<int>(Known::Nothing), static_cast<std::size_t>(end - at));
            return static_cast<const std::uint8_t*>(hole);
        };
        for (const std::uint8_t* hole = holeFrom(begin); hole != nullptr; hole = holeFrom(hole + 1)) {
            const int x = static_cast<int>(hole - begin);
            filler.fill(x, y, picture.at(x, y));
        }
    });
}

/// Tells holes from what is seen, before holes get distances.
void SurfaceView::markHoles(WorkerPool& pool, int threads) {
    if (m_known.width() != m_coordinates.source.width() ||
        m_known.height() != m_coordinates.source.height()) {
        m_known = MaskImage(m_coordinates.source.width(), m_coordinates.source.height());
    }
    pool.run(m_coordinates.rows(), threads, [&](int row, int) {
        const auto width = static_cast<std::size_t>(m_known.width());
        std::fill_n(m_known.at(0, row * kCell), kCell * width, static_cast<std::uint8_t>(Known::Seen));
        for (int column = 0; column < m_coordinates.columns(); ++column) {
            for (int y = row * kCell; y < (row + 1) * kCell && m_open.isOpen(column, row); ++y) {
                const float* inverse = m_coordinates.inverse.at(column * kCell, y);
                std::uint8_t* known = m_known.at(column * kCell, y);
                for (int x = 0; x < kCell; ++x) {
                    known[x] = static_cast<std::uint8_t>(inverse[x] > 0 ? Known::Seen : Known::Nothing);
                }
            }
        }
    });
}

/// Samples the second photo in all of a cell.
void SurfaceView::sampleMixed(const Cell& at, const PlaneView& plane, Sampling sampling,
                              SampleSpace& space) const {
    const std::size_t cell = m_coordinates.index(at.column, at.row);
    const std::size_t first = cell * SurfaceCoordinates::kCellPixels;
    fillPlaces(cell, 1, plane, sampling,
               {m_coordinates.mixedU.data() + first, m_coordinates.mixedV.data() + first, kCell}, space);
    simd::sample(plane, sampling,
                 {space.places.data(), space.fractions.data(), m_samples, space.colours.data(),
                  std::ptrdiff_t{3} * kCell, kCell, kCell, true});
    m_drawn[1].brighten(space.colours.data(), SurfaceCoordinates::kCellPixels);
}

/// Looks up the colour weights of a cell's pixels in a photo. u, v: their coordinates.
void SurfaceView::look(const Drawn& drawn, const std::int32_t* u, const std::int32_t* v, CellBytes& weights) {
    const MaskImage& mask = drawn.mesh->colourWeights();
    const simd::MaskPlacing placing{(PlaneLayout::kGuard - 0.5F) * kFixedOne,
                                    static_cast<float>(mask.width()) / static_cast<float>(drawn.size.width) /
                                        kFixedOne,
                                    mask.width(), mask.height()};
    std::array<std::int32_t, SurfaceCoordinates::kCellPixels> places;
    simd::placeInMask(placing, u, v, places.data());
    const std::uint8_t* values = mask.values().data();
    for (std::size_t i = 0; i < weights.size(); ++i) {
        weights[i] = values[places[i]];
    }
}

/// Lets the rims of things count little in a cell. What shows only rims is not known. shares: those of the
/// second photo.
void SurfaceView::weighRims(const Cell& at, CellBytes& shares) {
    const std::size_t cell = m_coordinates.index(at.column, at.row);
    const std::size_t first = cell * SurfaceCoordinates::kCellPixels;
    const std::uint32_t sources = m_coordinates.sources[cell];
    CellBytes own{};
    CellBytes looked{};
    for (std::size_t i = 0; i < m_drawn.size(); ++i) {
        if ((sources >> i & 1U) == 0) {
            continue;
        }
        look(m_drawn[i], m_coordinates.u.data() + first, m_coordinates.v.data() + first,
             i == 0 ? own : looked);
        for (int y = 0; y < kCell && i > 0; ++y) {
            const std::uint8_t* source = m_coordinates.source.at(at.column * kCell, at.row * kCell + y);
            for (std::size_t x = 0; x < kCell; ++x) {
                std::uint8_t& weight = own[static_cast<std::size_t>(y) * kCell + x];
                weight = source[x] == i ? looked[static_cast<std::size_t>(y) * kCell + x] : weight;
            }
        }
    }
    if ((sources & SurfaceCoordinates::kMixed) != 0) {
        look(m_drawn[1], m_coordinates.mixedU.data() + first, m_coordinates.mixedV.data() + first, looked);
    }
    simd::weighShares(own.data(), looked.data(), static_cast<std::uint8_t>(Known::Nothing), m_known.width(),
                      shares.data(), m_known.at(at.column * kCell, at.row * kCell));
}

/// Mixes the second photo into a cell, whose first photo is sampled.
void SurfaceView::mix(const Cell& at, std::span<const PlaneView> planes, Sampling sampling,
                      SampleSpace& space, RgbImage& picture) {
    const std::uint32_t sources = m_coordinates.sources[m_coordinates.index(at.column, at.row)];
    const int left = at.column * kCell;
    const int top = at.row * kCell;
    CellBytes shares{};
    for (int y = 0; y < kCell && (sources & SurfaceCoordinates::kMixed) != 0; ++y) {
        std::copy_n(m_coordinates.share.at(left, top + y), kCell, shares.begin() + y * kCell);
    }
    if ((sources & SurfaceCoordinates::kRims) != 0) {
        weighRims(at, shares);
    }
    if ((sources & SurfaceCoordinates::kMixed) != 0) {
        sampleMixed(at, planes[1], sampling, space);
        for (int y = 0; y < at.height; ++y) {
            std::array<std::uint8_t, std::size_t{3} * kCell> row;
            std::uint8_t* pixels = picture.at(left, top + y);
            const bool isWhole = at.width == kCell;
            if (!isWhole) {
                std::copy_n(pixels, 3 * at.width, row.begin());
            }
            simd::mixColours(space.colours.data() + std::ptrdiff_t{3} * kCell * y,
                             shares.data() + std::ptrdiff_t{kCell} * y, isWhole ? pixels : row.data());
            if (!isWhole) {
                std::copy_n(row.begin(), 3 * at.width, pixels);
            }
        }
    }
    for (int y = 0; y < at.height && (sources & SurfaceCoordinates::kBlind) != 0; ++y) {
        for (int x = 0; x < at.width; ++x) {
            if (*m_coordinates.source.at(left + x, top + y) == SurfaceCoordinates::kUnseen) {
                std::fill_n(picture.at(left + x, top + y), 3, std::uint8_t{0});
                *m_known.at(left + x, top + y) = static_cast<std::uint8_t>(Known::Outside);
            }
        }
    }
}

} // namespace spherewalk::render
