// SPDX-License-Identifier: GPL-3.0-or-later
#include "room/furniture.h"

#include "room/noise.h"

namespace spherewalk::practice {

using Eigen::Vector3d;

Finish finish(Texture texture, std::uint32_t first, std::uint32_t second, std::uint32_t seed) {
    return {texture, linear(first), linear(second), seed, 0, 0, {}};
}

Finish plain(std::uint32_t colour) {
    return finish(Texture::Plain, colour, colour, 0);
}

namespace {

Finish oak(std::uint32_t seed) {
    return finish(Texture::Wood, 0xC79A63, 0x8A5A2F, seed);
}

Finish walnut(std::uint32_t seed) {
    return finish(Texture::Wood, 0x7A4F30, 0x3F2616, seed);
}

} // namespace

void addTable(Furniture& room, double x, double y) {
    Piece table(room, x, y, 12);
    table.box({0, 0, 0.735}, {1.4, 0.8, 0.03}, oak(3));
    table.box({0, 0, 0.68}, {1.24, 0.64, 0.08}, oak(4)).shade = 0.4F;
    for (const auto& [sx, sy] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
        table.box({0.64 * sx, 0.34 * sy, 0.36}, {0.055, 0.055, 0.72}, oak(5));
    }
    table.footprint(1.4, 0.8);
    table.cylinder({-0.45, 0.16, 0.75}, 0.04, 0.10, finish(Texture::Stripes, 0xE9E4D8, 0x2F5D8C, 1));
    table.cylinder({0.10, -0.22, 0.75}, 0.04, 0.10, finish(Texture::Stripes, 0xE9E4D8, 0xA03A2C, 2));
    table.cylinder({0.20, 0.08, 0.75}, 0.15, 0.035, finish(Texture::Mosaic, 0xD8D2C0, 0x2A4B5E, 5));
    table.sphere({0.16, 0.06, 0.825}, 0.042, finish(Texture::Leaves, 0xD9482B, 0xE9A23B, 7));
    table.sphere({0.25, 0.09, 0.825}, 0.040, finish(Texture::Leaves, 0x9BB53C, 0xD9C545, 8));
    table.sphere({0.20, 0.14, 0.820}, 0.038, finish(Texture::Leaves, 0xE08A2E, 0xC7502A, 9));
    Piece pile(room, x - 0.28, y - 0.24, 31);
    pile.box({0, 0, 0.7650}, {0.24, 0.17, 0.03}, finish(Texture::Page, 0x7A8FA8, 0x2E3D57, 61));
    pile.box({0.01, 0.01, 0.7925}, {0.21, 0.15, 0.025}, finish(Texture::Page, 0xB9704F, 0x3A2A2F, 62));
    Piece paper(room, x + 0.45, y - 0.02, -8);
    paper.box({0, 0, 0.751}, {0.30, 0.21, 0.002}, finish(Texture::Page, 0x6E9A77, 0x20362B, 63)).shade = 0.1F;
    Piece box(room, x + 0.42, y + 0.28, 40);
    box.box({0, 0, 0.81}, {0.12, 0.12, 0.12}, finish(Texture::Mosaic, 0xEEE6D2, 0x3C3F6B, 11));
}

void addChair(Furniture& room, double x, double y, double yawDeg) {
    Piece chair(room, x, y, yawDeg);
    const Finish frame = walnut(14);
    chair.box({0, 0, 0.45}, {0.42, 0.42, 0.05}, finish(Texture::Fabric, 0x4C6A7D, 0xC9BFA2, 15));
    for (const auto& [sx, sy] : {std::pair{-1, -1}, {1, -1}}) {
        chair.box({0.19 * sx, 0.19 * sy, 0.2125}, {0.035, 0.035, 0.425}, frame);
    }
    for (const double side : {-0.19, 0.19}) {
        chair.box({side, 0.19, 0.46}, {0.035, 0.035, 0.92}, frame);
    }
    chair.box({0, 0.19, 0.86}, {0.345, 0.025, 0.10}, frame).shade = 0.4F;
    chair.box({0, 0.19, 0.68}, {0.345, 0.02, 0.06}, frame).shade = 0.4F;
    chair.footprint(0.42, 0.42);
}

void addShelf(Furniture& room, double x, double y) {
    constexpr double kWidth = 1.2;
    constexpr double kDepth = 0.30;
    constexpr double kHeight = 2.0;
    constexpr int kBoards = 6;
    Piece shelf(room, x, y, 0);
    const Finish board = finish(Texture::Wood, 0xE2D6BF, 0xBFA985, 21);
    for (const double side : {-1.0, 1.0}) {
        shelf.box({side * (kWidth / 2 - 0.01), 0, kHeight / 2}, {0.02, kDepth, kHeight}, board);
    }
    shelf.box({0, kDepth / 2 - 0.005, kHeight / 2}, {kWidth - 0.04, 0.01, kHeight}, board);
    const double step = (kHeight - 0.03) / (kBoards - 1);
    for (int i = 0; i < kBoards; ++i) {
        shelf.box({0, -0.005, 0.015 + i * step}, {kWidth - 0.04, kDepth - 0.01, 0.02}, board).shade = 0.5F;
    }
    for (int row = 0; row + 1 < kBoards; ++row) {
        double left = -kWidth / 2 + 0.04;
        for (int i = 0; left < kWidth / 2 - 0.10; ++i) {
            const std::uint32_t h = hash(i, row, 97);
            const double thick = 0.022 + 0.038 * unit(h);
            const double high = 0.20 + 0.13 * unit(mixed(h + 1));
            const double deep = 0.15 + 0.08 * unit(mixed(h + 2));
            if (h % 9U != 0) {
                Finish cover = plain(0);
                cover.texture = Texture::Book;
                cover.seed = h;
                cover.first =
                    Rgb(unit(mixed(h + 3)), unit(mixed(h + 4)), unit(mixed(h + 5))).square() * 0.6F + 0.02F;
                cover.second = h % 2U == 0 ? linear(0xE8D9A8) : linear(0x1D1D22);
                shelf
                    .box({left + thick / 2, 0.13 - deep / 2, 0.025 + row * step + high / 2},
                         {thick - 0.002, deep, high}, cover)
                    .shade = 0.15F;
            }
            left += thick + (h % 9U == 0 ? 0.06 : 0.0);
        }
    }
    shelf.footprint(kWidth, kDepth);
}

void addCabinet(Furniture& room, double x, double y) {
    Piece cabinet(room, x, y, 90); // its front, local -y... local +y faces west
    Finish lacquer = plain(0x5A1F24);
    lacquer.mirror = 0.22F;
    cabinet.box({0, 0, 0.46}, {1.2, 0.45, 0.80}, lacquer);
    cabinet.box({0, 0, 0.875}, {1.24, 0.48, 0.03}, walnut(31));
    for (const auto& [sx, sy] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
        cabinet.box({0.55 * sx, 0.17 * sy, 0.03}, {0.05, 0.05, 0.06}, walnut(32));
    }
    cabinet.box({0, 0.2265, 0.46}, {0.004, 0.003, 0.78}, plain(0x2A0E10)).shade = 0;
    for (const double side : {-0.04, 0.04}) {
        cabinet.cylinder({side, 0.235, 0.46}, 0.008, 0.14, plain(0xC9C2B0));
    }
    cabinet.footprint(1.24, 0.48);
    Finish chrome = plain(0xF2F2F2);
    chrome.mirror = 0.9F;
    cabinet.sphere({-0.38, 0.02, 1.04}, 0.15, chrome);
    cabinet.cylinder({0.36, 0, 0.89}, 0.09, 0.02, walnut(33));
    cabinet.cylinder({0.36, 0, 0.91}, 0.012, 0.05, plain(0xB08D57));
    cabinet.sphere({0.36, 0, 1.09}, 0.14, finish(Texture::Globe, 0, 0, 35));
    cabinet.cylinder({-0.02, 0.05, 0.89}, 0.05, 0.22, finish(Texture::Stripes, 0x4C7C6B, 0xD7C893, 36));
}

void addArmchair(Furniture& room, double x, double y) {
    Piece chair(room, x, y, -14);
    const Finish cloth = finish(Texture::Fabric, 0x8C4A3C, 0xD9A066, 41);
    chair.box({0, 0, 0.24}, {0.60, 0.66, 0.36}, cloth);
    chair.box({0, 0.26, 0.50}, {0.60, 0.16, 0.70}, cloth);
    for (const double side : {-0.36, 0.36}) {
        chair.box({side, 0, 0.32}, {0.12, 0.70, 0.56}, cloth);
    }
    chair.box({0.02, 0.10, 0.55}, {0.38, 0.12, 0.32}, finish(Texture::Rug, 0x2F5D62, 0xE8C07D, 43));
    chair.footprint(0.84, 0.74);
}

void addPlant(Furniture& room, double x, double y) {
    Piece plant(room, x, y, 0);
    plant.cylinder({0, 0, 0}, 0.16, 0.32, finish(Texture::Stripes, 0xB5633F, 0x7C3D25, 51));
    plant.cylinder({0, 0, 0.32}, 0.02, 0.55, walnut(52));
    for (int i = 0; i < 12; ++i) {
        const std::uint32_t h = hash(i, 3, 53);
        const double angle = 2 * std::numbers::pi * (i * 0.381966);
        const double out = 0.08 + 0.12 * unit(h);
        plant
            .sphere({out * std::cos(angle), out * std::sin(angle), 0.62 + 0.055 * i},
                    0.075 + 0.05 * unit(mixed(h + 1)), finish(Texture::Leaves, 0x2F5B2C, 0x86A84B, h))
            .shade = 0.3F;
    }
    plant.footprint(0.36, 0.36);
}

void addFloorLamp(Furniture& room, double x, double y) {
    Piece lamp(room, x, y, 0);
    lamp.cylinder({0, 0, 0}, 0.14, 0.025, plain(0x2B2B2E));
    lamp.cylinder({0, 0, 0.025}, 0.012, 1.40, plain(0x8F8A80));
    Finish shade = finish(Texture::Stripes, 0xFFE9BE, 0xF3D296, 55);
    shade.glow = 1.5F;
    lamp.cylinder({0, 0, 1.35}, 0.17, 0.28, shade).shade = 0;
    lamp.footprint(0.28, 0.28);
    room.floorLamp = {x, y, 1.5};
}

void addCeilingLamp(Furniture& room, double x, double y, double ceiling, float glow) {
    Piece lamp(room, x, y, 0);
    lamp.cylinder({0, 0, ceiling - 0.60}, 0.006, 0.60, plain(0x202020));
    Finish shade = plain(0xFFF4DC);
    shade.glow = glow;
    lamp.cylinder({0, 0, ceiling - 0.76}, 0.19, 0.16, shade).shade = 0;
    room.ceilingLamp = {x, y, ceiling - 0.70};
}

namespace {

/// Frames around a rectangle on a wall; the piece's y axis points into the room.
void addFrame(Piece& wall, double z, double width, double height, double bar, double depth,
              const Finish& made) {
    wall.box({0, depth / 2, z + height / 2 + bar / 2}, {width + 2 * bar, depth, bar}, made).shade = 0.3F;
    wall.box({0, depth / 2, z - height / 2 - bar / 2}, {width + 2 * bar, depth, bar}, made).shade = 0.3F;
    for (const double side : {-1.0, 1.0}) {
        wall.box({side * (width / 2 + bar / 2), depth / 2, z}, {bar, depth, height}, made).shade = 0.3F;
    }
}

} // namespace

void addWindow(Furniture& room, double y, float glow) {
    Piece wall(room, 0, y, -90);
    constexpr double kMiddle = 1.5;
    constexpr double kWidth = 1.5;
    constexpr double kHeight = 1.2;
    Finish view = finish(Texture::Outside, 0, 0, 71);
    view.glow = glow;
    wall.box({0, 0.004, kMiddle}, {kWidth, 0.008, kHeight}, view).shade = 0;
    const Finish white = plain(0xEFEDE6);
    addFrame(wall, kMiddle, kWidth, kHeight, 0.07, 0.05, white);
    wall.box({0, 0.02, kMiddle}, {0.045, 0.04, kHeight}, white).shade = 0;
    wall.box({0, 0.02, kMiddle + 0.25}, {kWidth, 0.04, 0.035}, white).shade = 0;
    wall.box({0, 0.11, kMiddle - kHeight / 2 - 0.085}, {kWidth + 0.3, 0.22, 0.03}, white);
    for (const double side : {-1.0, 1.0}) {
        wall.box({side * (kWidth / 2 + 0.20), 0.12, 1.22}, {0.34, 0.07, 2.16},
                 finish(Texture::Curtain, 0xC7B58F, 0x7A3E3A, side < 0 ? 73U : 74U))
            .shade = 0.5F;
    }
    wall.cylinder({-0.35, 0.12, kMiddle - kHeight / 2 - 0.07}, 0.06, 0.11,
                  finish(Texture::Mosaic, 0xC9744F, 0x7A3D25, 75));
    wall.sphere({-0.35, 0.12, kMiddle - kHeight / 2 + 0.10}, 0.085,
                finish(Texture::Leaves, 0x3D6B35, 0x9DBB58, 76));
    wall.box({0, 0.06, 0.40}, {1.1, 0.09, 0.55}, finish(Texture::Ribs, 0xE8E6E0, 0x8C8A85, 77));
    room.windowCentre = {0, y, kMiddle};
    room.windowHalf = {0, kWidth / 2, kHeight / 2};
}

void addDoor(Furniture& room, double x) {
    Piece wall(room, x, 0, 0);
    wall.box({0, 0.01, 1.02}, {0.90, 0.02, 2.04}, finish(Texture::Door, 0xD8CBB2, 0xB9A37E, 81)).shade = 0.2F;
    const Finish white = plain(0xEDE9DF);
    wall.box({0, 0.02, 2.08}, {1.08, 0.04, 0.08}, white).shade = 0.2F;
    for (const double side : {-0.49, 0.49}) {
        wall.box({side, 0.02, 1.02}, {0.08, 0.04, 2.04}, white).shade = 0.2F;
    }
    Finish brass = plain(0xD0B060);
    brass.mirror = 0.5F;
    wall.sphere({0.37, 0.06, 1.02}, 0.032, brass);
}

void addPicture(Piece& wall, double along, double z, double width, double height, Texture texture,
                std::uint32_t seed) {
    Finish canvas = texture == Texture::Art ? finish(texture, seed % 2U == 0 ? 0x2B211A : 0xB8923E, 0, seed)
                                            : finish(texture, 0xA8B7C9, 0x23344F, seed);
    if (texture == Texture::Art) {
        canvas.blots = blots(seed, static_cast<float>(width), static_cast<float>(height));
    }
    wall.box({along, 0.0125, z}, {width, 0.025, height}, canvas).shade = 0.25F;
}

void addPictures(Furniture& room, const Vector3d& size) {
    Piece south(room, 0, 0, 0);
    addPicture(south, 2.05, 1.55, 0.60, 0.80, Texture::Page, 91);
    addPicture(south, 2.95, 1.50, 0.90, 0.60, Texture::Art, 92);
    addPicture(south, 4.05, 1.62, 1.10, 0.75, Texture::Art, 93);
    Piece east(room, size.x(), 0, 90);
    addPicture(east, 1.15, 1.60, 1.00, 0.70, Texture::Art, 95);
    addPicture(east, size.y() - 1.10, 1.75, 1.20, 0.70, Texture::Art, 96);
    addPicture(east, 2.05, 1.55, 0.42, 0.59, Texture::Page, 97);
    Piece north(room, 0, size.y(), 180);
    addPicture(north, -(size.x() - 1.95), 1.60, 0.85, 0.65, Texture::Art, 98);
    addPicture(north, -(size.x() - 0.85), 1.65, 0.50, 0.70, Texture::Page, 99);
    Piece west(room, 0, 0, -90);
    addPicture(west, -0.62, 1.60, 0.45, 0.60, Texture::Art, 100);
    addPicture(west, -(size.y() - 0.62), 1.62, 0.50, 0.50, Texture::Art, 101);
}

void addRug(Furniture& room, double x, double y) {
    Piece rug(room, x, y, 4);
    rug.box({0, 0, 0.006}, {2.1, 1.5, 0.012}, finish(Texture::Rug, 0x8E3B34, 0x27476B, 85)).shade = 0.1F;
}

void addPane(Furniture& room, const Vector3d& centre, const Vector3d& size) {
    Shape pane;
    pane.half = size / 2;
    pane.centre = centre;
    room.panes.push_back(completed(pane));
}

/// A wall from the floor to this height, with its outline on the floor.
void addInnerWall(Furniture& room, const Eigen::Vector2d& from, const Eigen::Vector2d& to, double height,
                  std::uint32_t seed) {
    const Eigen::Vector2d middle = (from + to) / 2;
    const Eigen::Vector2d size = to - from;
    Piece wall(room, middle.x(), middle.y(), 0);
    wall.box({0, 0, height / 2}, {size.x(), size.y(), height}, finish(Texture::Plaster, 0xE9E4D6, 0, seed));
    wall.footprint(size.x(), size.y());
}

/// Cupboards whose doors stand out at the lens's height, over the floor that is free.
void addOverhang(Furniture& room, double x, double y) {
    Piece shelf(room, x, y, 0);
    shelf.box({0, 0, 0.45}, {0.60, 0.35, 0.90}, plain(0xEDEBE6));
    shelf.box({0, -0.20, 1.25}, {0.50, 0.30, 0.04}, oak(87));
    shelf.cylinder({0.12, -0.28, 1.27}, 0.035, 0.16, finish(Texture::Stripes, 0xE9E4D8, 0x2F5D8C, 88));
    shelf.footprint(0.60, 0.35);
}

} // namespace spherewalk::practice
