// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tiles/tile_store.h"

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

    EquirectSize size(const render::PhotoLevel&) const override { return m_size; }

    void check(std::size_t) const override {}

    bool decodesParts(std::size_t) override { return decodesInParts; }

    void decode(const render::PhotoLevel& level, const jpeg::PixelRect& region,
                const jpeg::RowSink& sink) override {
        ++decodes;
        pixels += std::int64_t{region.width} * region.height;
        if (onDecode) {
            onDecode(level.photo);
        }
        std::vector<std::uint8_t> row(static_cast<std::size_t>(region.width) * 3);
        for (int y = region.y; y < region.y + region.height; ++y) {
            for (int x = 0; x < region.width * 3; ++x) {
                row[static_cast<std::size_t>(x)] = value(level.photo, region.x + x / 3, y, x % 3);
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

/// True if all pixels of the tiles, and what the guard repeats of them, are the source's.
inline bool hasPixels(const render::PlaneView& plane, std::size_t photo, const render::TileSet& tiles) {
    constexpr int kGuard = render::PlaneLayout::kGuard;
    const auto [width, height] = plane.size();
    bool isRight = true;
    for (int y = -kGuard; y < height + kGuard; ++y) {
        for (int x = -kGuard; x < width + kGuard; ++x) {
            const int sourceY = y < 0 ? -1 - y : y >= height ? 2 * height - 1 - y : y;
            const int sourceX = (x + width + (sourceY == y ? 0 : width / 2)) % width;
            const int tile = sourceY / render::TileGrid::kTileHeight * tiles.grid().columns() +
                             sourceX / render::TileGrid::kTileWidth;
            for (int c = 0; tiles.contains(tile) && c < 3; ++c) {
                isRight =
                    isRight && plane.stored(x, y, c) + 128 == MadeTiles::value(photo, sourceX, sourceY, c);
            }
        }
    }
    return isRight;
}

} // namespace spherewalk::test
