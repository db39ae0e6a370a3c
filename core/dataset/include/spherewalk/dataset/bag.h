// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/dataset/ros_messages.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace spherewalk::dataset {

/// Formats of files of recorded ROS messages.
enum class BagFormat {
    Rosbag, ///< The format of ROS 1, version 2.0.
    Mcap,   ///< MCAP with messages of ROS 2 and an index.
};

/// The words "rosbag" and "mcap". Errors: bagFormat() throws InvalidInput for another word.
std::string_view name(BagFormat format);
BagFormat bagFormat(std::string_view name);

/// The file name extension, "bag" or "mcap".
std::string_view extension(BagFormat format);

/// The generation of ROS whose messages a format holds.
Ros messagesOf(BagFormat format);

/// Writes a bag in chunks of about a megabyte, not compressed. finish() puts the file under its name, in
/// place of an earlier one; without finish(), nothing is left. Errors of all functions: Io, Full.
class Bag {
  public:
    virtual ~Bag() = default;

    /// Returns the number by which write() knows the topic. Range: before the first message.
    virtual std::size_t addTopic(const std::string& topic, RosType type) = 0;
    /// message: bytes from a function of ros_messages.h for messagesOf() this format. Range: timeNs > 0.
    virtual void write(std::size_t topic, std::int64_t timeNs, ByteView message) = 0;
    virtual void finish() = 0;
};

/// Begins a bag beside this file. Errors: Io.
std::unique_ptr<Bag> makeBag(BagFormat format, const std::filesystem::path& file);

} // namespace spherewalk::dataset
