// SPDX-License-Identifier: GPL-3.0-or-later
#include "room/furniture.h"

namespace spherewalk::practice {

namespace {

using Eigen::Vector3d;

Furniture lively(const Vector3d& size) {
    Furniture room;
    room.walls = {
        finish(Texture::Planks, 0xD0A26A, 0x8F6036, 1), plain(0xF4F2EC),
        finish(Texture::Plaster, 0xE9E4D6, 0, 3),       finish(Texture::Wallpaper, 0xD9E0D2, 0x7F9C86, 4),
        finish(Texture::Plaster, 0xDDE3E6, 0, 5),       finish(Texture::Plaster, 0xEADCC4, 0, 6)};
    room.walls[static_cast<int>(Wall::Ceiling)].texture = Texture::Plaster;
    addRug(room, size.x() * 0.42, size.y() * 0.5);
    addTable(room, size.x() - 1.15, 1.15);
    addChair(room, size.x() - 1.58, 0.50, 192);
    addChair(room, size.x() - 0.75, 0.62, 170);
    addChair(room, size.x() - 1.62, 1.72, 25);
    addChair(room, size.x() - 0.72, 1.88, 8);
    addShelf(room, 1.35, size.y() - 0.15);
    addCabinet(room, size.x() - 0.25, size.y() - 1.10);
    addArmchair(room, size.x() - 1.75, size.y() - 0.60);
    addPlant(room, 0.35, 0.38);
    addFloorLamp(room, 0.35, size.y() - 0.32);
    addCeilingLamp(room, size.x() - 1.15, 1.15, size.z());
    addWindow(room, size.y() / 2);
    addDoor(room, 1.10);
    addPictures(room, size);
    return room;
}

Furniture bare(const Vector3d& size) {
    Furniture room;
    room.walls.fill(plain(0xF3F2EE));
    Finish floor = finish(Texture::Planks, 0xBBAE98, 0xB2A48D, 1);
    floor.mirror = 0.10F;
    room.walls[static_cast<int>(Wall::Floor)] = floor;
    constexpr float kBurnt = 8; // times what a picture can hold
    addWindow(room, size.y() / 2, kBurnt);
    addCeilingLamp(room, size.x() / 2, size.y() / 2, size.z() - 0.02, kBurnt);
    addDoor(room, 1.10);
    addTable(room, size.x() - 1.15, 1.15);
    addChair(room, size.x() - 1.62, 1.72, 25);
    addCabinet(room, size.x() - 0.25, size.y() - 1.10);
    addOverhang(room, 1.35, size.y() - 0.25);
    Piece west(room, 0, 0, -90);
    addPicture(west, -0.62, 1.60, 0.45, 0.60, Texture::Page, 100);
    Piece south(room, 0, 0, 0);
    Finish mirror = plain(0xF2F2F2);
    mirror.mirror = 0.92F;
    south.box({2.35, 0.01, 1.35}, {0.80, 0.02, 1.30}, mirror).shade = 0;
    addPane(room, {size.x() - 2.05, size.y() - 0.75, 1.05}, {0.012, 1.5, 2.1});
    Piece foot(room, size.x() - 2.05, size.y() - 0.75, 0);
    foot.box({0, 0, 0.02}, {0.05, 1.5, 0.04}, plain(0x77797C));
    foot.footprint(0.05, 1.5);
    room.floorLamp = room.ceilingLamp;
    return room;
}

Furniture flat(const Vector3d& size) {
    constexpr double kWall = 0.10;
    constexpr double kCorridor = 1.4;
    constexpr double kDoor = 0.9;
    constexpr double kLintel = 2.05;
    Furniture room;
    room.walls = {finish(Texture::Planks, 0xD0A26A, 0x8F6036, 1), plain(0xF4F2EC),
                  finish(Texture::Plaster, 0xE9E4D6, 0, 3),       plain(0xEFEDE8),
                  finish(Texture::Plaster, 0xDDE3E6, 0, 5),       plain(0xEADCC4)};
    const double middle = size.x() / 2;
    const double north = kCorridor + kWall;
    const double leftDoor = middle / 2;
    const double rightDoor = middle + middle / 2;
    addInnerWall(room, {0, kCorridor}, {leftDoor - kDoor / 2, north}, size.z(), 7);
    addInnerWall(room, {leftDoor + kDoor / 2, kCorridor}, {rightDoor - kDoor / 2, north}, size.z(), 8);
    addInnerWall(room, {rightDoor + kDoor / 2, kCorridor}, {size.x(), north}, size.z(), 9);
    addInnerWall(room, {middle - kWall / 2, north}, {middle + kWall / 2, size.y()}, size.z(), 10);
    for (const double door : {leftDoor, rightDoor}) {
        Piece lintel(room, door, kCorridor + kWall / 2, 0);
        lintel.box({0, 0, (kLintel + size.z()) / 2}, {kDoor, kWall, size.z() - kLintel},
                   finish(Texture::Plaster, 0xE9E4D6, 0, 11));
    }
    addWindow(room, (north + size.y()) / 2);
    addTable(room, 1.15, size.y() - 0.75);
    addChair(room, 1.62, size.y() - 1.45, 160);
    addShelf(room, middle - 0.85, size.y() - 0.16);
    addCeilingLamp(room, 1.15, size.y() - 0.75, size.z());
    addArmchair(room, middle + 0.75, size.y() - 0.60);
    addCabinet(room, size.x() - 0.25, size.y() - 1.10);
    addPlant(room, size.x() - 0.40, north + 0.40);
    addFloorLamp(room, middle + 0.40, north + 0.45);
    addDoor(room, 1.10);
    Piece corridor(room, 0, 0, 0);
    addPicture(corridor, 3.4, 1.55, 0.60, 0.80, Texture::Page, 91);
    Piece east(room, size.x(), 0, 90);
    addPicture(east, north + 1.2, 1.60, 1.00, 0.70, Texture::Art, 95);
    return room;
}

} // namespace

Furniture furnished(RoomStyle style, const Vector3d& size) {
    switch (style) {
    case RoomStyle::Bare:
        return bare(size);
    case RoomStyle::Flat:
        return flat(size);
    case RoomStyle::Lively:
        break;
    }
    return lively(size);
}

} // namespace spherewalk::practice
