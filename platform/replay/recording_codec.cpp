#include "striate/platform/replay/recording_codec.hpp"

#include "striate/platform/replay/recorded_image.hpp"

namespace striate::replay {
namespace {

enum class Images : std::uint8_t { none, written, same };

void put(ByteWriter& writer, const std::vector<NamedText>& list) {
  writer.put(static_cast<std::uint32_t>(list.size()));
  for (const auto& [name, text] : list) {
    writer.put_text(name);
    writer.put_text(text);
  }
}

std::vector<NamedText> take_named(ByteReader& reader) {
  std::vector<NamedText> list(reader.take_count(8));
  for (auto& [name, text] : list) {
    name = reader.take_text();
    text = reader.take_text();
  }
  return list;
}

/// Every length, speed and limit of a body, in the order of the file.
template <class Robot, class Each>
void each_number(Robot& r, Each each) {
  each(r.front_m);
  each(r.rear_m);
  each(r.half_width_m);
  each(r.max_forward_m_s);
  each(r.max_turn_rad_s);
  each(r.max_acceleration_m_s2);
  each(r.max_turn_acceleration_rad_s2);
  each(r.camera_height_m);
  each(r.camera_forward_m);
  each(r.max_pan_rad);
  each(r.max_tilt_rad);
}

/// What recordings hold of a body since it can be another than the Pioneer, behind all else; older
/// ones end before it.
template <class Robot, class Each>
void each_later_number(Robot& r, Each each) {
  each(r.corner_m);
  each(r.view_rad);
  each(r.resting_tilt_rad);
}

void put(ByteWriter& writer, TimePoint time) {
  writer.put(static_cast<std::int64_t>(time.time_since_epoch().count()));
}
TimePoint take_time(ByteReader& reader) {
  return TimePoint(Duration(reader.take<std::int64_t>()));
}

void put(ByteWriter& writer, const HeadPose& head) {
  writer.put(head.pan_rad);
  writer.put(head.tilt_rad);
}
HeadPose take_head(ByteReader& reader) {
  HeadPose head;
  head.pan_rad = reader.take<double>();
  head.tilt_rad = reader.take<double>();
  return head;
}

void put(ByteWriter& writer, const RangeScan& scan) {
  put(writer, scan.stamp);
  writer.put(static_cast<std::uint32_t>(scan.readings.size()));
  for (const RangeReading& one : scan.readings) {
    writer.put(one.bearing_rad);
    writer.put(one.distance_m);
  }
}
void take(ByteReader& reader, RangeScan& scan) {
  scan.stamp = take_time(reader);
  scan.readings.resize(reader.take_count(16));
  for (RangeReading& one : scan.readings) {
    one.bearing_rad = reader.take<double>();
    one.distance_m = reader.take<double>();
  }
}

void put(ByteWriter& writer, const MotorCommand& command) {
  writer.put(command.forward_m_s);
  writer.put(command.turn_rad_s);
  writer.put(command.pan_rad);
  writer.put(command.tilt_rad);
}
MotorCommand take_command(ByteReader& reader) {
  MotorCommand command;
  command.forward_m_s = reader.take<double>();
  command.turn_rad_s = reader.take<double>();
  command.pan_rad = reader.take<double>();
  command.tilt_rad = reader.take<double>();
  return command;
}

void put(ByteWriter& writer, const StereoFrame& frame, bool same_images) {
  put(writer, frame.stamp);
  writer.put(frame.focal_px);
  writer.put(frame.centre_u_px);
  writer.put(frame.centre_v_px);
  writer.put(frame.baseline_m);
  put(writer, frame.head);
  const Images pictures = same_images          ? Images::same
                          : frame.left.empty() ? Images::none
                                               : Images::written;
  writer.put(static_cast<std::uint8_t>(pictures));
  if (pictures != Images::written) return;
  put_image(writer, frame.left);
  put_image(writer, frame.right);
}

void take(ByteReader& reader, StereoFrame& frame) {
  frame.stamp = take_time(reader);
  frame.focal_px = reader.take<double>();
  frame.centre_u_px = reader.take<double>();
  frame.centre_v_px = reader.take<double>();
  frame.baseline_m = reader.take<double>();
  frame.head = take_head(reader);
  switch (static_cast<Images>(reader.take<std::uint8_t>())) {
    case Images::none:
      frame.left.release();
      frame.right.release();
      return;
    case Images::written:
      frame.left = take_image(reader);
      frame.right = take_image(reader);
      if (!frame.right.empty() && frame.right.size() != frame.left.size()) {
        throw BadBytes("left and right image differ in size");
      }
      return;
    case Images::same:
      if (frame.left.empty()) throw BadBytes("an image was to be the same as before, but is none");
      return;
  }
  throw BadBytes("an unknown kind of image");
}

void put(ByteWriter& writer, const Odometry& odometry) {
  put(writer, odometry.stamp);
  writer.put(odometry.pose.x_m);
  writer.put(odometry.pose.y_m);
  writer.put(odometry.pose.heading_rad);
  writer.put(odometry.forward_m_s);
  writer.put(odometry.turn_rad_s);
}
void take(ByteReader& reader, Odometry& odometry) {
  odometry.stamp = take_time(reader);
  odometry.pose.x_m = reader.take<double>();
  odometry.pose.y_m = reader.take<double>();
  odometry.pose.heading_rad = reader.take<double>();
  odometry.forward_m_s = reader.take<double>();
  odometry.turn_rad_s = reader.take<double>();
}

void put(ByteWriter& writer, const RecordedDecision& decision) {
  put(writer, decision.wish);
  writer.put(static_cast<std::int32_t>(decision.progress));
  put(writer, decision.wish_stamp);
  writer.put_text(decision.why);
  put(writer, decision.sent);
  writer.put_text(decision.limited_by);
  writer.put_text(decision.doing);
  writer.put(static_cast<std::uint8_t>(decision.interrupted));
}
void take(ByteReader& reader, RecordedDecision& decision) {
  decision.wish = take_command(reader);
  decision.progress = reader.take<std::int32_t>();
  decision.wish_stamp = take_time(reader);
  decision.why = reader.take_text();
  decision.sent = take_command(reader);
  decision.limited_by = reader.take_text();
  decision.doing = reader.take_text();
  decision.interrupted = reader.take_flag();
}

}  // namespace

std::vector<std::uint8_t> encode(const RecordedSetup& setup) {
  std::vector<std::uint8_t> payload;
  ByteWriter writer(payload);
  writer.put_text(setup.software);
  writer.put_text(setup.task);
  put(writer, setup.task_files);
  put(writer, setup.variables);
  writer.put(static_cast<std::uint8_t>(setup.memory_known));
  writer.put_block(setup.memory);
  writer.put_text(setup.robot_file);
  writer.put_text(setup.robot_text);
  put(writer, setup.settings);
  writer.put(static_cast<std::uint8_t>(setup.emergency_layer));
  writer.put_text(setup.world);
  writer.put(setup.seed);
  each_number(setup.robot, [&](double number) { writer.put(number); });
  writer.put(static_cast<std::int64_t>(setup.robot.cycle.count()));
  each_later_number(setup.robot, [&](double number) { writer.put(number); });
  return payload;
}

RecordedSetup decode_setup(std::span<const std::uint8_t> payload) {
  ByteReader reader(payload);
  RecordedSetup setup;
  setup.software = reader.take_text();
  setup.task = reader.take_text();
  setup.task_files = take_named(reader);
  setup.variables = take_named(reader);
  setup.memory_known = reader.take_flag();
  const auto memory = reader.take_block();
  setup.memory.assign(memory.begin(), memory.end());
  setup.robot_file = reader.take_text();
  setup.robot_text = reader.take_text();
  setup.settings = take_named(reader);
  setup.emergency_layer = reader.take_flag();
  setup.world = reader.take_text();
  setup.seed = reader.take<std::uint64_t>();
  each_number(setup.robot, [&](double& number) { number = reader.take<double>(); });
  setup.robot.cycle = Duration(reader.take<std::int64_t>());
  if (reader.left() > 0) {
    each_later_number(setup.robot, [&](double& number) { number = reader.take<double>(); });
  }
  reader.expect_end();
  return setup;
}

void encode(const RecordedCycle& cycle, bool same_images, std::vector<std::uint8_t>& payload) {
  payload.clear();
  ByteWriter writer(payload);
  const Senses& senses = cycle.senses;
  writer.put(cycle.number);
  put(writer, senses.now);
  put(writer, senses.stereo, same_images);
  put(writer, senses.odometry);
  put(writer, senses.sonar);
  put(writer, senses.laser);
  put(writer, senses.head);
  writer.put(senses.battery_v);
  writer.put(static_cast<std::uint8_t>(senses.bumper));
  writer.put(static_cast<std::uint8_t>(senses.motors_stalled));
  put(writer, cycle.decision);
}

void decode_cycle(std::span<const std::uint8_t> payload, RecordedCycle& cycle) {
  ByteReader reader(payload);
  Senses& senses = cycle.senses;
  cycle.number = reader.take<std::uint64_t>();
  senses.now = take_time(reader);
  take(reader, senses.stereo);
  take(reader, senses.odometry);
  take(reader, senses.sonar);
  take(reader, senses.laser);
  senses.head = take_head(reader);
  senses.battery_v = reader.take<double>();
  senses.bumper = reader.take_flag();
  senses.motors_stalled = reader.take_flag();
  take(reader, cycle.decision);
  reader.expect_end();
}

}  // namespace striate::replay
