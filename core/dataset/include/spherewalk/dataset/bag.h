// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/dataset/ros_messages.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace spherewalk::dataset {

/// Files of recorded ROS messages.
enum class BagFormat {
    Rosbag, ///< ROS 1's, version 2.0
    Mcap,   ///< with messages of ROS 2, indexed
};

/// "rosbag", "mcap". Errors of the latter: InvalidInput.
std::string_view name(BagFormat format);
BagFormat bagFormat(std::string_view name);

/// "bag", "mcap".
std::string_view extension(BagFormat format);

/// Whose messages a format holds.
Ros messagesOf(BagFormat format);

/// A bag that is being written. It appears under its name, in place of an earlier one, when it is complete;
/// dropped before, it leaves nothing. In chunks of about a megabyte, not compressed. Errors of all: Io, Full.
class Bag {
  public:
    virtual ~Bag() = default;

    /// Returns what the topic is called in write(). All topics come before the first message.
    virtual std::size_t addTopic(const std::string& topic, RosType type) = 0;
    /// message: as the functions of ros_messages.h make it. Range: timeNs > 0.
    virtual void write(std::size_t topic, std::int64_t timeNs, ByteView message) = 0;
    virtual void finish() = 0;
};

std::unique_ptr<Bag> makeBag(BagFormat format, const std::filesystem::path& file);

} // namespace spherewalk::dataset
