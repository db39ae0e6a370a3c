// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <dds/dds.h>
#include <functional>
#include <string>
#include <vector>

namespace spherewalk::ros {

/// How a topic of ROS 2 is read or written; what readers ask for, writers must offer.
enum class Quality {
    Sensor, ///< best effort, the newest few: pictures; as writer reliable, which suits readers of both kinds
    Reliable, ///< all, as transforms are sent
    Latched,  ///< all, those from before as well: /tf_static
};

/// A participant of DDS with its readers and writers, by ROS 2's names. Errors: Network with a sentence.
/// Threads: spinFor() in one; write() in any.
class DdsPort {
  public:
    /// domain: ROS_DOMAIN_ID.
    explicit DdsPort(std::uint32_t domain);
    ~DdsPort();
    DdsPort(const DdsPort&) = delete;
    DdsPort& operator=(const DdsPort&) = delete;

    /// topic: as ROS spells it, "/camera/image_raw". take: called for each message by spinFor(); the message
    /// is valid during the call.
    template <class Message>
    void read(const std::string& topic, const dds_topic_descriptor_t& type, Quality quality,
              std::function<void(const Message&)> take) {
        addReader(topic, type, quality, [take = std::move(take)](const void* message) {
            take(*static_cast<const Message*>(message));
        });
    }

    dds_entity_t writer(const std::string& topic, const dds_topic_descriptor_t& type, Quality quality);

    static void write(dds_entity_t writer, const void* message);

    /// How many readers a writer has.
    static std::uint32_t readersOf(dds_entity_t writer);

    /// Waits for messages up to this long, and hands over those that are there.
    void spinFor(std::chrono::nanoseconds time);

  private:
    using Take = std::function<void(const void*)>;

    struct Reader {
        dds_entity_t entity;
        Take take;
    };

    void addReader(const std::string& topic, const dds_topic_descriptor_t& type, Quality quality, Take take);
    dds_entity_t topicOf(const std::string& topic, const dds_topic_descriptor_t& type) const;

    dds_entity_t m_participant;
    dds_entity_t m_waitset = 0;
    std::vector<Reader> m_readers;
};

} // namespace spherewalk::ros
