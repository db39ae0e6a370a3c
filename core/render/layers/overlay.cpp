// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/render/overlay.h"

#include "layers/layer_rows.h"
#include "layers/overlay_layer.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/recently_used.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace spherewalk::render {

namespace {

constexpr std::size_t kMapsKept = 8;

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
}

void checkOptions(const ComposeOptions& options) {
    for (const double tolerance : {options.toleranceM, options.toleranceShare}) {
        if (!(tolerance >= 0) || !std::isfinite(tolerance)) {
            refuseOverlay("Overlays",
                          text("their depth tolerance is ", tolerance, "; it must be 0 or more."));
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

void layRow(const std::vector<Layer>& layers, const DepthImage& viewDepth, int y, RowSpace& space,
            RgbImage& picture, MaskImage* shown) {
    OverlayLayer::Span row{picture.width(), 0};
    space.spans.clear();
    for (const Layer& layer : layers) {
        const OverlayLayer::Span span = space.spans.emplace_back(layer.span(y, picture.width()));
        row = {std::min(row.begin, span.begin), std::max(row.end, span.end)};
    }
    for (int x = row.begin; x < row.end; ++x) {
        const int next = layers.size() == 1 ? layers.front().layOpaque(x, row.end, y, viewDepth, picture) : x;
        if (shown != nullptr) {
            std::fill(shown->at(x, y), shown->at(0, y) + next, std::uint8_t{255});
        }
        x = next;
        if (x == row.end) {
            break;
        }
        gather(layers, space.spans, x, y, viewDepth.empty() ? 0 : *viewDepth.at(x, y), space.pile);
        if (!space.pile.empty()) {
            const std::uint8_t covered = lay(space.pile, picture.at(x, y));
            if (shown != nullptr) {
                *shown->at(x, y) = covered;
            }
        }
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

    Layer layer(const Overlay& overlay, const CameraModel& camera, const DepthImage& viewDepth,
                const ComposeOptions& options, WorkerPool& pool) {
        if (overlay.camera == camera.intrinsics()) {
            const DepthImage& room = overlay.roomDepth.empty() ? viewDepth : overlay.roomDepth;
            return {OverlayLayer(overlay, room, OverlayLayer::Lookup::OneForOne, options, pool), nullptr};
        }
        return {OverlayLayer(overlay, overlay.roomDepth, OverlayLayer::Lookup::Between, options, pool),
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
                       RgbImage& picture, MaskImage* shown) {
    checkOptions(options);
    checkPictureSize("Overlays", "the view", picture, camera.intrinsics());
    if (!viewDepth.empty()) {
        checkPictureSize("Overlays", "the view's depth", viewDepth, camera.intrinsics());
    }
    for (std::size_t i = 0; i < overlays.size(); ++i) {
        checkOverlay(overlays[i], text("Overlay ", i));
    }
    std::vector<Layer> layers;
    for (const Overlay& overlay : overlays) {
        layers.push_back(m_state->layer(overlay, camera, viewDepth, options, pool));
    }
    if (shown != nullptr) {
        if (shown->width() != picture.width() || shown->height() != picture.height()) {
            *shown = MaskImage(picture.width(), picture.height());
        }
        std::fill(shown->values().begin(), shown->values().end(), std::uint8_t{0});
    }
    std::vector<RowSpace> spaces(static_cast<std::size_t>(pool.threads()));
    pool.run(picture.height(), options.threads, [&](int y, int worker) {
        layRow(layers, viewDepth, y, spaces[static_cast<std::size_t>(worker)], picture, shown);
    });
}

void Composer::layDepth(std::span<const Overlay> overlays, const CameraModel& camera, const MaskImage& shown,
                        const ComposeOptions& options, WorkerPool& pool, DepthImage& depth) {
    constexpr std::uint8_t kHalf = 128;
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
