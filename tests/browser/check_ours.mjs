// Reads MCAP files of ours with other people's code: check_ours.mjs PACKAGES FILE...
// Every checksum is compared, every message decoded by the schema in the file, and every schema compared
// with the public definition of its type.
import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { open, readFile } from "node:fs/promises";
import { makeDecoders } from "./decoders.mjs";

const [packages, ...files] = process.argv.slice(2);
const require = createRequire(`${packages}/`);
const { McapIndexedReader, McapStreamReader } = require("@mcap/core");
const zstd = require("@foxglove/wasm-zstd");
const lz4 = require("@foxglove/wasm-lz4");

await Promise.all([zstd.isLoaded, lz4.isLoaded]);
const decompressHandlers = {
  zstd: (bytes, size) => zstd.decompress(bytes, Number(size)),
  lz4: (bytes, size) => lz4(bytes, Number(size)),
};
// From the first byte to the last, as from a pipe.
async function stream(file) {
  const reader = new McapStreamReader({ validateCrcs: true, decompressHandlers });
  reader.append(await readFile(file));
  let messages = 0;
  for (let record; (record = reader.nextRecord()); ) if (record.type === "Message") ++messages;
  assert.ok(reader.done(), `${file} is read to its end`);
  return messages;
}

// By its index; all messages by topic.
async function indexed(file) {
  const handle = await open(file);
  const size = BigInt((await handle.stat()).size);
  const readable = {
    size: async () => size,
    read: async (offset, length) => {
      const bytes = new Uint8Array(Number(length));
      await handle.read(bytes, 0, bytes.length, Number(offset));
      return bytes;
    },
  };
  const reader = await McapIndexedReader.Initialize({ readable, decompressHandlers });
  assert.equal(reader.header.profile, "ros2");
  const decoders = makeDecoders(require);
  const topics = new Map();
  let last = 0n;
  for await (const message of reader.readMessages({ validateCrcs: true })) {
    assert.ok(message.logTime >= last, "messages are in order");
    last = message.logTime;
    const channel = reader.channelsById.get(message.channelId);
    const value = decoders.decode(channel, reader.schemasById.get(channel.schemaId), message.data);
    if (!topics.has(channel.topic)) topics.set(channel.topic, []);
    topics.get(channel.topic).push({ value, logTime: message.logTime });
  }
  const attachments = new Map();
  for await (const one of reader.readAttachments()) attachments.set(one.name, one.data.length);
  const metadata = [];
  for await (const one of reader.readMetadata()) metadata.push(one);
  await handle.close();
  return { reader, topics, attachments, metadata };
}

function checkValues({ topics, attachments, metadata }) {
  const all = (topic) => topics.get(topic)?.map(({ value }) => value) ?? [];
  const cycles = all("/striate/cycle");
  assert.ok(cycles.length > 30, `${cycles.length} cycles`);
  assert.deepEqual(cycles.map(({ number }) => number), cycles.map((_, k) => k + 1));
  for (const topic of ["/tf", "/odom", "/cmd_vel", "/striate/wish", "/pose"]) {
    assert.equal(all(topic).length, cycles.length, topic);
  }
  const odom = all("/odom").at(-1).pose.pose.position;
  const tf = all("/tf").at(-1).transforms.find((t) => t.child_frame_id === "base_link");
  assert.deepEqual([odom.x, odom.y], [tf.transform.translation.x, tf.transform.translation.y]);
  assert.ok(odom.x > 1.5 && odom.x < 3.0, `driven to x = ${odom.x} m`);
  for (const side of ["left", "right"]) {
    const images = all(`/camera/${side}/image/compressed`);
    const infos = all(`/camera/${side}/camera_info`);
    assert.equal(images.length, infos.length);
    assert.ok(images.length > 30, side);
    for (const [k, { format, data }] of images.entries()) {
      assert.equal(format, "png");
      const view = new DataView(data.buffer, data.byteOffset);
      assert.deepEqual([view.getUint32(16), view.getUint32(20)], [infos[k].width, infos[k].height]);
    }
    assert.ok(infos[0].k[0] > 100, "a focal length in pixels");
  }
  const disparity = all("/stereo/disparity").at(-1);
  assert.equal(disparity.image.data.length, disparity.image.step * disparity.image.height);
  assert.ok(disparity.max_disparity > 1);
  const grid = all("/map/local").at(-1);
  assert.equal(grid.data.length, grid.info.width * grid.info.height);
  for (const value of [-1, 0, 100]) assert.ok(grid.data.includes(value), `${value} in the map`);
  const cloud = all("/sonar").at(-1);
  assert.equal(cloud.data.length, cloud.row_step * cloud.height);
  assert.ok(all("/scan").at(-1).ranges.some((range) => range > 0.1 && range < 30));
  assert.ok(all("/battery").at(-1).voltage > 10);
  assert.ok(all("/trajectory").at(-1).poses.length > 4);
  assert.equal(all("/striate/task")[0].tree.title, "task corridor");
  assert.ok(all("/log").some(({ msg }) => msg.startsWith("traverse_corridor")));
  assert.ok(all("/diagnostics")[0].status[0].values.length > 5);
  assert.equal(all("/obstacles").length, all("/stereo/disparity").length);
  for (const topic of ["/map/global", "/route", "/landmarks", "/saliency", "/striate/memory/short_term"]) {
    assert.ok(all(topic).length > 0, topic);
  }
  assert.ok([...attachments.keys()].some((name) => name.startsWith("task/")), "the task is attached");
  assert.ok(attachments.has("settings.txt"));
  assert.equal(metadata[0].metadata.get("seed"), "3");
}

for (const file of files) {
  const found = await indexed(file);
  const messages = await stream(file);
  assert.equal(BigInt(messages), found.reader.statistics.messageCount);
  checkValues(found);
  console.log(`${file.split("/").at(-1)}: ${messages} messages of ${found.topics.size} topics, all as they should be`);
}
