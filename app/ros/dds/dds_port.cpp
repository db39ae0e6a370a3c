// SPDX-License-Identifier: GPL-3.0-or-later
#include "dds_port.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

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

bool isOfPictures(Quality quality) {
    return quality == Quality::Sensor || quality == Quality::Offered;
}

Qos qosOf(Quality quality, bool isReader, bool isReliable) {
    Qos qos(dds_create_qos(), &dds_delete_qos);
    dds_qset_reliability(qos.get(), isReliable ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT,
                         kMostBlocking);
    // DDS itself bounds what writers keep of pictures: a reader that does not answer makes them wait.
    const bool keepsAll = isOfPictures(quality) && !isReader;
    dds_qset_history(qos.get(), keepsAll ? DDS_HISTORY_KEEP_ALL : DDS_HISTORY_KEEP_LAST,
                     isOfPictures(quality) ? kPictures : kTransforms);
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

dds_entity_t DdsPort::readerOf(dds_entity_t topic, Quality quality, bool isReliable) const {
    const dds_entity_t reader = checked(
        dds_create_reader(m_participant, topic, qosOf(quality, true, isReliable).get(), nullptr), "read");
    checked(dds_set_status_mask(reader, DDS_DATA_AVAILABLE_STATUS), "read");
    checked(dds_waitset_attach(m_waitset, reader, reader), "read");
    return reader;
}

void DdsPort::addReader(const std::string& topic, const dds_topic_descriptor_t& type, Quality quality,
                        Take take) {
    Reader reader;
    reader.take = std::move(take);
    reader.quality = quality;
    reader.topic = topicOf(topic, type);
    reader.isReliable = !isOfPictures(quality);
    reader.entity = readerOf(reader.topic, quality, reader.isReliable);
    m_readers.push_back(std::move(reader));
}

namespace {

/// What is written to a reader's topic.
struct Offers {
    std::size_t heard = 0; ///< Writers that the reader hears.
    bool areReliable = true;
};

Offers offersTo(dds_entity_t reader) {
    constexpr std::size_t kMost = 64;
    std::array<dds_instance_handle_t, kMost> writers{};
    const auto count = static_cast<std::size_t>(
        checked(dds_get_matched_publications(reader, writers.data(), kMost), "look for writers"));
    Offers offers;
    for (std::size_t i = 0; i < std::min(count, kMost); ++i) {
        dds_builtintopic_endpoint_t* writer = dds_get_matched_publication_data(reader, writers[i]);
        if (writer == nullptr) { // It has gone.
            continue;
        }
        dds_reliability_kind_t kind = DDS_RELIABILITY_BEST_EFFORT;
        dds_qget_reliability(writer->qos, &kind, nullptr);
        offers.areReliable = offers.areReliable && kind == DDS_RELIABILITY_RELIABLE;
        ++offers.heard;
        dds_builtintopic_free_endpoint(writer);
    }
    dds_requested_incompatible_qos_status_t refused{};
    checked(dds_get_requested_incompatible_qos_status(reader, &refused), "look for writers");
    offers.areReliable = offers.areReliable && refused.total_count_change == 0;
    return offers;
}

} // namespace

void DdsPort::followOffers(Reader& reader) const {
    const Offers offers = offersTo(reader.entity);
    if (reader.next != 0 && offersTo(reader.next).heard >= offers.heard) {
        dds_delete(std::exchange(reader.entity, std::exchange(reader.next, 0)));
    } else if (reader.next == 0 && offers.areReliable != reader.isReliable &&
               (offers.heard > 0 || reader.isReliable)) {
        reader.isReliable = offers.areReliable;
        reader.next = readerOf(reader.topic, reader.quality, reader.isReliable);
    }
}

dds_entity_t DdsPort::writer(const std::string& topic, const dds_topic_descriptor_t& type, Quality quality) {
    return checked(
        dds_create_writer(m_participant, topicOf(topic, type), qosOf(quality, false, true).get(), nullptr),
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

namespace {

/// Hands over what came, or drops it if `take` is null.
void takeAll(dds_entity_t reader, const std::function<void(const void*)>* take) {
    constexpr std::size_t kAtOnce = 16;
    std::array<void*, kAtOnce> messages{};
    std::array<dds_sample_info_t, kAtOnce> infos{};
    const std::int32_t count =
        checked(dds_take(reader, messages.data(), infos.data(), kAtOnce, kAtOnce), "take messages");
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        if (infos[i].valid_data && take != nullptr) {
            (*take)(messages[i]);
        }
    }
    if (count > 0) {
        dds_return_loan(reader, messages.data(), count);
    }
}

} // namespace

void DdsPort::spinFor(std::chrono::nanoseconds time) {
    checked(dds_waitset_wait(m_waitset, nullptr, 0, time.count()), "wait");
    for (const Reader& reader : m_readers) {
        takeAll(reader.entity, &reader.take);
        if (reader.next != 0) {
            takeAll(reader.next, nullptr); // The other one still gives them.
        }
    }
    const auto now = std::chrono::steady_clock::now();
    if (now - m_looked < std::chrono::seconds(1)) {
        return;
    }
    m_looked = now;
    for (Reader& reader : m_readers) {
        if (reader.quality == Quality::Offered) {
            followOffers(reader);
        }
    }
}

} // namespace spherewalk::ros
