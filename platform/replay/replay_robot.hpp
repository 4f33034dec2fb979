#pragma once

#include "striate/platform/replay/recording_reader.hpp"

namespace striate::replay {

/// A body made of a recording: it feels what was felt then, whatever it is told to do.
class ReplayRobot final : public Robot, private Clock {
 public:
  explicit ReplayRobot(RecordingReader& reader) : reader_(reader) {}

  [[nodiscard]] const RobotDescription& description() const override {
    return reader_.setup().robot;
  }
  [[nodiscard]] const Clock& clock() const override { return *this; }
  /// False at the end of the recording. @throws UserError where it is damaged.
  bool sense(Senses& senses) override {
    if (!read_ahead()) return false;
    ahead_ = false;
    senses = cycle_.senses;
    return true;
  }
  void send(const MotorCommand& /*command*/) override {}
  void stop() noexcept override {}

  /// Makes `cycle()` the one that `sense` is to hand out next; false at the end.
  bool read_ahead() {
    if (!ahead_) ahead_ = reader_.next(cycle_);
    return ahead_;
  }
  /// The cycle that was read last.
  [[nodiscard]] const RecordedCycle& cycle() const { return cycle_; }

 private:
  [[nodiscard]] TimePoint now() const override { return cycle_.senses.now; }

  RecordingReader& reader_;
  RecordedCycle cycle_;
  bool ahead_ = false;
};

}  // namespace striate::replay
