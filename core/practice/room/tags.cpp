// SPDX-License-Identifier: GPL-3.0-or-later
#include "room/furniture.h"

#include "spherewalk/photo/april_tag.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace spherewalk::practice {

namespace {

using Eigen::Vector3d;

constexpr double kThickM = 0.001;
constexpr double kSheetSizes = (photo::kTagCells + 2.0) / photo::kTagCells; ///< Of the sheet, in tags.
constexpr double kFreeM = 1.0;                                              ///< In front of a tag.
constexpr double kLensHeightM = 1.5;
constexpr double kAlongM = 0.1;

Vector3d outward(const PracticeTag& tag) {
    return {std::cos(tag.facing.value()), std::sin(tag.facing.value()), 0};
}

/// Whether a person in front of the wall sees the whole sheet hang on it.
bool isFree(const PracticeRoom& room, const PracticeTag& tag) {
    PracticeTag sheet = tag;
    sheet.sizeM *= 1.1 * kSheetSizes;
    const Vector3d eye = tag.centreM + kFreeM * outward(tag);
    return std::ranges::all_of(sheet.cornersM(), [&](const Vector3d& corner) {
        const double away = (corner - eye).norm();
        return std::abs(room.cast(eye, corner - eye, 1e-3).rangeM - away) < 2 * kThickM * away;
    });
}

/// The place on the walls so far around the room, from its corner.
PracticeTag tagAround(const PracticeRoomOptions& room, double along) {
    const double x = room.sizeM.x();
    const double y = room.sizeM.y();
    PracticeTag tag;
    if (along < x) {
        tag.centreM = {along, kThickM, 0};
        tag.facing = Degrees(90);
    } else if (along < x + y) {
        tag.centreM = {x - kThickM, along - x, 0};
        tag.facing = Degrees(180);
    } else if (along < 2 * x + y) {
        tag.centreM = {2 * x + y - along, y - kThickM, 0};
        tag.facing = Degrees(-90);
    } else {
        tag.centreM = {kThickM, 2 * (x + y) - along, 0};
        tag.facing = Degrees(0);
    }
    tag.centreM.z() = kLensHeightM;
    tag.centreM += room.originM;
    return tag;
}

} // namespace

std::array<Vector3d, 4> PracticeTag::cornersM() const {
    const Vector3d right = Vector3d::UnitZ().cross(outward(*this)) * (sizeM / 2);
    const Vector3d up = Vector3d::UnitZ() * (sizeM / 2);
    return {centreM - right + up, centreM + right + up, centreM + right - up, centreM - right - up};
}

Shape sheetOf(const PracticeTag& tag, const Vector3d& origin) {
    Shape sheet;
    sheet.kind = Shape::Kind::Box;
    sheet.half = {kSheetSizes * tag.sizeM / 2, kThickM / 2, kSheetSizes * tag.sizeM / 2};
    sheet.centre = tag.centreM - origin - kThickM / 2 * outward(tag);
    const double yaw = tag.facing.value() - std::numbers::pi / 2; // +y looks out
    sheet.cosYaw = std::cos(yaw);
    sheet.sinYaw = std::sin(yaw);
    sheet.shade = 0;
    sheet.finish = finish(Texture::Tag, 0x1C1C1C, 0xEFEFEC, 0);
    sheet.finish.cells = photo::tagCells(tag.number);
    return completed(sheet);
}

std::vector<PracticeTag> tagsOnWalls(const PracticeRoom& room, int count, double sizeM) {
    const PracticeRoomOptions& options = room.options();
    const double around = 2 * (options.sizeM.x() + options.sizeM.y());
    std::vector<PracticeTag> tags;
    const auto tagNear = [&](double wanted) -> std::optional<PracticeTag> {
        for (double off = 0; off < around / 2; off += kAlongM) {
            for (const double side : {-1, 1}) {
                PracticeTag tag = tagAround(options, std::fmod(wanted + side * off + around, around));
                tag.sizeM = sizeM;
                const bool isApart = std::ranges::none_of(tags, [&](const PracticeTag& other) {
                    return (other.centreM - tag.centreM).norm() < 2 * kSheetSizes * sizeM;
                });
                if (isApart && isFree(room, tag)) {
                    return tag;
                }
            }
        }
        return std::nullopt;
    };
    for (int i = 0; i < count; ++i) {
        if (auto tag = tagNear(around * (i + 0.5) / count)) {
            tag->number = i;
            tags.push_back(*tag);
        }
    }
    return tags;
}

} // namespace spherewalk::practice
