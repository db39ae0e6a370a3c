// SPDX-License-Identifier: GPL-3.0-or-later
// Source: the MCAP specification (mcap.dev/spec).
#include "bag_chunk.h"

#include "spherewalk/base/file.h"

#include <zlib.h>

namespace spherewalk::dataset {

namespace {

constexpr std::string_view kMagic{"\x89MCAP0\r\n", 8};

enum class McapOp : std::uint8_t {
    Header = 1,
    Footer,
    Schema,
    Channel,
    Message,
    Chunk,
    MessageIndex,
    ChunkIndex,
    Statistics = 0x0b,
    SummaryOffset = 0x0e,
    DataEnd = 0x0f,
};

std::uint32_t crcOf(ByteView bytes, std::uint32_t before = 0) {
    return static_cast<std::uint32_t>(::crc32_z(before, bytes.data(), bytes.size()));
}

void putText(ByteWriter& out, std::string_view text) {
    out.number(static_cast<std::uint32_t>(text.size()));
    out.put(bytesOf(text));
}

void putRecordHead(ByteWriter& out, McapOp op, std::uint64_t size) {
    out.number(static_cast<std::uint8_t>(op));
    out.number(size);
}

void putRecord(ByteWriter& out, McapOp op, ByteView content) {
    putRecordHead(out, op, content.size());
    out.put(content);
}

class Mcap : public Bag {
  public:
    explicit Mcap(const std::filesystem::path& file) : m_file(file) {
        ByteWriter header;
        putText(header, "ros2");
        putText(header, "spherewalk");
        ByteWriter out;
        out.put(bytesOf(kMagic));
        putRecord(out, McapOp::Header, header.view());
        put(out.view());
    }

    /// Each topic has a schema of its own, with its number plus one, since there is no schema 0.
    std::size_t addTopic(const std::string& topic, RosType type) override {
        const auto number = static_cast<std::uint16_t>(m_messages.size() + 1);
        const RosSchema ros = rosSchema(Ros::Two, type);
        ByteWriter schema;
        schema.number(number);
        putText(schema, ros.name);
        putText(schema, "ros2msg");
        putText(schema, ros.definition);
        ByteWriter channel;
        channel.number(number);
        channel.number(number);
        putText(channel, topic);
        putText(channel, "cdr");
        channel.number(std::uint32_t{0}); // no metadata
        ByteWriter both;
        putRecord(both, McapOp::Schema, schema.view());
        putRecord(both, McapOp::Channel, channel.view());
        put(both.view());
        putRecord(m_schemas, McapOp::Schema, schema.view());
        putRecord(m_channels, McapOp::Channel, channel.view());
        m_messages.push_back(0);
        return m_messages.size() - 1;
    }

    void write(std::size_t topic, std::int64_t timeNs, ByteView message) override {
        m_chunk.note(topic, timeNs);
        m_times.add(timeNs);
        ByteWriter head;
        head.number(channelOf(topic));
        head.number(static_cast<std::uint32_t>(m_messages[topic]++));
        head.number(timeNs); // when it was logged, and when published
        head.number(timeNs);
        putRecordHead(m_chunk.records, McapOp::Message, head.size() + message.size());
        m_chunk.records.put(head.view());
        m_chunk.records.put(message);
        if (m_chunk.records.size() >= kChunkBytes) {
            writeChunk();
        }
    }

    void finish() override {
        if (!m_chunk.entries.empty()) {
            writeChunk();
        }
        ByteWriter end;
        end.number(m_crc);
        ByteWriter dataEnd;
        putRecord(dataEnd, McapOp::DataEnd, end.view());
        put(dataEnd.view());
        writeSummary();
        m_file.commit(DurableFile::Overwrite::Yes);
    }

  private:
    static std::uint16_t channelOf(std::size_t topic) { return static_cast<std::uint16_t>(topic + 1); }

    void put(ByteView bytes) {
        m_crc = crcOf(bytes, m_crc);
        m_file.write(bytes);
    }

    void writeChunk() {
        const ByteView records = m_chunk.records.view();
        ByteWriter head;
        head.number(m_chunk.times.firstNs);
        head.number(m_chunk.times.lastNs);
        head.number(std::uint64_t{records.size()});
        head.number(crcOf(records));
        putText(head, ""); // not compressed
        head.number(std::uint64_t{records.size()});
        ByteWriter record;
        putRecordHead(record, McapOp::Chunk, head.size() + records.size());
        record.put(head.view());
        const std::uint64_t chunkAt = m_file.sizeBytes();
        put(record.view());
        put(records);
        const std::uint64_t chunkBytes = m_file.sizeBytes() - chunkAt;
        putChunkIndex(chunkAt, chunkBytes, writeMessageIndexes());
        ++m_chunks;
        m_chunk = {};
    }

    /// Returns the place of each index in the file, as a map of the format.
    ByteWriter writeMessageIndexes() {
        ByteWriter places;
        for (const auto& [topic, entries] : m_chunk.entries) {
            ByteWriter times;
            for (const ChunkEntry& entry : entries) {
                times.number(entry.timeNs);
                times.number(entry.offset);
            }
            ByteWriter index;
            index.number(channelOf(topic));
            index.number(static_cast<std::uint32_t>(times.size()));
            index.put(times.view());
            places.number(channelOf(topic));
            places.number(m_file.sizeBytes());
            ByteWriter record;
            putRecord(record, McapOp::MessageIndex, index.view());
            put(record.view());
        }
        return places;
    }

    void putChunkIndex(std::uint64_t chunkAt, std::uint64_t chunkBytes, const ByteWriter& places) {
        ByteWriter index;
        index.number(m_chunk.times.firstNs);
        index.number(m_chunk.times.lastNs);
        index.number(chunkAt);
        index.number(chunkBytes);
        index.number(static_cast<std::uint32_t>(places.size()));
        index.put(places.view());
        index.number(m_file.sizeBytes() - chunkAt - chunkBytes);
        putText(index, "");
        index.number(std::uint64_t{m_chunk.records.size()});
        index.number(std::uint64_t{m_chunk.records.size()});
        putRecord(m_chunkIndexes, McapOp::ChunkIndex, index.view());
    }

    ByteWriter statistics() const {
        ByteWriter counts;
        std::uint64_t all = 0;
        for (std::size_t topic = 0; topic < m_messages.size(); ++topic) {
            counts.number(channelOf(topic));
            counts.number(m_messages[topic]);
            all += m_messages[topic];
        }
        ByteWriter content;
        content.number(all);
        content.number(static_cast<std::uint16_t>(m_messages.size()));
        content.number(static_cast<std::uint32_t>(m_messages.size()));
        content.number(std::uint32_t{0}); // attachments
        content.number(std::uint32_t{0}); // metadata
        content.number(m_chunks);
        content.number(all > 0 ? m_times.firstNs : 0);
        content.number(m_times.lastNs);
        content.number(static_cast<std::uint32_t>(counts.size()));
        content.put(counts.view());
        ByteWriter record;
        putRecord(record, McapOp::Statistics, content.view());
        return record;
    }

    void writeSummary() {
        const std::uint64_t summaryAt = m_file.sizeBytes();
        ByteWriter summary;
        ByteWriter offsets;
        const auto group = [&](McapOp op, const ByteWriter& records) {
            ByteWriter offset;
            offset.number(static_cast<std::uint8_t>(op));
            offset.number(summaryAt + summary.size());
            offset.number(std::uint64_t{records.size()});
            putRecord(offsets, McapOp::SummaryOffset, offset.view());
            summary.put(records.view());
        };
        group(McapOp::Schema, m_schemas);
        group(McapOp::Channel, m_channels);
        group(McapOp::Statistics, statistics());
        group(McapOp::ChunkIndex, m_chunkIndexes);
        const std::uint64_t offsetsAt = summaryAt + summary.size();
        summary.put(offsets.view());
        constexpr std::uint64_t kFooterBytes = 8 + 8 + 4;
        putRecordHead(summary, McapOp::Footer, kFooterBytes);
        summary.number(summaryAt);
        summary.number(offsetsAt);
        summary.number(crcOf(summary.view())); // the checksum of the summary up to here
        summary.put(bytesOf(kMagic));
        m_file.write(summary.view());
    }

    DurableFile m_file;
    std::uint32_t m_crc = 0;               ///< Checksum of all that is in the file.
    std::vector<std::uint64_t> m_messages; ///< Number of messages of each topic.
    TimeRange m_times;
    Chunk m_chunk;
    std::uint32_t m_chunks = 0;
    ByteWriter m_schemas;
    ByteWriter m_channels;
    ByteWriter m_chunkIndexes;
};

} // namespace

std::unique_ptr<Bag> makeMcap(const std::filesystem::path& file) {
    return std::make_unique<Mcap>(file);
}

} // namespace spherewalk::dataset
