#include "striate/platform/replay/recording_codec.hpp"

#include "striate/platform/replay/recorded_values.hpp"

namespace striate::replay {
namespace {

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
