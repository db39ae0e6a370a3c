// SPDX-License-Identifier: Apache-2.0
#include "surface/surface_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace spherewalk::render {

namespace {

/// Distances that differ by so much, as a share of 1 / distance, are not of one thing.
constexpr float kOther = 0.06F;
/// Photos that are nearer to the camera than this count alike.
constexpr double kNearestM = 0.002;

constexpr float kLeast = 1e-30F; ///< Less than any photo's weight.

// Loops over the pixels of a row. Their arrays are not the same, so that the loops run several pixels at a
// time.

void keepFirst(const float* __restrict seen, float* __restrict first, std::size_t count) {
    for (std::size_t x = 0; x < count; ++x) {
        first[x] = seen[x] > 0 ? seen[x] : first[x];
    }
}

/// The weights of a photo, and their sums. own: that of the photo.
void weigh(const float* __restrict seen, const float* __restrict first, float own, float* __restrict weights,
           float* __restrict total, float* __restrict sum, std::size_t count) {
    for (std::size_t x = 0; x < count; ++x) {
        const float apart = (seen[x] - first[x]) / (kOther * std::max(first[x], seen[x]) + kLeast);
        const float alike = std::max(0.0F, 1 - apart * apart);
        const float weight = seen[x] > 0 ? own * alike : 0;
        weights[x] = weight;
        total[x] += weight;
        sum[x] += weight * seen[x];
    }
}

/// sums become means, and totals the factors that make weights add up to 255.
void divide(float* __restrict total, const float* __restrict sum, float* __restrict mean, std::size_t count) {
    for (std::size_t x = 0; x < count; ++x) {
        const float factor = 1 / std::max(total[x], kLeast);
        mean[x] = sum[x] * factor;
        total[x] = 255 * factor;
    }
}

/// What a photo gets of what is left of 255.
void share(const float* __restrict weights, const float* __restrict factors, std::uint8_t* __restrict left,
           std::uint8_t* __restrict shares, std::size_t count) {
    for (std::size_t x = 0; x < count; ++x) {
        const int wanted = static_cast<int>(weights[x] * factors[x] + 0.5F);
        const int given = std::min<int>(wanted, left[x]);
        shares[x] = static_cast<std::uint8_t>(given);
        left[x] = static_cast<std::uint8_t>(left[x] - given);
    }
}

/// The weights of a photo's colours, and their sums.
void weighColours(const std::uint8_t* __restrict shares, const std::uint8_t* __restrict looked,
                  float* __restrict weights, float* __restrict totals, std::size_t count) {
    for (std::size_t x = 0; x < count; ++x) {
        weights[x] = static_cast<float>(shares[x] * looked[x]);
        totals[x] += weights[x];
    }
}

/// Adds a photo's colours. parts: in 255 parts of each pixel.
void addColours(const std::uint8_t* __restrict parts, const std::uint8_t* __restrict colours,
                std::uint16_t* __restrict sums, std::uint8_t* __restrict triples, std::size_t count) {
    for (std::size_t x = 0; x < count; ++x) {
        triples[3 * x] = triples[3 * x + 1] = triples[3 * x + 2] = parts[x];
    }
    for (std::size_t k = 0; k < 3 * count; ++k) {
        sums[k] = static_cast<std::uint16_t>(sums[k] + triples[k] * colours[k]);
    }
}

/// Divides by 255. Range: sums up to 65279.
void divideColours(const std::uint16_t* __restrict sums, std::uint8_t* __restrict colours,
                   std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) {
        const int rounded = sums[k] + 1;
        colours[k] = static_cast<std::uint8_t>((rounded + (rounded >> 8)) >> 8);
    }
}

/// Fuses rows of pixels.
class RowFusion {
  public:
    RowFusion(std::span<const DepthWitness> witnesses, int width)
        : m_witnesses(witnesses),
          m_first(static_cast<std::size_t>(width)),
          m_total(m_first.size()),
          m_sum(m_first.size()),
          m_left(m_first.size()),
          m_weights(witnesses.size(), std::vector<float>(m_first.size())) {}

    /// Writes the row's 1 / s and the photos' shares.
    void fuse(int y, float* inverse) {
        const std::size_t width = m_first.size();
        std::fill(m_first.begin(), m_first.end(), 0.0F);
        std::fill(m_total.begin(), m_total.end(), 0.0F);
        std::fill(m_sum.begin(), m_sum.end(), 0.0F);
        std::fill(m_left.begin(), m_left.end(), std::uint8_t{255});
        for (std::size_t i = m_witnesses.size(); i-- > 0;) {
            keepFirst(m_witnesses[i].seen->at(0, y), m_first.data(), width);
        }
        for (std::size_t i = 0; i < m_witnesses.size(); ++i) {
            const double offset = m_witnesses[i].offsetM;
            const auto own = static_cast<float>(1 / (offset * offset + kNearestM * kNearestM));
            weigh(m_witnesses[i].seen->at(0, y), m_first.data(), own, m_weights[i].data(), m_total.data(),
                  m_sum.data(), width);
        }
        divide(m_total.data(), m_sum.data(), inverse, width);
        for (std::size_t i = m_witnesses.size(); i-- > 1;) {
            share(m_weights[i].data(), m_total.data(), m_left.data(), m_witnesses[i].share->at(0, y), width);
        }
        std::copy(m_left.begin(), m_left.end(), m_witnesses[0].share->at(0, y));
    }

  private:
    std::span<const DepthWitness> m_witnesses;
    std::vector<float> m_first; ///< What the first photo says that sees anything.
    std::vector<float> m_total;
    std::vector<float> m_sum;
    std::vector<std::uint8_t> m_left;
    std::vector<std::vector<float>> m_weights;
};

constexpr int kFarthestPx = 96;
constexpr std::array<std::pair<int, int>, 8> kDirections{
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

/// What lies at the end of a hole in one direction.
struct End {
    const std::uint8_t* colour = nullptr;
    float inverse = 0;
    float distance = 0;
};

class Filler {
  public:
    Filler(const MaskImage& known, const InverseBuffer& inverse, const RgbImage& picture)
        : m_known(known), m_inverse(inverse), m_picture(picture) {}

    /// The colour of a pixel that is not known; nothing if no direction leads to a known one.
    bool fill(int x, int y, std::uint8_t* out) const {
        std::array<End, kDirections.size()> ends;
        float least = HUGE_VALF;
        for (std::size_t i = 0; i < ends.size(); ++i) {
            ends[i] = end(x, y, kDirections[i]);
            if (ends[i].colour != nullptr) {
                least = std::min(least, ends[i].inverse);
            }
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
    End end(int x, int y, std::pair<int, int> direction) const {
        for (int step = 1; step <= kFarthestPx; ++step) {
            const int atX = x + step * direction.first;
            const int atY = y + step * direction.second;
            if (atX < 0 || atY < 0 || atX >= m_picture.width() || atY >= m_picture.height()) {
                return {};
            }
            if (*m_known.at(atX, atY) != 0 && *m_inverse.at(atX, atY) > 0) {
                const float length = direction.first != 0 && direction.second != 0 ? 1.41421356F : 1;
                return {m_picture.at(atX, atY), *m_inverse.at(atX, atY), length * static_cast<float>(step)};
            }
        }
        return {};
    }

    const MaskImage& m_known;
    const InverseBuffer& m_inverse;
    const RgbImage& m_picture;
};

} // namespace

void fuseDepths(std::span<const DepthWitness> witnesses, int width, int height, WorkerPool& pool, int threads,
                InverseBuffer& inverse) {
    fit(inverse, width, height);
    for (const DepthWitness& witness : witnesses) {
        if (witness.share->width() != inverse.width() || witness.share->height() != inverse.height()) {
            *witness.share = MaskImage(inverse.width(), inverse.height());
        }
    }
    pool.run(inverse.height() / kCell, threads, [&](int row, int) {
        RowFusion fusion(witnesses, width);
        for (int y = row * kCell; y < (row + 1) * kCell; ++y) {
            const int end = y < height ? width : 0;
            if (end > 0) {
                fusion.fuse(y, inverse.at(0, y));
            }
            std::fill(inverse.at(0, y) + end, inverse.at(0, y) + inverse.width(), 1.0F); // beyond the view
            for (const DepthWitness& witness : witnesses) {
                std::fill(witness.share->at(0, y) + end, witness.share->at(0, y) + inverse.width(),
                          std::uint8_t{0});
            }
        }
    });
}

void fillSoftly(const MaskImage& known, const InverseBuffer& inverse, WorkerPool& pool, int threads,
                RgbImage& picture) {
    // Only known pixels are read and only the others are written, so rows may be filled in any order.
    const Filler filler(known, inverse, picture);
    pool.run(picture.height(), threads, [&](int y, int) {
        const std::uint8_t* row = known.at(0, y);
        const std::uint8_t* end = row + picture.width();
        for (const std::uint8_t* hole = std::find(row, end, 0); hole != end;
             hole = std::find(hole + 1, end, 0)) {
            const int x = static_cast<int>(hole - row);
            filler.fill(x, y, picture.at(x, y));
        }
    });
}

std::vector<TileSet> BlendedView::prepare(const PixelRays& rays, const Rigid3& roomFromCamera,
                                          std::span<const SurfacePhoto> photos, double usualDistanceM,
                                          int samplesPerAxis, WorkerPool& pool, int threads) {
    m_photos = photos.size();
    m_layers.resize(std::max(m_layers.size(), m_photos));
    const CameraModel& camera = rays.camera();
    OpenCells open(camera.width(), camera.height());
    std::vector<DepthWitness> witnesses;
    for (std::size_t i = 0; i < m_photos; ++i) {
        Layer& layer = m_layers[i];
        layer.mesh = photos[i].mesh;
        layer.photo = photos[i].grid.photo();
        const Rigid3 cameraFromPhoto = between(roomFromCamera, photos[i].roomFromPhoto);
        m_raster.draw(*layer.mesh, cameraFromPhoto, camera, open, SurfaceView::kTolerancePx, pool, threads,
                      layer.seen);
        witnesses.push_back({cameraFromPhoto.translation.norm(), &layer.seen, &layer.share});
    }
    fuseDepths(witnesses, camera.width(), camera.height(), pool, threads, m_inverse);
    const int uncovered = open.update(m_layers.front().seen, pool, threads);
    m_filledShare = uncovered / (static_cast<double>(camera.width()) * camera.height());
    open.update(m_inverse, pool, threads);
    std::vector<TileSet> needs;
    for (std::size_t i = 0; i < m_photos; ++i) {
        needs.push_back(m_layers[i].view.prepareKnown(rays, roomFromCamera, photos[i],
                                                      {m_inverse, open, m_layers[i].share}, usualDistanceM,
                                                      samplesPerAxis, pool, threads));
    }
    return needs;
}

void BlendedView::sample(const PixelRays& rays, std::span<const PlaneView> planes, Sampling sampling,
                         WorkerPool& pool, int threads, RgbImage& picture) {
    const int width = rays.camera().width();
    const int height = rays.camera().height();
    if (picture.width() != width || picture.height() != height) {
        picture = RgbImage(width, height);
    }
    if (m_known.width() != width || m_known.height() != height) {
        m_known = MaskImage(width, height);
    }
    for (std::size_t i = 0; i < m_photos; ++i) {
        m_layers[i].view.sample(rays, planes.subspan(i, 1), sampling, pool, threads, m_layers[i].picture);
    }
    pool.run(height, threads, [&](int y, int) { mixRow(y, picture); });
    fillSoftly(m_known, m_inverse, pool, threads, picture);
}

/// Mixes a row of the photos' pictures.
void BlendedView::mixRow(int y, RgbImage& picture) {
    constexpr float kLeastWeight = 2 * 255; // a pixel of a rim alone is not known
    const auto width = static_cast<std::size_t>(picture.width());
    std::vector<std::uint8_t> looked(width);
    std::vector<float> factors(width);
    std::vector<std::vector<float>> weights(m_photos, std::vector<float>(width));
    for (std::size_t i = 0; i < m_photos; ++i) {
        const Layer& layer = m_layers[i];
        layer.view.look(layer.mesh->colourWeights(), layer.photo, y, looked);
        weighColours(layer.share.at(0, y), looked.data(), weights[i].data(), factors.data(), width);
    }
    const float* inverse = m_inverse.at(0, y);
    std::uint8_t* known = m_known.at(0, y);
    for (std::size_t x = 0; x < width; ++x) {
        known[x] = inverse[x] > 0 && factors[x] >= kLeastWeight ? 1 : 0;
        factors[x] = 255 / std::max(1.0F, factors[x]);
    }
    std::vector<std::uint8_t> left(width, 255); // what later photos left to the first
    std::vector<std::uint8_t> triples(3 * width);
    std::vector<std::uint16_t> sums(3 * width, 127);
    for (std::size_t i = m_photos; i-- > 1;) {
        share(weights[i].data(), factors.data(), left.data(), looked.data(), width);
        addColours(looked.data(), m_layers[i].picture.at(0, y), sums.data(), triples.data(), width);
    }
    addColours(left.data(), m_layers[0].picture.at(0, y), sums.data(), triples.data(), width);
    divideColours(sums.data(), picture.at(0, y), 3 * width);
}

} // namespace spherewalk::render
