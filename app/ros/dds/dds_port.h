// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <dds/dds.h>
#include <functional>
#include <string>
#include <vector>

namespace spherewalk::ros {

/// The quality of service with which a topic of ROS 2 is read or written. A writer must offer what its
/// readers ask for.
enum class Quality {
    Sensor,   ///< For pictures. Readers ask with best effort; writers keep each for reliable readers.
    Offered,  ///< As Sensor, but readers ask reliably once all who write offer so. Looked at once a second.
    Reliable, ///< For transforms: every message arrives.
    Latched,  ///< For /tf_static: late readers get the earlier messages too.
};

/// A participant of DDS with its readers and writers, under the names of ROS 2. Errors: Network with a
/// sentence. Threads: one thread calls spinFor(); write() may be called from any.
class DdsPort {
  public:
    /// domain: ROS_DOMAIN_ID.
    explicit DdsPort(std::uint32_t domain);
    ~DdsPort();
    DdsPort(const DdsPort&) = delete;
    DdsPort& operator=(const DdsPort&) = delete;

    /// topic: in the spelling of ROS, "/camera/image_raw". take: spinFor() calls it with each message. Owner:
    /// the message is valid during the call.
    template <class Message>
    void read(const std::string& topic, const dds_topic_descriptor_t& type, Quality quality,
              std::function<void(const Message&)> take) {
        addReader(topic, type, quality, [take = std::move(take)](const void* message) {
            take(*static_cast<const Message*>(message));
        });
    }

    dds_entity_t writer(const std::string& topic, const dds_topic_descriptor_t& type, Quality quality);

    /// Returns false if a reliable reader did not take earlier messages within 10 ms, so that this one was
    /// not written.
    static bool write(dds_entity_t writer, const void* message);

    /// Number of readers that the writer has now.
    static std::uint32_t readersOf(dds_entity_t writer);

    /// Waits for messages up to this long, and hands over those that came.
    void spinFor(std::chrono::nanoseconds time);

  private:
    using Take = std::function<void(const void*)>;

    struct Reader {
        dds_entity_t entity = 0;
        Take take;
        Quality quality = Quality::Sensor;
        dds_entity_t topic = 0;
        bool isReliable = false;
        dds_entity_t next = 0; ///< The one that takes its place when it hears all who write; 0 without one.
    };

    void addReader(const std::string& topic, const dds_topic_descriptor_t& type, Quality quality, Take take);
    dds_entity_t topicOf(const std::string& topic, const dds_topic_descriptor_t& type) const;
    dds_entity_t readerOf(dds_entity_t topic, Quality quality, bool isReliable) const;
    void followOffers(Reader& reader) const;

    dds_entity_t m_participant;
    dds_entity_t m_waitset = 0;
    std::vector<Reader> m_readers;
    std::chrono::steady_clock::time_point m_looked; ///< At what is offered, for the last time.
};

} // namespace spherewalk::ros
