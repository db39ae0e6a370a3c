// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/render/overlay.h"

#include "layers/layer_rows.h"
#include "layers/overlay_layer.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/recently_used.h"
#include "spherewalk/base/text.h"
#include "spherewalk/render/colour_correction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace spherewalk::render {

namespace {

constexpr std::size_t kMapsKept = 8;
constexpr std::uint8_t kHalf = 128; ///< From here on a pixel shows an object rather than the room.

[[noreturn]] void refuseOverlay(const std::string& what, const std::string& why) {
    throw Error(ErrorKind::InvalidInput, text(what, " cannot be laid into the view: ", why));
}

template <class Picture>
void checkPictureSize(const std::string& what, std::string_view whose, const Picture& picture,
                      const CameraIntrinsics& camera) {
    if (picture.width() != camera.width || picture.height() != camera.height) {
        refuseOverlay(what, text(whose, " has ", picture.width(), " x ", picture.height(),
                                 " pixels, the camera ", camera.width, " x ", camera.height, "."));
    }
}

void checkShadow(const Overlay& overlay, const std::string& what) {
    checkPictureSize(what, "its shadow", overlay.shadow, overlay.camera);
    const std::span<const float> values = overlay.shadow.values();
    const auto bad =
        std::find_if(values.begin(), values.end(), [](float value) { return !(value >= 0 && value <= 1); });
    if (bad != values.end()) {
        const auto at = static_cast<int>(bad - values.begin());
        refuseOverlay(what, text("its shadow is ", *bad, " in the pixel (", at % overlay.camera.width, ", ",
                                 at / overlay.camera.width, "); it must be from 0, no light, to 1."));
    }
}

void checkOverlay(const Overlay& overlay, const std::string& what) {
    try {
        overlay.camera.validate();
    } catch (const Error& error) {
        refuseOverlay(what, error.sentence());
    }
    checkPictureSize(what, "its picture", overlay.picture, overlay.camera);
    checkPictureSize(what, "its depth", overlay.depth, overlay.camera);
    if (!overlay.roomDepth.empty()) {
        checkPictureSize(what, "its room's depth", overlay.roomDepth, overlay.camera);
    }
    if (!overlay.labels.empty()) {
        checkPictureSize(what, "its labels' picture", overlay.labels, overlay.camera);
    }
    if (!overlay.shadow.empty()) {
        checkShadow(overlay, what);
    }
}

void checkOptions(const ComposeOptions& options) {
    for (const double tolerance : {options.toleranceM, options.toleranceShare}) {
        if (!(tolerance >= 0) || !std::isfinite(tolerance)) {
            refuseOverlay("Overlays",
                          text("their depth tolerance is ", tolerance, "; it must be 0 or more."));
        }
    }
}

/// Light of stored values and back. Fixed point makes every machine compute the same: light has 16 bits, and
/// a shadow's factors have 15.
class Darkening {
  public:
    static constexpr int kFactorBits = 15;
    static constexpr std::uint32_t kWhole = 1U << kFactorBits; ///< No shadow.

    Darkening() {
        constexpr double kMostLight = 65535;
        for (std::size_t value = 0; value < m_light.size(); ++value) {
            m_light[value] = static_cast<std::uint32_t>(
                std::lround(kMostLight * linearLight(static_cast<double>(value) / 255)));
        }
        for (std::size_t light = 0; light < m_stored.size(); ++light) {
            m_stored[light] = static_cast<std::uint8_t>(
                std::lround(255 * storedValue(static_cast<double>(light) / kMostLight)));
        }
    }

    static std::uint32_t factor(float share) {
        return static_cast<std::uint32_t>(nearestInt(share * static_cast<float>(kWhole)));
    }

    /// Range: factor up to kWhole.
    void darken(std::uint8_t* rgb, std::uint32_t factor) const {
        for (int c = 0; c < 3; ++c) {
            rgb[c] = m_stored[(m_light[rgb[c]] * factor + kWhole / 2) >> kFactorBits];
        }
    }

  private:
    std::array<std::uint32_t, 256> m_light{};
    std::array<std::uint8_t, 65536> m_stored{};
};

/// What the shadow leaves between its pixels, bilinearly. The rim repeats half a pixel.
std::uint32_t factorBetween(const Image<float, 1>& shadow, const OverlayMap::Position& at) {
    if (at.u == OverlayMap::kNowhere) {
        return Darkening::kWhole;
    }
    const int right = at.u & 0xFF;
    const int below = at.v & 0xFF;
    std::uint64_t sum = 0;
    for (const int j : {0, 1}) {
        for (const int i : {0, 1}) {
            const int x = std::clamp((at.u >> 8) + i, 0, shadow.width() - 1);
            const int y = std::clamp((at.v >> 8) + j, 0, shadow.height() - 1);
            const int weight =
                (i == 1 ? right : OverlayMap::kOne - right) * (j == 1 ? below : OverlayMap::kOne - below);
            sum += static_cast<std::uint64_t>(weight) * Darkening::factor(*shadow.at(x, y));
        }
    }
    return static_cast<std::uint32_t>((sum + 0x8000) >> 16);
}

/// map: null if pixels are taken one for one.
void darkenRow(const Image<float, 1>& shadow, const OverlayMap* map, int y, RgbImage& picture) {
    static const Darkening kDarkening;
    for (int x = 0; x < picture.width(); ++x) {
        const std::uint32_t factor =
            map != nullptr ? factorBetween(shadow, map->at(x, y)) : Darkening::factor(*shadow.at(x, y));
        if (factor != Darkening::kWhole) {
            kDarkening.darken(picture.at(x, y), factor);
        }
    }
}

/// An overlay, and how the view's pixels find it.
struct Layer {
    OverlayLayer pixels;
    std::shared_ptr<const OverlayMap> map; ///< Null if pixels are taken one for one.

    /// The pixels of the view's row that may show something.
    OverlayLayer::Span span(int y, int width) const {
        if (!map) {
            return pixels.span(y);
        }
        OverlayLayer::Span span{0, width};
        while (span.begin < span.end && !pixels.mayShow(map->at(span.begin, y))) {
            ++span.begin;
        }
        while (span.begin < span.end && !pixels.mayShow(map->at(span.end - 1, y))) {
            --span.end;
        }
        return span;
    }

    /// Lays in pixels of a row that hide all that is behind them, from x on up to the first one that may not.
    /// Returns that one, or `end`.
    int layOpaque(int x, int end, int y, const DepthImage& viewDepth, RgbImage& picture) const {
        if (!map) {
            const int next = pixels.opaqueEnd(x, end, y);
            simd::copyColours(pixels.picture().at(x, y), next - x, picture.at(x, y));
            return next;
        }
        const std::span<const OverlayMap::Position> row = map->row(y);
        const int next = pixels.opaqueEnd(row, x, end, viewDepth.empty() ? nullptr : viewDepth.at(0, y));
        simd::coloursBetween(pixels.picture(),
                             row.subspan(static_cast<std::size_t>(x), static_cast<std::size_t>(next - x)),
                             picture.at(x, y));
        return next;
    }

    /// The numbers of the objects in such pixels.
    void labelOpaque(int x, int end, int y, LabelImage& labels) const {
        constexpr int kHalfPixel = OverlayMap::kOne / 2;
        for (; x < end; ++x) {
            if (!map) {
                *labels.at(x, y) = pixels.label(x, y);
                continue;
            }
            const OverlayMap::Position& at = map->at(x, y); // of four pixels, the one with most weight
            const int u = (at.u >> 8) + ((at.u & 0xFF) > kHalfPixel ? 1 : 0);
            const int v = (at.v >> 8) + ((at.v & 0xFF) > kHalfPixel ? 1 : 0);
            *labels.at(x, y) = pixels.label(u, v);
        }
    }

    Shown at(int x, int y, float viewDepth) const {
        if (!map) {
            return pixels.pixel(x, y);
        }
        const OverlayMap::Position& position = map->at(x, y);
        return pixels.mayShow(position) ? pixels.between(position, viewDepth) : Shown();
    }
};

/// What overlays show in one pixel, farthest first.
using Pile = std::vector<Shown>;

/// The memory that a worker uses for a row.
struct RowSpace {
    std::vector<OverlayLayer::Span> spans; ///< One a layer.
    Pile pile;
};

void gather(const std::vector<Layer>& layers, const std::vector<OverlayLayer::Span>& spans, int x, int y,
            float viewDepth, Pile& pile) {
    pile.clear();
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const Shown shown = spans[i].holds(x) ? layers[i].at(x, y, viewDepth) : Shown();
        if (shown.coverage > 0) {
            pile.insert(std::upper_bound(pile.begin(), pile.end(), shown,
                                         [](const Shown& a, const Shown& b) { return a.depth > b.depth; }),
                        shown);
        }
    }
}

/// How much of the pixel the pile covers, in [0, 255].
std::uint8_t lay(const Pile& pile, std::uint8_t* rgb) {
    double left = 255;
    for (const Shown& shown : pile) {
        const std::uint64_t rest = Shown::kWhole - shown.coverage;
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint64_t sum = shown.colour[c] + rest * rgb[c];
            rgb[c] = static_cast<std::uint8_t>( // a premultiplied colour may exceed its alpha: it glows
                std::min<std::uint64_t>(255, (sum + Shown::kWhole / 2) / Shown::kWhole));
        }
        left *= static_cast<double>(rest) / static_cast<double>(Shown::kWhole);
    }
    return static_cast<std::uint8_t>(255.5 - left);
}

/// The number of what covers most of the pixel. Of two that cover as much, it is the nearer one's.
std::uint16_t labelOf(const Pile& pile) {
    double left = 1;
    double most = 0;
    std::uint16_t label = 0;
    std::for_each(pile.rbegin(), pile.rend(), [&](const Shown& shown) { // nearest first
        const double share =
            left * (static_cast<double>(shown.coverage) / static_cast<double>(Shown::kWhole));
        label = share > most ? shown.label : label;
        most = std::max(most, share);
        left -= share;
    });
    return label;
}

/// What overlays are laid into.
struct Laid {
    RgbImage& picture;
    MaskImage* shown;   ///< Null if it is not wanted.
    LabelImage* labels; ///< Null if they are not wanted.
};

void layRow(const std::vector<Layer>& layers, const DepthImage& viewDepth, int y, RowSpace& space,
            const Laid& into) {
    RgbImage& picture = into.picture;
    OverlayLayer::Span row{picture.width(), 0};
    space.spans.clear();
    for (const Layer& layer : layers) {
        const OverlayLayer::Span span = space.spans.emplace_back(layer.span(y, picture.width()));
        row = {std::min(row.begin, span.begin), std::max(row.end, span.end)};
    }
    const auto depthOf = [&](int x) { return viewDepth.empty() ? 0 : *viewDepth.at(x, y); };
    for (int x = row.begin; x < row.end; ++x) {
        const int next = layers.size() == 1 ? layers.front().layOpaque(x, row.end, y, viewDepth, picture) : x;
        if (into.shown != nullptr) {
            std::fill(into.shown->at(x, y), into.shown->at(0, y) + next, std::uint8_t{255});
        }
        if (into.labels != nullptr) {
            layers.front().labelOpaque(x, next, y, *into.labels);
        }
        x = next;
        if (x == row.end) {
            break;
        }
        gather(layers, space.spans, x, y, depthOf(x), space.pile);
        if (space.pile.empty()) {
            continue;
        }
        const std::uint8_t covered = lay(space.pile, picture.at(x, y));
        if (into.shown != nullptr) {
            *into.shown->at(x, y) = covered;
        }
        if (into.labels != nullptr && covered >= kHalf) {
            *into.labels->at(x, y) = labelOf(space.pile);
        }
    }
}

/// Makes the picture as large as the view, and zero, if it is wanted.
template <class Picture>
void clear(Picture* picture, const RgbImage& view) {
    if (picture != nullptr && (picture->width() != view.width() || picture->height() != view.height())) {
        *picture = Picture(view.width(), view.height());
    } else if (picture != nullptr) {
        std::fill(picture->values().begin(), picture->values().end(), 0);
    }
}

/// The overlay's depth at the centre of the view's pixel, from its nearest pixel; 0 where it has none.
float depthAt(const Overlay& overlay, const OverlayMap* map, int x, int y) {
    if (map != nullptr) {
        const OverlayMap::Position& position = map->at(x, y);
        if (position.u == OverlayMap::kNowhere) {
            return 0;
        }
        x = (position.u + OverlayMap::kOne / 2) >> 8;
        y = (position.v + OverlayMap::kOne / 2) >> 8;
    }
    const bool isInside = x >= 0 && x < overlay.depth.width() && y >= 0 && y < overlay.depth.height();
    return isInside && overlay.picture.at(x, y)[3] > 0 && isDepth(*overlay.depth.at(x, y))
               ? *overlay.depth.at(x, y)
               : 0;
}

} // namespace

struct Composer::State {
    /// Null if pixels are taken one for one.
    std::shared_ptr<const OverlayMap> map(const Overlay& overlay, const CameraModel& camera,
                                          const ComposeOptions& options, WorkerPool& pool) {
        return overlay.camera == camera.intrinsics()
                   ? nullptr
                   : maps.get({camera.intrinsics(), overlay.camera}, [&] {
                         return OverlayMap(camera, CameraModel(overlay.camera), pool, options.threads);
                     });
    }

    Layer layer(const Overlay& overlay, std::size_t index, const CameraModel& camera,
                const DepthImage& viewDepth, const ComposeOptions& options, WorkerPool& pool) {
        const auto number = static_cast<std::uint16_t>(index + 1);
        if (overlay.camera == camera.intrinsics()) {
            const DepthImage& room = overlay.roomDepth.empty() ? viewDepth : overlay.roomDepth;
            return {OverlayLayer(overlay, room, OverlayLayer::Lookup::OneForOne, number, options, pool),
                    nullptr};
        }
        return {
            OverlayLayer(overlay, overlay.roomDepth, OverlayLayer::Lookup::Between, number, options, pool),
            map(overlay, camera, options, pool)};
    }

    RecentlyUsed<std::pair<CameraIntrinsics, CameraIntrinsics>, OverlayMap> maps{kMapsKept};
};

Composer::Composer() : m_state(std::make_unique<State>()) {
}

Composer::~Composer() = default;
Composer::Composer(Composer&&) noexcept = default;
Composer& Composer::operator=(Composer&&) noexcept = default;

void Composer::compose(std::span<const Overlay> overlays, const CameraModel& camera,
                       const DepthImage& viewDepth, const ComposeOptions& options, WorkerPool& pool,
                       RgbImage& picture, MaskImage* shown, LabelImage* labels) {
    checkOptions(options);
    checkPictureSize("Overlays", "the view", picture, camera.intrinsics());
    if (!viewDepth.empty()) {
        checkPictureSize("Overlays", "the view's depth", viewDepth, camera.intrinsics());
    }
    for (std::size_t i = 0; i < overlays.size(); ++i) {
        checkOverlay(overlays[i], text("Overlay ", i));
    }
    std::vector<Layer> layers;
    for (std::size_t i = 0; i < overlays.size(); ++i) {
        layers.push_back(m_state->layer(overlays[i], i, camera, viewDepth, options, pool));
    }
    clear(shown, picture);
    clear(labels, picture);
    for (std::size_t i = 0; i < overlays.size(); ++i) {
        if (!overlays[i].shadow.empty()) {
            pool.run(picture.height(), options.threads,
                     [&](int y, int) { darkenRow(overlays[i].shadow, layers[i].map.get(), y, picture); });
        }
    }
    std::vector<RowSpace> spaces(static_cast<std::size_t>(pool.threads()));
    pool.run(picture.height(), options.threads, [&](int y, int worker) {
        layRow(layers, viewDepth, y, spaces[static_cast<std::size_t>(worker)], {picture, shown, labels});
    });
}

void Composer::layDepth(std::span<const Overlay> overlays, const CameraModel& camera, const MaskImage& shown,
                        const ComposeOptions& options, WorkerPool& pool, DepthImage& depth) {
    std::vector<std::shared_ptr<const OverlayMap>> maps;
    for (const Overlay& overlay : overlays) {
        maps.push_back(m_state->map(overlay, camera, options, pool));
    }
    pool.run(depth.height(), options.threads, [&](int y, int) {
        for (int x = 0; x < depth.width(); ++x) {
            float nearest = std::numeric_limits<float>::infinity();
            for (std::size_t i = 0; *shown.at(x, y) >= kHalf && i < overlays.size(); ++i) {
                const float of = depthAt(overlays[i], maps[i].get(), x, y);
                nearest = of > 0 ? std::min(nearest, of) : nearest;
            }
            if (std::isfinite(nearest)) {
                *depth.at(x, y) = nearest;
            }
        }
    });
}

} // namespace spherewalk::render
