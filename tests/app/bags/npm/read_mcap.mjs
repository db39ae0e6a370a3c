// SPDX-License-Identifier: GPL-3.0-or-later
// Reads an MCAP file with the format's own library: once as a stream with all checksums compared, then by its index.
// Prints a JSON object a message, in the order of their times.
// Usage: node read_mcap.mjs FILE
import { open } from "node:fs/promises";
import { McapIndexedReader, McapStreamReader } from "@mcap/core";
import { parse } from "@foxglove/rosmsg";
import { MessageReader } from "@foxglove/rosmsg2-serialization";

const file = await open(process.argv[2]);
const bytes = await file.readFile();

const stream = new McapStreamReader({ validateCrcs: true });
stream.append(bytes);
let streamed = 0;
for (let record; (record = stream.nextRecord()) != undefined; ) {
  streamed += record.type === "Message" ? 1 : 0;
}
if (!stream.done()) {
  throw new Error("the file ends too early");
}

const reader = await McapIndexedReader.Initialize({
  readable: {
    size: async () => BigInt(bytes.length),
    read: async (offset, size) => bytes.subarray(Number(offset), Number(offset + size)),
  },
});
const decoders = new Map();
for (const channel of reader.channelsById.values()) {
  const schema = reader.schemasById.get(channel.schemaId);
  const definition = parse(new TextDecoder().decode(schema.data), { ros2: true });
  decoders.set(channel.id, { topic: channel.topic, type: schema.name, reader: new MessageReader(definition) });
}
const plain = (key, value) =>
  value instanceof Uint8Array ? Buffer.from(value).toString("base64")
  : ArrayBuffer.isView(value) ? Array.from(value)
  : value;
let indexed = 0;
for await (const message of reader.readMessages()) {
  const { topic, type, reader: decoder } = decoders.get(message.channelId);
  const line = { topic, type, time_ns: Number(message.logTime), message: decoder.readMessage(message.data) };
  console.log(JSON.stringify(line, plain));
  ++indexed;
}
if (indexed !== streamed || BigInt(indexed) !== reader.statistics.messageCount) {
  throw new Error(`${streamed} messages, ${indexed} in the index, ${reader.statistics.messageCount} counted`);
}
