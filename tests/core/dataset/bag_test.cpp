// SPDX-License-Identifier: GPL-3.0-or-later
#include "byte_reader.h"
#include "expect_error.h"
#include "random.h"
#include "temporary_folder.h"

#include "spherewalk/base/file.h"
#include "spherewalk/dataset/bag.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <tuple>
#include <vector>

namespace spherewalk::dataset {

using test::ByteReader;
using test::expectError;

namespace {

struct BagMessage {
    std::size_t topic = 0;
    std::int64_t timeNs = 0;
    Bytes bytes;

    friend bool operator==(const BagMessage&, const BagMessage&) = default;
};

constexpr std::size_t kTopics = 3;

/// Messages of all sizes for three topics, enough for several chunks.
std::vector<BagMessage> someMessages(unsigned seed) {
    test::Random random(seed);
    std::vector<BagMessage> messages;
    for (int i = 0; i < 60; ++i) {
        BagMessage message;
        message.topic = static_cast<std::size_t>(random.integer(0, kTopics - 1));
        message.timeNs = 1'700'000'000'000'000'000 + random.integer(0, 1'000'000'000);
        message.bytes.resize(static_cast<std::size_t>(random.integer(0, 1 << random.integer(0, 17))));
        for (std::uint8_t& byte : message.bytes) {
            byte = static_cast<std::uint8_t>(random.integer(0, 255));
        }
        messages.push_back(std::move(message));
    }
    messages[10].bytes.assign(1'500'000, 7); // longer than a chunk
    messages[30].bytes.assign(1'200'000, 9);
    return messages;
}

Bytes writtenBag(BagFormat format, const std::vector<BagMessage>& messages) {
    const test::TemporaryFolder folder;
    const auto file = folder / "bäg";
    const std::unique_ptr<Bag> bag = makeBag(format, file);
    std::vector<std::size_t> topics;
    for (const auto& [name, type] : {std::pair("/image", RosType::Image),
                                     {"/pose", RosType::PoseStamped},
                                     {"/tf", RosType::TfMessage}}) {
        topics.push_back(bag->addTopic(name, type));
    }
    for (const BagMessage& message : messages) {
        bag->write(topics[message.topic], message.timeNs, message.bytes);
    }
    bag->finish();
    return readFile(file);
}

struct McapRecord {
    std::uint64_t op = 0;
    std::size_t at = 0;
    ByteView content;
};

McapRecord nextRecord(ByteReader& reader) {
    McapRecord record;
    record.at = reader.at();
    record.op = reader.number(1);
    record.content = reader.take(reader.number(8));
    return record;
}

/// The records between the magic bytes of an MCAP file.
std::vector<McapRecord> recordsOf(const Bytes& file) {
    ByteReader reader(ByteView(file).first(file.size() - 8));
    EXPECT_EQ(textOf(reader.take(8)), "\x89MCAP0\r\n");
    EXPECT_EQ(textOf(ByteView(file).last(8)), "\x89MCAP0\r\n");
    std::vector<McapRecord> records;
    while (!reader.atEnd()) {
        records.push_back(nextRecord(reader));
    }
    return records;
}

/// The records of a chunk, after its checksum was compared.
ByteView chunkRecords(const McapRecord& chunk) {
    ByteReader reader(chunk.content);
    reader.take(16); // times
    const std::uint64_t size = reader.number(8);
    const std::uint64_t crc = reader.number(4);
    EXPECT_EQ(reader.sized(), ""); // not compressed
    const ByteView records = reader.take(reader.number(8));
    EXPECT_EQ(records.size(), size);
    EXPECT_EQ(crc, test::crc32(records));
    EXPECT_TRUE(reader.atEnd());
    return records;
}

BagMessage messageOf(const McapRecord& record) {
    EXPECT_EQ(record.op, 5U);
    ByteReader reader(record.content);
    BagMessage message;
    message.topic = reader.number(2) - 1;
    reader.take(4); // its number in the topic
    message.timeNs = static_cast<std::int64_t>(reader.number(8));
    EXPECT_EQ(reader.number(8), static_cast<std::uint64_t>(message.timeNs));
    const ByteView bytes = reader.take(record.content.size() - reader.at());
    message.bytes.assign(bytes.begin(), bytes.end());
    return message;
}

std::vector<McapRecord> recordsWith(const std::vector<McapRecord>& records, std::uint64_t op) {
    std::vector<McapRecord> result;
    std::copy_if(records.begin(), records.end(), std::back_inserter(result),
                 [&](const McapRecord& record) { return record.op == op; });
    return result;
}

/// A record of a rosbag: its named values and its data.
struct RosRecord {
    std::size_t at = 0;
    std::map<std::string, std::string> fields;
    ByteView data;

    std::uint64_t number(const std::string& name) const {
        const std::string& value = fields.at(name);
        return ByteReader(bytesOf(value)).number(value.size());
    }

    std::int64_t timeNs(const std::string& name) const {
        ByteReader reader(bytesOf(fields.at(name)));
        const auto seconds = static_cast<std::int64_t>(reader.number(4));
        return seconds * 1'000'000'000 + static_cast<std::int64_t>(reader.number(4));
    }
};

RosRecord nextRosRecord(ByteReader& reader) {
    RosRecord record;
    record.at = reader.at();
    ByteReader header(reader.take(reader.number(4)));
    while (!header.atEnd()) {
        const std::string field = header.sized();
        const std::size_t equals = field.find('=');
        record.fields[field.substr(0, equals)] = field.substr(equals + 1);
    }
    record.data = reader.take(reader.number(4));
    return record;
}

std::vector<RosRecord> rosRecordsOf(ByteView bytes) {
    ByteReader reader(bytes);
    std::vector<RosRecord> records;
    while (!reader.atEnd()) {
        records.push_back(nextRosRecord(reader));
    }
    return records;
}

} // namespace

TEST(Mcap, GivesBackEveryMessageInItsOrder) {
    const std::vector<BagMessage> messages = someMessages(1);
    std::vector<BagMessage> read;
    const Bytes file = writtenBag(BagFormat::Mcap, messages);
    const std::vector<McapRecord> chunks = recordsWith(recordsOf(file), 6);
    EXPECT_GT(chunks.size(), 2U);
    for (const McapRecord& chunk : chunks) {
        for (ByteReader reader(chunkRecords(chunk)); !reader.atEnd();) {
            read.push_back(messageOf(nextRecord(reader)));
        }
    }
    EXPECT_TRUE(read == messages);
}

TEST(Mcap, EachIndexLeadsToAMessageOfItsTopicAndTime) {
    const std::vector<BagMessage> messages = someMessages(2);
    const Bytes file = writtenBag(BagFormat::Mcap, messages);
    ByteView chunk;
    std::size_t indexed = 0;
    for (const McapRecord& record : recordsOf(file)) {
        chunk = record.op == 6 ? chunkRecords(record) : chunk;
        if (record.op != 7) {
            continue;
        }
        ByteReader index(record.content);
        const std::uint64_t channel = index.number(2);
        ASSERT_EQ(index.number(4), record.content.size() - 6);
        for (; !index.atEnd(); ++indexed) {
            const auto time = static_cast<std::int64_t>(index.number(8));
            ByteReader reader(chunk);
            reader.moveTo(index.number(8));
            const BagMessage message = messageOf(nextRecord(reader));
            EXPECT_EQ(message.topic + 1, channel);
            EXPECT_EQ(message.timeNs, time);
        }
    }
    EXPECT_EQ(indexed, messages.size());
}

TEST(Mcap, ChunkIndexesLeadToTheirChunksAndMessageIndexes) {
    const Bytes file = writtenBag(BagFormat::Mcap, someMessages(3));
    const std::vector<McapRecord> records = recordsOf(file);
    const std::vector<McapRecord> chunks = recordsWith(records, 6);
    const std::vector<McapRecord> indexes = recordsWith(records, 8);
    ASSERT_EQ(indexes.size(), chunks.size());
    for (std::size_t i = 0; i < chunks.size(); ++i) {
        ByteReader reader(indexes[i].content);
        EXPECT_EQ(textOf(reader.take(16)), textOf(chunks[i].content.first(16))); // its times
        EXPECT_EQ(reader.number(8), chunks[i].at);
        EXPECT_EQ(reader.number(8), chunks[i].content.size() + 9);
        ByteReader places(reader.take(reader.number(4)));
        while (!places.atEnd()) {
            const std::uint64_t channel = places.number(2);
            ByteReader there{ByteView(file)};
            there.moveTo(places.number(8));
            const McapRecord index = nextRecord(there);
            EXPECT_EQ(index.op, 7U);
            EXPECT_EQ(ByteReader(index.content).number(2), channel);
        }
    }
}

TEST(Mcap, ChecksumsCoverTheDataAndTheSummary) {
    const Bytes file = writtenBag(BagFormat::Mcap, someMessages(4));
    const std::vector<McapRecord> records = recordsOf(file);
    const McapRecord end = recordsWith(records, 0x0f).at(0);
    EXPECT_EQ(ByteReader(end.content).number(4), test::crc32(ByteView(file).first(end.at)));
    const McapRecord footer = records.back();
    ASSERT_EQ(footer.op, 2U);
    ByteReader reader(footer.content);
    const std::uint64_t summaryAt = reader.number(8);
    const std::uint64_t offsetsAt = reader.number(8);
    EXPECT_EQ(summaryAt, end.at + 9 + 4);
    const std::size_t covered = footer.at + 9 + 16 - summaryAt;
    EXPECT_EQ(reader.number(4), test::crc32(ByteView(file).subspan(summaryAt, covered)));
    for (const McapRecord& offset : recordsWith(records, 0x0e)) {
        EXPECT_GE(offset.at, offsetsAt);
        ByteReader group(offset.content);
        const std::uint64_t op = group.number(1);
        const std::uint64_t begin = group.number(8);
        const std::uint64_t size = group.number(8);
        for (ByteReader inside(ByteView(file).subspan(begin, size)); !inside.atEnd();) {
            EXPECT_EQ(nextRecord(inside).op, op);
        }
    }
}

TEST(Mcap, StatisticsCountMessagesOfEachTopic) {
    const std::vector<BagMessage> messages = someMessages(5);
    const Bytes file = writtenBag(BagFormat::Mcap, messages);
    ByteReader reader(recordsWith(recordsOf(file), 0x0b).at(0).content);
    EXPECT_EQ(reader.number(8), messages.size());
    EXPECT_EQ(reader.number(2), kTopics);
    EXPECT_EQ(reader.number(4), kTopics);
    EXPECT_EQ(reader.number(8), 0U); // attachments and metadata
    EXPECT_EQ(reader.number(4), recordsWith(recordsOf(file), 6).size());
    const auto [first, last] = std::minmax_element(
        messages.begin(), messages.end(), [](const auto& a, const auto& b) { return a.timeNs < b.timeNs; });
    EXPECT_EQ(static_cast<std::int64_t>(reader.number(8)), first->timeNs);
    EXPECT_EQ(static_cast<std::int64_t>(reader.number(8)), last->timeNs);
    ASSERT_EQ(reader.number(4), kTopics * 10);
    for (std::size_t topic = 0; topic < kTopics; ++topic) {
        EXPECT_EQ(reader.number(2), topic + 1);
        EXPECT_EQ(static_cast<std::ptrdiff_t>(reader.number(8)),
                  std::count_if(messages.begin(), messages.end(),
                                [&](const BagMessage& message) { return message.topic == topic; }));
    }
}

TEST(Mcap, DescribesItsTopicsBeforeTheMessagesAndInTheSummary) {
    const Bytes file = writtenBag(BagFormat::Mcap, someMessages(6));
    const std::vector<McapRecord> channels = recordsWith(recordsOf(file), 4);
    ASSERT_EQ(channels.size(), 2 * kTopics);
    EXPECT_LT(channels[kTopics - 1].at, recordsWith(recordsOf(file), 6).at(0).at);
    ByteReader reader(channels[1].content);
    EXPECT_EQ(reader.number(2), 2U);
    EXPECT_EQ(reader.number(2), 2U);
    EXPECT_EQ(reader.sized(), "/pose");
    EXPECT_EQ(reader.sized(), "cdr");
    ByteReader schema(recordsWith(recordsOf(file), 3).at(1).content);
    EXPECT_EQ(schema.number(2), 2U);
    EXPECT_EQ(schema.sized(), "geometry_msgs/msg/PoseStamped");
    EXPECT_EQ(schema.sized(), "ros2msg");
    EXPECT_EQ(schema.sized(), rosSchema(Ros::Two, RosType::PoseStamped).definition);
}

TEST(Rosbag, GivesBackEveryMessageAndItsHeaderLeadsToTheIndex) {
    const std::vector<BagMessage> messages = someMessages(7);
    const Bytes file = writtenBag(BagFormat::Rosbag, messages);
    ASSERT_EQ(textOf(ByteView(file).first(13)), "#ROSBAG V2.0\n");
    const std::vector<RosRecord> records = rosRecordsOf(ByteView(file).subspan(13));
    const RosRecord& header = records.at(0);
    EXPECT_EQ(header.number("op"), 3U);
    EXPECT_EQ(header.number("conn_count"), kTopics);
    std::vector<BagMessage> read;
    std::vector<std::size_t> chunksAt;
    for (const RosRecord& record : records) {
        if (record.number("op") != 5) {
            continue;
        }
        chunksAt.push_back(record.at + 13);
        EXPECT_EQ(record.fields.at("compression"), "none");
        EXPECT_EQ(record.number("size"), record.data.size());
        for (const RosRecord& inside : rosRecordsOf(record.data)) {
            if (inside.number("op") == 2) {
                read.push_back({inside.number("conn"), inside.timeNs("time"),
                                Bytes(inside.data.begin(), inside.data.end())});
            }
        }
    }
    EXPECT_TRUE(read == messages);
    EXPECT_EQ(header.number("chunk_count"), chunksAt.size());
    EXPECT_GT(chunksAt.size(), 2U);
    std::size_t chunk = 0;
    std::size_t connections = 0;
    for (const RosRecord& record : rosRecordsOf(ByteView(file).subspan(header.number("index_pos")))) {
        if (record.number("op") == 7) {
            ++connections;
            continue;
        }
        ASSERT_EQ(record.number("op"), 6U);
        EXPECT_EQ(record.number("chunk_pos"), chunksAt.at(chunk++));
        EXPECT_LE(record.timeNs("start_time"), record.timeNs("end_time"));
        EXPECT_EQ(record.data.size(), 8 * record.number("count"));
    }
    EXPECT_EQ(chunk, chunksAt.size());
    EXPECT_EQ(connections, kTopics);
}

TEST(Rosbag, EachIndexLeadsToAMessageOfItsTopicAndTime) {
    const std::vector<BagMessage> messages = someMessages(8);
    const Bytes file = writtenBag(BagFormat::Rosbag, messages);
    ByteView chunk;
    std::size_t indexed = 0;
    for (const RosRecord& record : rosRecordsOf(ByteView(file).subspan(13))) {
        chunk = record.number("op") == 5 ? record.data : chunk;
        if (record.number("op") != 4) {
            continue;
        }
        ASSERT_EQ(record.data.size(), 12 * record.number("count"));
        for (ByteReader index(record.data); !index.atEnd(); ++indexed) {
            const auto seconds = static_cast<std::int64_t>(index.number(4));
            const auto rest = static_cast<std::int64_t>(index.number(4));
            ByteReader reader(chunk);
            reader.moveTo(index.number(4));
            const RosRecord message = nextRosRecord(reader);
            EXPECT_EQ(message.number("op"), 2U);
            EXPECT_EQ(message.number("conn"), record.number("conn"));
            EXPECT_EQ(message.timeNs("time"), seconds * 1'000'000'000 + rest);
        }
    }
    EXPECT_EQ(indexed, messages.size());
}

TEST(Rosbag, DescribesEachTopicBeforeItsFirstMessage) {
    const Bytes file = writtenBag(BagFormat::Rosbag, someMessages(9));
    std::map<std::uint64_t, std::string> known;
    for (const RosRecord& chunk : rosRecordsOf(ByteView(file).subspan(13))) {
        if (chunk.number("op") != 5) {
            continue;
        }
        for (const RosRecord& record : rosRecordsOf(chunk.data)) {
            if (record.number("op") == 2) {
                EXPECT_TRUE(known.contains(record.number("conn")));
            } else {
                known[record.number("conn")] = record.fields.at("topic");
            }
        }
    }
    EXPECT_EQ(known, (std::map<std::uint64_t, std::string>{{0, "/image"}, {1, "/pose"}, {2, "/tf"}}));
}

TEST(Bag, WithoutMessagesIsStillWhole) {
    const Bytes mcap = writtenBag(BagFormat::Mcap, {});
    EXPECT_TRUE(recordsWith(recordsOf(mcap), 6).empty());
    EXPECT_EQ(recordsWith(recordsOf(mcap), 4).size(), 2 * kTopics);
    const Bytes rosbag = writtenBag(BagFormat::Rosbag, {});
    const std::vector<RosRecord> records = rosRecordsOf(ByteView(rosbag).subspan(13));
    EXPECT_EQ(records.at(0).number("chunk_count"), 0U);
    EXPECT_EQ(records.size(), 1 + kTopics);
}

TEST(Bag, AppearsOnlyWhenItIsFinishedAndReplacesAnEarlierOne) {
    for (const BagFormat format : {BagFormat::Rosbag, BagFormat::Mcap}) {
        const test::TemporaryFolder folder;
        const auto file = folder / "bag";
        writeFile(file, bytesOf("earlier"));
        {
            const std::unique_ptr<Bag> dropped = makeBag(format, file);
            dropped->write(dropped->addTopic("/a", RosType::Image), 1, Bytes(2'000'000));
        }
        EXPECT_EQ(textOf(readFile(file)), "earlier");
        EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
        makeBag(format, file)->finish();
        EXPECT_NE(textOf(readFile(file)), "earlier");
    }
}

TEST(Bag, FormatsHaveWordsThatAreReadBack) {
    for (const BagFormat format : {BagFormat::Rosbag, BagFormat::Mcap}) {
        EXPECT_EQ(bagFormat(name(format)), format);
    }
    EXPECT_EQ(extension(BagFormat::Rosbag), "bag");
    EXPECT_EQ(extension(BagFormat::Mcap), "mcap");
    expectError(ErrorKind::InvalidInput, "rosbag", [] { bagFormat("zip"); });
}

} // namespace spherewalk::dataset
