// Writes an MCAP file with other people's code: write_theirs.mjs PACKAGES FILE zstd|lz4|none
// Prints what it has written, as mcap_listing prints what it reads.
import { createRequire } from "node:module";
import { open } from "node:fs/promises";

const [packages, file, compression] = process.argv.slice(2);
const require = createRequire(`${packages}/`);
const { McapWriter } = require("@mcap/core");
const { crc32 } = require("@foxglove/crc");
const { parse } = require("@foxglove/rosmsg");
const { MessageWriter } = require("@foxglove/rosmsg2-serialization");
const zstd = require("@foxglove/wasm-zstd");
const lz4 = require("lz4js");
await zstd.isLoaded;
const compress = { zstd: (bytes) => zstd.compress(bytes), lz4: (bytes) => lz4.compress(bytes) }[compression];

const handle = await open(file, "w");
let position = 0n;
const writable = {
  position: () => position,
  write: async (bytes) => {
    await handle.write(bytes);
    position += BigInt(bytes.byteLength);
  },
};
const writer = new McapWriter({
  writable,
  chunkSize: 2000,
  compressChunk: compress && ((bytes) => ({ compression, compressedData: compress(bytes) })),
});
await writer.start({ profile: "ros2", library: "theirs" });
const definition = "std_msgs/Header header\nstring[] names\nfloat64[] position\n" + "=".repeat(80) +
  "\nMSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n" + "=".repeat(80) +
  "\nMSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n";
const messages = new MessageWriter(parse(definition, { ros2: true }));
const schemaId = await writer.registerSchema({
  name: "test_msgs/msg/Joints", encoding: "ros2msg", data: new TextEncoder().encode(definition),
});
const channelIds = [];
for (const topic of ["/joints", "/other"]) {
  channelIds.push(await writer.registerChannel({
    topic, schemaId, messageEncoding: "cdr", metadata: new Map([["made by", "node"]]),
  }));
}
for (let k = 0; k < 200; ++k) {
  const data = messages.writeMessage({
    header: { stamp: { sec: k, nanosec: 5 }, frame_id: "x".repeat(k % 7) },
    names: Array.from({ length: k % 4 }, (_, i) => "n".repeat(i)),
    position: Array.from({ length: k % 3 }, (_, i) => k + i / 3),
  });
  const logTime = BigInt(k) * 1000n;
  await writer.addMessage({ channelId: channelIds[k % 2], sequence: k, logTime, publishTime: logTime, data });
  console.log(`${["/joints", "/other"][k % 2]} test_msgs/msg/Joints ${k} ${logTime} ${data.length} ${crc32(data)}`);
}
const attached = new TextEncoder().encode("a file within the file");
await writer.addAttachment({
  name: "note.txt", mediaType: "text/plain", logTime: 0n, createTime: 0n, data: attached,
});
await writer.addMetadata({ name: "about", metadata: new Map([["by", "@mcap/core"]]) });
await writer.end();
await handle.close();
console.log(`attachment note.txt ${attached.length} ${crc32(attached)}`);
console.log("metadata about by=@mcap/core");
console.log("closed");
