# SPDX-License-Identifier: GPL-3.0-or-later
# Reads an MCAP file as its specification (mcap.dev/spec) says: backwards from the footer to the index, from there to the
# messages, all checksums compared. Messages are decoded by the definitions in the file. Prints a JSON object a message.
# Usage: python3 read_mcap.py FILE
import base64
import json
import struct
import sys
import zlib

MAGIC = b"\x89MCAP0\r\n"


class Fields:
    """Numbers, texts and maps, one after the other."""

    def __init__(self, data):
        self.data, self.at = data, 0

    def number(self, kind):
        (value,) = struct.unpack_from("<" + kind, self.data, self.at)
        self.at += struct.calcsize(kind)
        return value

    def take(self, size):
        assert self.at + size <= len(self.data), "a record is too short"
        self.at += size
        return self.data[self.at - size : self.at]

    def text(self):
        return self.take(self.number("I")).decode()

    def pairs(self, key, value):
        inner = Fields(self.take(self.number("I")))
        found = []
        while inner.at < len(inner.data):
            found.append((inner.number(key), inner.number(value)))
        return found


def records(data):
    fields = Fields(data)
    while fields.at < len(data):
        yield fields.number("B"), Fields(fields.take(fields.number("Q")))


class Cdr:
    """Messages in CDR, by definitions in ROS's own words."""

    SIZES = {"bool": "?", "uint8": "B", "int32": "i", "uint32": "I", "float64": "d"}

    def __init__(self, name, definition):
        first, *others = definition.split("=" * 80 + "\nMSG: ")
        self.types = {"": [line.split() for line in first.splitlines()]}
        for other in others:
            head, *lines = other.splitlines()
            self.types[head] = [line.split() for line in lines]

    def decode(self, data):
        assert data[:4] == b"\0\1\0\0", "not little-endian CDR"
        self.data, self.at = data[4:], 0
        message = self.struct("")
        assert self.at == len(self.data), "bytes are left over"
        return message

    def struct(self, name):
        return {field: self.value(kind) for kind, field in self.types[name]}

    def value(self, kind):
        if kind.endswith("]"):
            element, count = kind[:-1].split("[")
            count = int(count) if count else self.one("uint32")
            if element == "uint8":
                self.at += count
                return base64.b64encode(self.data[self.at - count : self.at]).decode()
            return [self.value(element) for _ in range(count)]
        return self.struct(kind) if "/" in kind else self.one(kind)

    def one(self, kind):
        if kind == "string":
            size = self.one("uint32")
            text = self.data[self.at : self.at + size]
            assert text[-1:] == b"\0", "a string without an end"
            self.at += size
            return text[:-1].decode()
        size = struct.calcsize(self.SIZES[kind])
        self.at = (self.at + size - 1) // size * size
        (value,) = struct.unpack_from("<" + self.SIZES[kind], self.data, self.at)
        self.at += size
        return value


def read_summary(data):
    assert data[:8] == MAGIC and data[-8:] == MAGIC, "no magic"
    footer = Fields(data[-8 - 29 : -8])
    assert footer.number("B") == 2 and footer.number("Q") == 20
    summary_at, offsets_at, crc = footer.number("Q"), footer.number("Q"), footer.number("I")
    assert zlib.crc32(data[summary_at:-12]) == crc, "the summary's checksum is wrong"
    data_end = Fields(data[summary_at - 13 : summary_at])
    assert data_end.number("B") == 15 and data_end.number("Q") == 4
    assert zlib.crc32(data[: summary_at - 13]) == data_end.number("I"), "the data's checksum is wrong"
    for op, group in records(data[offsets_at : -8 - 29]):
        assert op == 14
        group_op, start, length = group.number("B"), group.number("Q"), group.number("Q")
        assert {op for op, _ in records(data[start : start + length])} <= {group_op}
    return list(records(data[summary_at:offsets_at]))


def read_chunk(data, index):
    begin, end, at, size = (index.number("Q") for _ in range(4))
    places = index.pairs("H", "Q")
    op, chunk = next(records(data[at : at + size]))
    assert op == 6 and (chunk.number("Q"), chunk.number("Q")) == (begin, end)
    size, crc = chunk.number("Q"), chunk.number("I")
    assert chunk.text() == "", "compressed"
    content = chunk.take(chunk.number("Q"))
    assert len(content) == size and zlib.crc32(content) == crc, "a chunk's checksum is wrong"
    for channel, place in places:
        (op, message_index) = next(records(data[place : place + 9 + struct.unpack_from("<Q", data, place + 1)[0]]))
        assert op == 7 and message_index.number("H") == channel
        for time, offset in message_index.pairs("Q", "Q"):
            size = struct.unpack_from("<Q", content, offset + 1)[0]
            op, message = next(records(content[offset : offset + 9 + size]))
            assert op == 5 and message.number("H") == channel and begin <= time <= end
            message.number("I")
            assert message.number("Q") == time
            message.number("Q")
            yield time, channel, message.data[message.at :]


def main():
    with open(sys.argv[1], "rb") as file:
        data = file.read()
    decoders, channels, found, counted = {}, {}, [], None
    for op, record in read_summary(data):
        if op == 3:
            number, name, encoding = record.number("H"), record.text(), record.text()
            assert encoding == "ros2msg"
            decoders[number] = (name, Cdr(name, record.text()))
        elif op == 4:
            number, schema, topic, encoding = record.number("H"), record.number("H"), record.text(), record.text()
            assert encoding == "cdr"
            channels[number] = (topic, *decoders[schema])
        elif op == 8:
            found += read_chunk(data, record)
        elif op == 11:
            counted = record.number("Q")
    assert counted == len(found), f"{counted} messages counted, {len(found)} found"
    for time, channel, message in sorted(found, key=lambda one: one[0]):
        topic, name, decoder = channels[channel]
        print(json.dumps({"topic": topic, "type": name, "time_ns": time, "message": decoder.decode(message)}))


main()
