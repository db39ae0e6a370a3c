// SPDX-License-Identifier: GPL-3.0-or-later
// Source: the bag format 2.0 of ROS 1 (wiki.ros.org/Bags/Format/2.0). Its own library would make the program
// depend on half of ROS.
#include "bag_chunk.h"

#include "spherewalk/base/enum_names.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"

#include <fstream>

namespace spherewalk::dataset {

namespace {

constexpr std::string_view kVersion = "#ROSBAG V2.0\n";
constexpr std::size_t kFileHeaderBytes = 4096;
constexpr std::int64_t kNsASecond = 1'000'000'000;

enum class BagOp : std::uint8_t { Message = 2, FileHeader, Index, Chunk, ChunkInfo, Connection };

/// The named values in front of a record's data.
class Fields {
  public:
    Fields() = default;

    explicit Fields(BagOp op) { number("op", static_cast<std::uint8_t>(op)); }

    template <class Number>
    Fields& number(std::string_view name, Number value) {
        ByteWriter bytes;
        bytes.number(value);
        return field(name, bytes.view());
    }

    Fields& time(std::string_view name, std::int64_t timeNs) {
        ByteWriter bytes;
        putTime(bytes, timeNs);
        return field(name, bytes.view());
    }

    Fields& text(std::string_view name, std::string_view value) { return field(name, bytesOf(value)); }

    static void putTime(ByteWriter& out, std::int64_t timeNs) {
        out.number(static_cast<std::uint32_t>(timeNs / kNsASecond));
        out.number(static_cast<std::uint32_t>(timeNs % kNsASecond));
    }

    ByteView view() const { return m_bytes.view(); }

  private:
    Fields& field(std::string_view name, ByteView value) {
        m_bytes.number(static_cast<std::uint32_t>(name.size() + 1 + value.size()));
        m_bytes.put(bytesOf(name));
        m_bytes.put(bytesOf("="));
        m_bytes.put(value);
        return *this;
    }

    ByteWriter m_bytes;
};

void putSized(ByteWriter& out, ByteView bytes) {
    out.number(static_cast<std::uint32_t>(bytes.size()));
    out.put(bytes);
}

class Rosbag : public Bag {
  public:
    explicit Rosbag(const std::filesystem::path& file) : m_file(file) {
        m_file.write(bytesOf(kVersion));
        m_file.write(fileHeader(0));
    }

    std::size_t addTopic(const std::string& topic, RosType type) override {
        m_topics.push_back({topic, rosSchema(Ros::One, type)});
        return m_topics.size() - 1;
    }

    void write(std::size_t topic, std::int64_t timeNs, ByteView message) override {
        if (m_written.size() <= topic || !m_written[topic]) {
            m_written.resize(m_topics.size());
            m_written[topic] = true;
            putConnection(m_chunk.records, topic);
        }
        m_chunk.note(topic, timeNs);
        Fields fields(BagOp::Message);
        fields.number("conn", static_cast<std::uint32_t>(topic)).time("time", timeNs);
        putSized(m_chunk.records, fields.view());
        putSized(m_chunk.records, message);
        if (m_chunk.records.size() >= kChunkBytes) {
            writeChunk();
        }
    }

    void finish() override {
        if (!m_chunk.entries.empty()) {
            writeChunk();
        }
        const std::uint64_t indexAt = m_file.sizeBytes();
        ByteWriter index;
        for (std::size_t topic = 0; topic < m_topics.size(); ++topic) {
            putConnection(index, topic);
        }
        index.put(m_chunkInfos.view());
        m_file.write(index.view());
        replaceFileHeader(fileHeader(indexAt));
        m_file.commit(DurableFile::Overwrite::Yes);
    }

  private:
    struct Topic {
        std::string name;
        RosSchema schema;
    };

    /// The header is padded, so that finish() can write it again with the final numbers.
    Bytes fileHeader(std::uint64_t indexAt) const {
        Fields fields(BagOp::FileHeader);
        fields.number("index_pos", indexAt)
            .number("conn_count", static_cast<std::uint32_t>(m_topics.size()))
            .number("chunk_count", m_chunks);
        ByteWriter out;
        putSized(out, fields.view());
        putSized(out, Bytes(kFileHeaderBytes - fields.view().size(), ' '));
        return out.take();
    }

    void replaceFileHeader(const Bytes& header) const {
        std::fstream unfinished(m_file.temporaryName(), std::ios::in | std::ios::out | std::ios::binary);
        unfinished.seekp(static_cast<std::streamoff>(kVersion.size()));
        unfinished << textOf(header) << std::flush;
        if (!unfinished) {
            throw Error(ErrorKind::Io, ::spherewalk::text("Could not write ", m_file.temporaryName().string(),
                                                          "; is the disk full?"));
        }
    }

    void putConnection(ByteWriter& out, std::size_t topic) const {
        const Topic& one = m_topics[topic];
        Fields fields(BagOp::Connection);
        fields.number("conn", static_cast<std::uint32_t>(topic)).text("topic", one.name);
        Fields connection;
        connection.text("topic", one.name)
            .text("type", one.schema.name)
            .text("md5sum", one.schema.md5)
            .text("message_definition", one.schema.definition);
        putSized(out, fields.view());
        putSized(out, connection.view());
    }

    void writeChunk() {
        const std::uint64_t chunkAt = m_file.sizeBytes();
        ByteWriter head;
        Fields fields(BagOp::Chunk);
        fields.text("compression", "none").number("size", static_cast<std::uint32_t>(m_chunk.records.size()));
        putSized(head, fields.view());
        head.number(static_cast<std::uint32_t>(m_chunk.records.size()));
        m_file.write(head.view());
        m_file.write(m_chunk.records.view());
        ByteWriter indexes;
        ByteWriter counts;
        for (const auto& [topic, entries] : m_chunk.entries) {
            const auto connection = static_cast<std::uint32_t>(topic);
            const auto count = static_cast<std::uint32_t>(entries.size());
            counts.number(connection);
            counts.number(count);
            ByteWriter places;
            for (const ChunkEntry& entry : entries) {
                Fields::putTime(places, entry.timeNs);
                places.number(static_cast<std::uint32_t>(entry.offset));
            }
            putSized(indexes, Fields(BagOp::Index)
                                  .number("ver", std::uint32_t{1})
                                  .number("conn", connection)
                                  .number("count", count)
                                  .view());
            putSized(indexes, places.view());
        }
        m_file.write(indexes.view());
        putSized(m_chunkInfos, Fields(BagOp::ChunkInfo)
                                   .number("ver", std::uint32_t{1})
                                   .number("chunk_pos", chunkAt)
                                   .time("start_time", m_chunk.times.firstNs)
                                   .time("end_time", m_chunk.times.lastNs)
                                   .number("count", static_cast<std::uint32_t>(m_chunk.entries.size()))
                                   .view());
        putSized(m_chunkInfos, counts.view());
        ++m_chunks;
        m_chunk = {};
    }

    DurableFile m_file;
    std::vector<Topic> m_topics;
    std::vector<bool> m_written; ///< For each topic, whether a chunk describes it.
    Chunk m_chunk;
    ByteWriter m_chunkInfos;
    std::uint32_t m_chunks = 0;
};

} // namespace

std::unique_ptr<Bag> makeRosbag(const std::filesystem::path& file) {
    return std::make_unique<Rosbag>(file);
}

namespace {

constexpr EnumNames<BagFormat, 2> kBagFormats{{{BagFormat::Rosbag, "rosbag"}, {BagFormat::Mcap, "mcap"}}};

} // namespace

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
