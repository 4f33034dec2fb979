#pragma once

#include <string>

#include "striate/behaviours/control/behaviour.hpp"
#include "striate/config/settings.hpp"
#include "striate/platform/interface/robot.hpp"

namespace striate::behaviours {

/// Shows a text to people: it is what the robot gives as its reason while this runs.
class Say : public Behaviour {
 public:
  struct Settings {
    std::string text;
    double for_s = 1.0;
  };
  static constexpr const char* kMain = "text";
  static constexpr const char* kRequired[] = {"text"};

  Say(const Settings& settings, const RobotDescription& /*robot*/)
      : text_(std::string_view("says: " + settings.text)), for_s_(settings.for_s) {}
  void start(const memory::ShortTermMemory& memory) override { started_ = memory.now(); }
  Wish tick(const memory::ShortTermMemory& memory) override {
    if (to_seconds(memory.now() - started_) >= for_s_) {
      return final_wish(memory, Progress::succeeded, text_);
    }
    return standing_wish(memory, text_);
  }
  [[nodiscard]] Motors motors() const override { return Motors::nothing; }
  [[nodiscard]] bool can_fail() const override { return false; }

 private:
  ShortText text_;
  double for_s_;
  TimePoint started_{};
};

template <class V>
void visit(V& v, Say::Settings& s) {
  v.text("text", s.text, "what is said");
  v.number("for", s.for_s, config::Unit::duration, {0, 600}, "how long it is shown");
}

}  // namespace striate::behaviours
