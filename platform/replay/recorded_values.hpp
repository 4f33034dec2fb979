#pragma once

#include <vector>

#include "striate/base/bytes.hpp"
#include "striate/platform/replay/recording.hpp"

/// Parts of a recorded cycle as bytes: each is written by put() and read by its take.
namespace striate::replay {

void put(ByteWriter& writer, const std::vector<NamedText>& list);

[[nodiscard]] std::vector<NamedText> take_named(ByteReader& reader);

void put(ByteWriter& writer, TimePoint time);

[[nodiscard]] TimePoint take_time(ByteReader& reader);

void put(ByteWriter& writer, const HeadPose& head);

[[nodiscard]] HeadPose take_head(ByteReader& reader);

void put(ByteWriter& writer, const RangeScan& scan);

void take(ByteReader& reader, RangeScan& scan);

void put(ByteWriter& writer, const MotorCommand& command);

void put(ByteWriter& writer, const StereoFrame& frame, bool same_images);

void take(ByteReader& reader, StereoFrame& frame);

void put(ByteWriter& writer, const Odometry& odometry);

void take(ByteReader& reader, Odometry& odometry);

void put(ByteWriter& writer, const RecordedDecision& decision);

void take(ByteReader& reader, RecordedDecision& decision);

}  // namespace striate::replay
