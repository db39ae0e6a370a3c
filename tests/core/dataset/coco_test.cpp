// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "random.h"

#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/dataset/coco.h"

#include <gtest/gtest.h>

#include <set>

namespace spherewalk::dataset {

using render::LabelImage;
using test::expectError;

namespace {

constexpr int kWidth = 9;
constexpr int kHeight = 7;

MaskImage maskOf(const LabelImage& labels, int label) {
    MaskImage mask(labels.width(), labels.height());
    for (std::size_t i = 0; i < mask.values().size(); ++i) {
        mask.values()[i] = labels.values()[i] == label ? 1 : 0;
    }
    return mask;
}

/// What COCO's readers make of a segmentation: runs of 0 and 1 by turns, down the columns.
MaskImage decoded(const Json& segmentation) {
    const int height = segmentation["size"][0].get<int>();
    MaskImage mask(segmentation["size"][1].get<int>(), height);
    int at = 0;
    std::uint8_t value = 0;
    for (const Json& count : segmentation["counts"]) {
        for (const int end = at + count.get<int>(); at < end; ++at) {
            *mask.at(at / height, at % height) = value;
        }
        value = 1 - value;
    }
    EXPECT_EQ(at, mask.width() * height);
    return mask;
}

LabelledFrame frameOf(const LabelImage& labels, int instances) {
    LabelledFrame frame{"000000.png", "labels/000000.png", 0.5, {}, labels, {}};
    frame.roomFromCamera.translation = {1, 2, 3};
    for (int i = 1; i <= instances; ++i) {
        frame.objects.push_back({static_cast<std::uint16_t>(i),
                                 i % 2 == 1 ? "ball" : "parcel",
                                 {Eigen::Quaterniond::Identity(), {4, 5, 6}},
                                 {1, 2, 3},
                                 maskOf(labels, i)});
    }
    return frame;
}

Json jsonOf(const LabelledFrame& frame) {
    const std::vector<std::string> categories{"ball", "parcel"};
    return cocoJson(categories, 1, [&](std::size_t /*index*/) { return frame; });
}

} // namespace

TEST(Coco, MasksAreThosePixelsAndBoxesAreAboutThem) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        test::Random random(seed);
        LabelImage labels(kWidth, kHeight);
        for (std::uint16_t& label : labels.values()) {
            label = static_cast<std::uint16_t>(std::max(0, random.integer(-3, 3)));
        }
        const Json json = jsonOf(frameOf(labels, 3));
        std::set<int> ids;
        for (const Json& annotation : json["annotations"]) {
            ids.insert(annotation["id"].get<int>());
            const MaskImage mask = decoded(annotation["segmentation"]);
            ASSERT_EQ(mask, maskOf(labels, annotation["instance"])) << "seed " << seed;
            int left = kWidth;
            int top = kHeight;
            int right = 0;
            int bottom = 0;
            int area = 0;
            for (int y = 0; y < kHeight; ++y) {
                for (int x = 0; x < kWidth; ++x) {
                    if (*mask.at(x, y) != 0) {
                        left = std::min(left, x);
                        top = std::min(top, y);
                        right = std::max(right, x + 1);
                        bottom = std::max(bottom, y + 1);
                        ++area;
                    }
                }
            }
            EXPECT_EQ(annotation["bbox"], Json({left, top, right - left, bottom - top})) << "seed " << seed;
            EXPECT_EQ(annotation["area"], area);
            EXPECT_EQ(annotation["category_id"], annotation["instance"] == 2 ? 2 : 1);
        }
        EXPECT_EQ(ids.size(), json["annotations"].size());
        EXPECT_FALSE(ids.contains(0)) << "COCO's evaluation takes an annotation 0 for none";
    }
}

TEST(Coco, SharesTellWhatHidesAnObject) {
    LabelImage labels(kWidth, kHeight);
    LabelledFrame frame = frameOf(labels, 3);
    for (int x = 0; x < 8; ++x) {
        *frame.objects[0].whole.at(x, 3) = 255;
        *frame.labels.at(x, 3) = static_cast<std::uint16_t>(x < 4 ? 1 : x < 6 ? 2 : 0);
    }
    *frame.objects[1].whole.at(5, 3) = *frame.objects[1].whole.at(4, 3) = 255;
    *frame.objects[2].whole.at(7, 3) = 255;
    const Json json = jsonOf(frame);
    ASSERT_EQ(json["annotations"].size(), 2U);
    const Json& first = json["annotations"][0];
    EXPECT_EQ(first["visible_share"], 0.5);
    EXPECT_EQ(first["hidden_by_objects_share"], 0.25);
    EXPECT_EQ(first["hidden_by_room_share"], 0.25);
    EXPECT_EQ(first["bbox"], Json({0, 3, 4, 1}));
    EXPECT_EQ(first["whole_bbox"], Json({0, 3, 8, 1}));
    EXPECT_EQ(first["box_in_camera"]["center_m"], Json({3, 3, 3}));
    EXPECT_EQ(json["images"][0]["hidden_instances"], Json::array({3}));
    EXPECT_EQ(json["categories"][0], (Json{{"id", 0}, {"name", "room"}, {"supercategory", "room"}}));
}

TEST(Coco, RefusesObjectsThatDoNotFitTheLabels) {
    LabelledFrame frame = frameOf(LabelImage(kWidth, kHeight), 1);
    frame.objects[0].category = "dog";
    expectError(ErrorKind::InvalidInput, "dog", [&] { jsonOf(frame); });
    frame = frameOf(LabelImage(kWidth, kHeight), 1);
    frame.labels = LabelImage(2, 2);
    expectError(ErrorKind::InvalidInput, "9 x 7", [&] { jsonOf(frame); });
}

} // namespace spherewalk::dataset
