#include "striate/platform/replay/recorded_values.hpp"

#include "striate/platform/replay/recorded_image.hpp"

namespace striate::replay {
namespace {

enum class Images : std::uint8_t { none, written, same };

MotorCommand take_command(ByteReader& reader) {
  MotorCommand command;
  command.forward_m_s = reader.take<double>();
  command.turn_rad_s = reader.take<double>();
  command.pan_rad = reader.take<double>();
  command.tilt_rad = reader.take<double>();
  return command;
}

}  // namespace

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

}  // namespace striate::replay
