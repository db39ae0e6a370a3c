// SPDX-License-Identifier: GPL-3.0-or-later
#include "sweep_cost.h"

#include "spherewalk/base/parallel.h"
#include "spherewalk/photo/picture_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>

namespace spherewalk::scene {

void sampleColour(const RgbImage& photo, float u, float v, float* rgb) {
    const int left = std::min(static_cast<int>(u), photo.width() - 1);
    const int right = left + 1 < photo.width() ? left + 1 : 0;
    const int above = std::min(static_cast<int>(v), photo.height() - 1);
    const int below = std::min(above + 1, photo.height() - 1);
    const float across = u - static_cast<float>(left);
    const float down = v - static_cast<float>(above);
    const std::array<const std::uint8_t*, 4> p{photo.at(left, above), photo.at(right, above),
                                               photo.at(left, below), photo.at(right, below)};
    for (int c = 0; c < 3; ++c) {
        const auto upper = static_cast<float>(p[0][c]) + across * static_cast<float>(p[1][c] - p[0][c]);
        const auto lower = static_cast<float>(p[2][c]) + across * static_cast<float>(p[3][c] - p[2][c]);
        rgb[c] = upper + down * (lower - upper);
    }
}

namespace {

/// Finds where a photo shows a row of a frame's directions.
class TurnedRow {
  public:
    TurnedRow(Eigen::Matrix3f photoFromFrame, int width)
        : m_turn(std::move(photoFromFrame)),
          m_angles(width),
          m_u(static_cast<std::size_t>(width)),
          m_v(m_u) {}

    /// photoWidth: in pixels.
    SPHEREWALK_VECTOR_CLONES
    void place(int line, int photoWidth) {
        const std::size_t width = m_u.size();
        const float level = m_angles.cosElevation[static_cast<std::size_t>(line)];
        const Eigen::Vector3f x = level * m_turn.col(0);
        const Eigen::Vector3f y = level * m_turn.col(1);
        const Eigen::Vector3f up = m_angles.sinElevation[static_cast<std::size_t>(line)] * m_turn.col(2);
        for (std::size_t i = 0; i < width; ++i) {
            const float c = m_angles.cosAzimuth[i];
            const float s = m_angles.sinAzimuth[i];
            const FastPixel at = fastPixel(x[0] * c + y[0] * s + up[0], x[1] * c + y[1] * s + up[1],
                                           x[2] * c + y[2] * s + up[2], static_cast<float>(photoWidth));
            m_u[i] = at.u;
            m_v[i] = at.v;
        }
    }

    float u(int x) const { return m_u[static_cast<std::size_t>(x)]; }

    float v(int x) const { return m_v[static_cast<std::size_t>(x)]; }

  private:
    Eigen::Matrix3f m_turn;
    PixelAngles m_angles;
    std::vector<float> m_u;
    std::vector<float> m_v;
};

Image<float, 3> turned(const RgbImage& photo, const Eigen::Matrix3d& photoFromFrame, int width, int threads) {
    Image<float, 3> picture(width, width / 2);
    parallelFor(picture.height(), 32, threads, [&](int begin, int end) {
        TurnedRow row(photoFromFrame.cast<float>(), width);
        for (int y = begin; y < end; ++y) {
            row.place(y, photo.width());
            for (int x = 0; x < width; ++x) {
                sampleColour(photo, row.u(x), row.v(x), picture.at(x, y));
            }
        }
    });
    return picture;
}

/// The values of a plane in another frame, each the nearest one. Shape: as that of a SweepPicture, one column
/// and one row more.
std::vector<float> turned(const Image<float, 1>& plane, const Eigen::Matrix3d& planeFromFrame, int threads) {
    const auto pitch = static_cast<std::size_t>(plane.width()) + 1;
    std::vector<float> result(pitch * (static_cast<std::size_t>(plane.height()) + 1));
    parallelFor(plane.height(), 32, threads, [&](int begin, int end) {
        TurnedRow row(planeFromFrame.cast<float>(), plane.width());
        for (int y = begin; y < end; ++y) {
            row.place(y, plane.width());
            float* out = result.data() + pitch * static_cast<std::size_t>(y);
            for (int x = 0; x < plane.width(); ++x) {
                const int column = nearestInt(row.u(x)) % plane.width();
                const int line = std::min(nearestInt(row.v(x)), plane.height() - 1);
                out[x] = *plane.at(column, line);
            }
            out[plane.width()] = out[0];
        }
    });
    std::copy_n(result.end() - 2 * static_cast<std::ptrdiff_t>(pitch), pitch,
                result.end() - static_cast<std::ptrdiff_t>(pitch));
    return result;
}

void brighten(Image<float, 3>& picture, const Gains& gains) {
    if (gains == Gains{1, 1, 1}) {
        return;
    }
    const std::span<float> values = picture.values();
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = std::min(255.0F, gains[i % 3] * values[i]);
    }
}

float brightnessOf(const float* rgb) {
    return 0.299F * rgb[0] + 0.587F * rgb[1] + 0.114F * rgb[2];
}

} // namespace

SweepPicture::SweepPicture(const RgbImage& photo, const Eigen::Matrix3d& photoFromFrame, int width,
                           int threads, const Gains& gains)
    : m_width(width),
      m_values(4 * static_cast<std::size_t>(width + 1) * static_cast<std::size_t>(width / 2 + 1)) {
    // At twice the width a bilinear sample in the middle of a wanted pixel is about the mean over it.
    Image<float, 3> picture = photo.width() >= 4 * width ? turned(photo::resized(photo, 2 * width, width),
                                                                  photoFromFrame, width, threads)
                                                         : turned(photo, photoFromFrame, width, threads);
    brighten(picture, gains);
    parallelFor(height(), 32, threads, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            differentiate(picture, y);
        }
    });
    repeatEdges();
}

void SweepPicture::differentiate(const Image<float, 3>& picture, int y) {
    const int above = std::max(0, y - 1);
    const int below = std::min(height() - 1, y + 1);
    for (int x = 0; x < m_width; ++x) {
        const float* here = picture.at(x, y);
        const float* right = picture.at((x + 1) % m_width, y);
        const float* left = picture.at((x + m_width - 1) % m_width, y);
        float* out = at(x, y);
        out[0] = brightnessOf(here);
        out[1] = 0.5F * (brightnessOf(right) - brightnessOf(left));
        out[2] = 0.5F * (brightnessOf(picture.at(x, below)) - brightnessOf(picture.at(x, above)));
        out[3] = 0.5F * (here[0] - here[2]);
    }
}

void SweepPicture::repeatEdges() {
    for (int y = 0; y < height(); ++y) {
        std::copy_n(at(0, y), 4, at(m_width, y));
    }
    std::copy_n(at(0, height() - 1), stride(), at(0, height()));
}

namespace {

/// Directions of a row's pixels.
struct RowRays {
    const float* cosAzimuth;
    const float* sinAzimuth;
    float cosElevation;
    float sinElevation;
};

/// The places of the values that a row is interpolated from.
struct RowPlaces {
    std::int32_t* first; ///< Index of the upper left pixel's values.
    float* right;
    float* down;
};

/// NeighbourLenses as numbers, which no store can change.
struct LensNumbers {
    struct Sight {
        float x, y, z;
    };

    explicit LensNumbers(const NeighbourLenses& l)
        : front{l.fromFrontM[0], l.fromFrontM[1], l.fromFrontM[2]},
          back{l.fromBackM[0], l.fromBackM[1], l.fromBackM[2]},
          ahead{l.ahead[0], l.ahead[1], l.ahead[2]},
          aheadM(l.aheadM) {}

    /// From the neighbour's lens to what the photo's ray (x, y, z) shows, not normalised.
    Sight sight(float x, float y, float z, float inverse) const {
        const float dx = x - inverse * (x < 0 ? back.x : front.x);
        const float dy = y - inverse * (x < 0 ? back.y : front.y);
        const float dz = z - inverse * (x < 0 ? back.z : front.z);
        const float along = dx * ahead.x + dy * ahead.y + dz * ahead.z;
        const float moved = inverse * (along < 0 ? -aheadM : aheadM);
        return {dx - moved * ahead.x, dy - moved * ahead.y, dz - moved * ahead.z};
    }

    Sight front;
    Sight back;
    Sight ahead;
    float aheadM;
};

/// Where a neighbour shows a row's pixels.
SPHEREWALK_VECTOR_CLONES
void findPlaces(const RowRays& rays, const float* inverseM, const NeighbourLenses& lenses, int width,
                int stride, const RowPlaces& places) {
    const LensNumbers numbers(lenses); // No store can change the copies.
    const RowRays r = rays;
    std::int32_t* __restrict first = places.first;
    float* __restrict right = places.right;
    float* __restrict down = places.down;
    for (int i = 0; i < width; ++i) {
        const LensNumbers::Sight to = numbers.sight(
            r.cosElevation * r.cosAzimuth[i], r.cosElevation * r.sinAzimuth[i], r.sinElevation, inverseM[i]);
        const FastPixel at = fastPixel(to.x, to.y, to.z, static_cast<float>(width));
        const int column = std::min(static_cast<int>(at.u), width - 1);
        const int line = std::min(static_cast<int>(at.v), width / 2 - 1);
        first[i] = line * stride + 4 * column;
        right[i] = at.u - static_cast<float>(column);
        down[i] = at.v - static_cast<float>(line);
    }
}

using Four = float __attribute__((vector_size(16)));
using Eight = float __attribute__((vector_size(32)));

/// Weighted differences between a pixel's values and interpolated ones. They count up to a limit, since
/// beyond it the neighbour shows something else.
inline Four differences(const float* here, const float* first, int stride, float right, float down) {
    constexpr Four kLimits = {20, 12, 12, 16};
    constexpr Four kWeights = {1, 1.5F, 1.5F, 0.8F};
    Eight upper;
    Eight lower;
    Four own;
    std::memcpy(&upper, first, sizeof upper);
    std::memcpy(&lower, first + stride, sizeof lower);
    std::memcpy(&own, here, sizeof own);
    const Eight values = upper + (lower - upper) * down;
    const Four left = __builtin_shufflevector(values, values, 0, 1, 2, 3);
    const Four beside = __builtin_shufflevector(values, values, 4, 5, 6, 7);
    const Four difference = own - (left + (beside - left) * right);
    const Four size = difference < 0 ? -difference : difference;
    return (size < kLimits ? size : kLimits) * kWeights;
}

/// The sums of four pixels' differences.
inline Four sums(const Four& a, const Four& b, const Four& c, const Four& d) {
    const Four ab = __builtin_shufflevector(a, b, 0, 1, 4, 5) + __builtin_shufflevector(a, b, 2, 3, 6, 7);
    const Four cd = __builtin_shufflevector(c, d, 0, 1, 4, 5) + __builtin_shufflevector(c, d, 2, 3, 6, 7);
    return __builtin_shufflevector(ab, cd, 0, 2, 4, 6) + __builtin_shufflevector(ab, cd, 1, 3, 5, 7);
}

/// Range: width a multiple of 4.
SPHEREWALK_VECTOR_CLONES
void costsAt(const RowPlaces& places, const float* here, const float* picture, int stride, int width,
             float* costs) {
    const RowPlaces p = places;
    for (int x = 0; x < width; x += 4) {
        const auto at = [&](int i) {
            return differences(here + 4 * i, picture + p.first[i], stride, p.right[i], p.down[i]);
        };
        const Four four = sums(at(x), at(x + 1), at(x + 2), at(x + 3));
        std::memcpy(costs + x, &four, sizeof four);
    }
}

/// Sorts each column so far that its smallest `kept` values come first.
SPHEREWALK_VECTOR_CLONES
void sortSmallest(std::vector<std::vector<float>>& rows, std::size_t kept, int width) {
    for (std::size_t i = 0; i < kept; ++i) {
        for (std::size_t j = rows.size() - 1; j > i; --j) {
            float* __restrict a = rows[j - 1].data();
            float* __restrict b = rows[j].data();
            for (int x = 0; x < width; ++x) {
                const float low = a[x] < b[x] ? a[x] : b[x];
                const float high = a[x] < b[x] ? b[x] : a[x];
                a[x] = low;
                b[x] = high;
            }
        }
    }
}

std::size_t keptOf(std::size_t count, double share) {
    return std::max(1UL, static_cast<std::size_t>(std::lround(static_cast<double>(count) * share)));
}

constexpr float kSamePx = 2;        ///< Parallax by which two photos' depths of one thing may differ,
constexpr float kSameShare = 0.03F; ///< and the same as a share of 1 / distance.
constexpr float kSeenThrough = 6;   ///< What a neighbour that sees through a place adds to its cost.
constexpr float kHidden = 10;       ///< What neighbours add from which a place is hidden, if all are.
constexpr float kUnseen = 30;       ///< The cost of a place that no neighbour sees.

/// The neighbour's 1 / distance at the pixels nearest to the places.
void seenAt(const RowPlaces& places, const float* inverseM, int width, float* seen) {
    for (int i = 0; i < width; ++i) {
        const int nearest =
            places.first[i] / 4 + (places.right[i] < 0.5F ? 0 : 1) + (places.down[i] < 0.5F ? 0 : width + 1);
        seen[i] = inverseM[nearest];
    }
}

/// 1 / the distance of each pixel's thing from the neighbour.
SPHEREWALK_VECTOR_CLONES
void expectedAt(const RowRays& rays, const float* inverseM, const NeighbourLenses& lenses, int width,
                float* __restrict expected) {
    const LensNumbers numbers(lenses);
    for (int i = 0; i < width; ++i) {
        const LensNumbers::Sight to =
            numbers.sight(rays.cosElevation * rays.cosAzimuth[i], rays.cosElevation * rays.sinAzimuth[i],
                          rays.sinElevation, inverseM[i]);
        const float squared = to.x * to.x + to.y * to.y + to.z * to.z;
        expected[i] = inverseM[i] / std::sqrt(squared < 1e-6F ? 1e-6F : squared);
    }
}

/// Makes a place that the neighbour cannot see endlessly dear, and one through which it sees dearer.
SPHEREWALK_VECTOR_CLONES
void judge(const float* seen, const float* expected, float pixelM, int width, float* __restrict hidden,
           float* __restrict costs) {
    for (int i = 0; i < width; ++i) {
        const float same = kSamePx * pixelM + kSameShare * expected[i];
        const bool isHidden = seen[i] > expected[i] + same;
        const float through = seen[i] < expected[i] - same ? kSeenThrough : 0.0F;
        costs[i] = isHidden ? HUGE_VALF : costs[i] + through;
        hidden[i] += isHidden ? 1.0F : 0.0F;
    }
}

} // namespace

SweepCost::SweepCost(const PosedPicture& photo, std::span<const PosedPicture> neighbours, double keptShare,
                     int width, int threads, std::span<const Gains> gains,
                     std::span<const Image<float, 1>* const> depths)
    : m_photo(*photo.picture, Eigen::Matrix3d::Identity(), width, threads),
      m_keptShare(keptShare),
      m_kept(keptOf(neighbours.size(), keptShare)),
      m_knowsDepth(!depths.empty()),
      m_angles(width) {
    const Eigen::Quaterniond photoFromRoom = photo.roomFromPhoto.rotation.conjugate();
    for (std::size_t i = 0; i < neighbours.size(); ++i) {
        const PosedPicture& other = neighbours[i];
        const Eigen::Quaterniond otherFromPhoto =
            other.roomFromPhoto.rotation.conjugate() * photo.roomFromPhoto.rotation;
        const Eigen::Vector3d offset =
            photoFromRoom * (other.roomFromPhoto.translation - photo.roomFromPhoto.translation);
        const Eigen::Vector3d front = photo.lenses.place(Eigen::Vector3d::UnitX());
        const Eigen::Matrix3d turn = otherFromPhoto.toRotationMatrix();
        const NeighbourLenses lenses{(offset - front).cast<float>(), (offset + front).cast<float>(),
                                     turn.row(0).transpose().cast<float>(),
                                     static_cast<float>(other.lenses.aheadM),
                                     static_cast<float>(offset.norm())};
        m_neighbours.push_back(
            {SweepPicture(*other.picture, turn, width, threads, gains.empty() ? Gains{1, 1, 1} : gains[i]),
             lenses, m_knowsDepth ? turned(*depths[i], turn, threads) : std::vector<float>()});
    }
}

SweepCost::Scratch::Scratch(const SweepCost& cost)
    : m_first(static_cast<std::size_t>(cost.width())),
      m_right(m_first.size()),
      m_down(m_first.size()),
      m_costs(cost.m_neighbours.size(), std::vector<float>(m_first.size())),
      m_hidden(m_first.size()),
      m_seen(m_first.size()),
      m_expected(m_first.size()) {
}

void SweepCost::neighbourRow(const Neighbour& neighbour, int y, const float* inverseM, Scratch& scratch,
                             float* costs) const {
    const auto row = static_cast<std::size_t>(y);
    const int stride = neighbour.picture.stride();
    const RowPlaces places{scratch.m_first.data(), scratch.m_right.data(), scratch.m_down.data()};
    findPlaces({m_angles.cosAzimuth.data(), m_angles.sinAzimuth.data(), m_angles.cosElevation[row],
                m_angles.sinElevation[row]},
               inverseM, neighbour.lenses, width(), stride, places);
    costsAt(places, m_photo.at(0, y), neighbour.picture.at(0, 0), stride, width(), costs);
    if (m_knowsDepth) {
        judgeByDepth(neighbour, y, inverseM, scratch, costs);
    }
}

/// Follows neighbourRow(), which found the places.
void SweepCost::judgeByDepth(const Neighbour& neighbour, int y, const float* inverseM, Scratch& scratch,
                             float* costs) const {
    const auto row = static_cast<std::size_t>(y);
    const RowRays rays{m_angles.cosAzimuth.data(), m_angles.sinAzimuth.data(), m_angles.cosElevation[row],
                       m_angles.sinElevation[row]};
    const RowPlaces places{scratch.m_first.data(), scratch.m_right.data(), scratch.m_down.data()};
    seenAt(places, neighbour.inverseM.data(), width(), scratch.m_seen.data());
    expectedAt(rays, inverseM, neighbour.lenses, width(), scratch.m_expected.data());
    judge(scratch.m_seen.data(), scratch.m_expected.data(),
          2 * std::numbers::pi_v<float> / static_cast<float>(width()) /
              std::max(1e-3F, neighbour.lenses.apartM),
          width(), scratch.m_hidden.data(), costs);
}

/// The mean over the better neighbours of those that see a place. Range: costs are sorted.
void SweepCost::meanOfSeen(Scratch& scratch, float* costs) const {
    const std::size_t count = m_neighbours.size();
    for (std::size_t x = 0; x < scratch.m_hidden.size(); ++x) {
        const auto seen = count - static_cast<std::size_t>(scratch.m_hidden[x]);
        const std::size_t kept = keptOf(seen, m_keptShare);
        float sum = 0;
        for (std::size_t i = 0; i < kept; ++i) {
            sum += scratch.m_costs[i][x];
        }
        costs[x] = seen == 0 ? kUnseen
                             : sum / static_cast<float>(kept) +
                                   kHidden * scratch.m_hidden[x] / static_cast<float>(count);
    }
}

void SweepCost::row(int y, const float* inverseM, Scratch& scratch, float* costs) const {
    std::fill(scratch.m_hidden.begin(), scratch.m_hidden.end(), 0.0F);
    for (std::size_t i = 0; i < m_neighbours.size(); ++i) {
        neighbourRow(m_neighbours[i], y, inverseM, scratch, scratch.m_costs[i].data());
    }
    sortSmallest(scratch.m_costs, m_kept, width());
    if (m_knowsDepth) {
        meanOfSeen(scratch, costs);
        return;
    }
    const float share = 1 / static_cast<float>(m_kept);
    std::fill_n(costs, width(), 0.0F);
    for (std::size_t i = 0; i < m_kept; ++i) {
        for (int x = 0; x < width(); ++x) {
            costs[x] += share * scratch.m_costs[i][static_cast<std::size_t>(x)];
        }
    }
}

void SweepCost::all(const Image<float, 1>& inverseM, int threads, const std::stop_token& stop,
                    Image<float, 1>& costs) const {
    parallelFor(height(), 16, threads, [&](int begin, int end) {
        throwIfStopped(stop);
        Scratch scratch(*this);
        for (int y = begin; y < end; ++y) {
            row(y, inverseM.at(0, y), scratch, costs.at(0, y));
        }
    });
}

} // namespace spherewalk::scene
