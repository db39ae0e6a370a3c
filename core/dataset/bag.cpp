// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/dataset/bag.h"

#include "bag_chunk.h"

#include "spherewalk/base/enum_names.h"

namespace spherewalk::dataset {

namespace {
constexpr EnumNames<BagFormat, 2> kBagFormats{{{BagFormat::Rosbag, "rosbag"}, {BagFormat::Mcap, "mcap"}}};
}

std::string_view name(BagFormat format) {
    return nameOf(kBagFormats, format);
}

BagFormat bagFormat(std::string_view name) {
    return valueOf(kBagFormats, "The format of a bag", name);
}

std::string_view extension(BagFormat format) {
    return format == BagFormat::Rosbag ? "bag" : "mcap";
}

Ros messagesOf(BagFormat format) {
    return format == BagFormat::Rosbag ? Ros::One : Ros::Two;
}

std::unique_ptr<Bag> makeBag(BagFormat format, const std::filesystem::path& file) {
    return format == BagFormat::Rosbag ? makeRosbag(file) : makeMcap(file);
}

} // namespace spherewalk::dataset
