// SPDX-License-Identifier: GPL-3.0-or-later
#include "dds_port.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <array>
#include <memory>

namespace spherewalk::ros {

namespace {

constexpr std::int32_t kPictures = 32;    ///< as many overlays as a camera keeps
constexpr std::int32_t kTransforms = 100; ///< as tf2_ros has it
constexpr dds_duration_t kMostBlocking = DDS_MSECS(10);

/// What the call gave, unless it is an error.
dds_entity_t checked(dds_return_t result, const std::string& what) {
    if (result < 0) {
        throw Error(ErrorKind::Network,
                    text("Could not ", what, " over DDS: ", dds_strretcode(result), "; see CYCLONEDDS_URI."));
    }
    return result;
}

using Qos = std::unique_ptr<dds_qos_t, decltype(&dds_delete_qos)>;

Qos qosOf(Quality quality, bool isReader) {
    Qos qos(dds_create_qos(), &dds_delete_qos);
    const bool isBestEffort = quality == Quality::Sensor && isReader;
    dds_qset_reliability(qos.get(), isBestEffort ? DDS_RELIABILITY_BEST_EFFORT : DDS_RELIABILITY_RELIABLE,
                         kMostBlocking);
    // DDS itself bounds what writers keep of pictures: a reader that does not answer makes them wait.
    const bool keepsAll = quality == Quality::Sensor && !isReader;
    dds_qset_history(qos.get(), keepsAll ? DDS_HISTORY_KEEP_ALL : DDS_HISTORY_KEEP_LAST,
                     quality == Quality::Sensor ? kPictures : kTransforms);
    dds_qset_durability(qos.get(), quality == Quality::Latched ? DDS_DURABILITY_TRANSIENT_LOCAL
                                                               : DDS_DURABILITY_VOLATILE);
    return qos;
}

} // namespace

DdsPort::DdsPort(std::uint32_t domain)
    : m_participant(checked(dds_create_participant(domain, nullptr, nullptr), "take part")) {
    m_waitset = checked(dds_create_waitset(m_participant), "wait");
}

DdsPort::~DdsPort() {
    dds_delete(m_participant); // with all that belongs to it
}

dds_entity_t DdsPort::topicOf(const std::string& topic, const dds_topic_descriptor_t& type) const {
    const std::string name = "rt" + topic;
    return checked(dds_create_topic(m_participant, &type, name.c_str(), nullptr, nullptr), "make " + name);
}

void DdsPort::addReader(const std::string& topic, const dds_topic_descriptor_t& type, Quality quality,
                        Take take) {
    const dds_entity_t reader =
        checked(dds_create_reader(m_participant, topicOf(topic, type), qosOf(quality, true).get(), nullptr),
                "read " + topic);
    checked(dds_set_status_mask(reader, DDS_DATA_AVAILABLE_STATUS), "read " + topic);
    checked(dds_waitset_attach(m_waitset, reader, reader), "read " + topic);
    m_readers.push_back({reader, std::move(take)});
}

dds_entity_t DdsPort::writer(const std::string& topic, const dds_topic_descriptor_t& type, Quality quality) {
    return checked(
        dds_create_writer(m_participant, topicOf(topic, type), qosOf(quality, false).get(), nullptr),
        "write " + topic);
}

bool DdsPort::write(dds_entity_t writer, const void* message) {
    const dds_return_t result = dds_write(writer, message);
    if (result == DDS_RETCODE_TIMEOUT) {
        return false;
    }
    checked(result, "write a message");
    return true;
}

std::uint32_t DdsPort::readersOf(dds_entity_t writer) {
    dds_publication_matched_status_t status{};
    checked(dds_get_publication_matched_status(writer, &status), "count readers");
    return status.current_count;
}

void DdsPort::spinFor(std::chrono::nanoseconds time) {
    checked(dds_waitset_wait(m_waitset, nullptr, 0, time.count()), "wait");
    for (const Reader& reader : m_readers) {
        constexpr std::size_t kAtOnce = 16;
        std::array<void*, kAtOnce> messages{};
        std::array<dds_sample_info_t, kAtOnce> infos{};
        const std::int32_t count = checked(
            dds_take(reader.entity, messages.data(), infos.data(), kAtOnce, kAtOnce), "take messages");
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
            if (infos[i].valid_data) {
                reader.take(messages[i]);
            }
        }
        if (count > 0) {
            dds_return_loan(reader.entity, messages.data(), count);
        }
    }
}

} // namespace spherewalk::ros
