// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tile_store.h"

#include "spherewalk/base/error.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <vector>

namespace spherewalk::test {

/// A source whose pixels tell which photo and place they are of.
class MadeTiles : public render::TileSource {
  public:
    explicit MadeTiles(EquirectSize size) : m_size(size) {}

    static std::uint8_t value(std::size_t photo, int x, int y, int channel) {
        return static_cast<std::uint8_t>(photo * 31 + static_cast<std::size_t>(x) * 7 +
                                         static_cast<std::size_t>(y) * 13 +
                                         static_cast<std::size_t>(channel) * 101);
    }

    EquirectSize size(std::size_t) const override { return m_size; }

    void check(std::size_t) const override {}

    bool decodesParts(std::size_t) override { return decodesInParts; }

    void decode(std::size_t photo, const jpeg::PixelRect& region, const jpeg::RowSink& sink) override {
        ++decodes;
        pixels += std::int64_t{region.width} * region.height;
        if (onDecode) {
            onDecode(photo);
        }
        std::vector<std::uint8_t> row(static_cast<std::size_t>(region.width) * 4);
        for (int y = region.y; y < region.y + region.height; ++y) {
            for (int x = 0; x < region.width * 4; ++x) {
                row[static_cast<std::size_t>(x)] = value(photo, region.x + x / 4, y, x % 4);
            }
            sink(y, row.data());
        }
    }

    bool decodesInParts = true;
    std::atomic<int> decodes{0};
    std::atomic<std::int64_t> pixels{0};
    std::function<void(std::size_t photo)> onDecode;

  private:
    EquirectSize m_size;
};

/// True if all pixels of the tiles, and the apron of those at the left edge, are the source's.
inline bool hasPixels(const render::PhotoPlane& plane, std::size_t photo, const render::TileSet& tiles) {
    bool isRight = true;
    const auto compare = [&](int x, int y, int sourceX) {
        const std::uint8_t* pixel =
            plane.pixels + static_cast<std::size_t>(y) * plane.strideBytes + static_cast<std::size_t>(x) * 4;
        for (int c = 0; c < 4; ++c) {
            isRight = isRight && pixel[c] == MadeTiles::value(photo, sourceX, y, c);
        }
    };
    tiles.forEach([&](int tile) {
        const jpeg::PixelRect own = tiles.grid().pixels(tile);
        for (int y = own.y; y < own.y + own.height; ++y) {
            for (int x = own.x; x < own.x + own.width; ++x) {
                compare(x, y, x);
            }
            for (int x = 0; own.x == 0 && x < render::SparsePlane::kApron; ++x) {
                compare(plane.size.width + x, y, x);
            }
        }
    });
    return isRight;
}

} // namespace spherewalk::test
