#include <chrono>
#include <cmath>
#include <memory>
#include <opencv2/core.hpp>

#include "striate/agent/plugins/plugin.hpp"

/// One of everything that a plugin can add, for the tests.
namespace one_of_each {

using namespace striate;

/// Turns the head from side to side for a while.
class Wave final : public behaviours::Behaviour {
 public:
  struct Settings {
    double for_s = 1.0;
  };
  static constexpr const char* kMain = "for";
  Wave(const Settings& settings, const RobotDescription& /*robot*/) : settings_(settings) {}
  void start(const memory::ShortTermMemory& memory) override { began_ = memory.now(); }
  behaviours::Wish tick(const memory::ShortTermMemory& memory) override {
    const double t_s = to_seconds(memory.now() - began_);
    if (t_s > settings_.for_s) {
      return behaviours::final_wish(memory, behaviours::Progress::succeeded, "waved");
    }
    behaviours::Wish wish = behaviours::standing_wish(memory, "waves");
    wish.pan_rad = 0.3 * std::sin(6.0 * t_s);
    return wish;
  }
  [[nodiscard]] behaviours::Motors motors() const override { return behaviours::Motors::head; }
  [[nodiscard]] bool can_fail() const override { return false; }

 private:
  Settings settings_;
  TimePoint began_;
};

template <class V>
void visit(V& v, Wave::Settings& s) {
  v.number("for", s.for_s, config::Unit::duration, {0.1, 60.0}, "how long");
}

/// Mean grey of the image's left half less that of its right half, -1..1.
class SideLight final : public perception::Stage {
 public:
  void see(const StereoFrame& frame, const perception::Percept& percept,
           std::span<double> figures) override {
    const auto half = [&](int from) {
      const cv::Scalar bgr = cv::mean(frame.left.colRange(from, from + frame.left.cols / 2));
      return (bgr[0] + bgr[1] + bgr[2]) / 3.0 / 255.0;
    };
    figures[0] = half(0) - half(frame.left.cols / 2);
    figures[1] = static_cast<double>(percept.obstacles.size());  // ours have run before
  }
};

/// Holds where the light is more even than the limit, and it is known.
class LightIsEven final : public tasks::Condition {
 public:
  explicit LightIsEven(double limit) : limit_(limit) {}
  [[nodiscard]] bool holds(const memory::ShortTermMemory& memory) const override {
    return std::abs(memory.figure("side_light.difference")) <= limit_;
  }

 private:
  double limit_;
};

/// Stands somewhere without a camera, ten times as fast as real time.
class Post final : public Robot, private Clock {
 public:
  struct Settings {
    double gives_up_after_s = 600.0;
  };
  Post(const Settings& settings, const RobotDescription& described)
      : settings_(settings), description_(described) {}
  [[nodiscard]] const RobotDescription& description() const override { return description_; }
  [[nodiscard]] const Clock& clock() const override { return *this; }
  bool sense(Senses& senses) override {
    now_ += description_.cycle;
    senses = {};
    senses.now = senses.odometry.stamp = now_;
    return to_seconds(now_) < settings_.gives_up_after_s;
  }
  void send(const MotorCommand& /*command*/) override {}
  void stop() noexcept override {}

 private:
  [[nodiscard]] TimePoint now() const override { return now_; }

  Settings settings_;
  RobotDescription description_;
  TimePoint now_;
};

template <class V>
void visit(V& v, Post::Settings& s) {
  v.number("gives_up_after", s.gives_up_after_s, config::Unit::duration, {0.1, 3600.0},
           "ends then");
}

void enroll(agent::PluginRegistrar& plugin) {
  plugin.add(behaviours::behaviour_entry<Wave>("wave", "turns the head from side to side"));
  plugin.add(perception::StageEntry{
      "side_light",
      "which half of the image is brighter",
      {"difference", "obstacles"},
      [](const RobotDescription&) { return std::make_unique<SideLight>(); }});
  plugin.add(tasks::ConditionEntry{"light_is_even",
                                   "neither half of the image is brighter by more than this",
                                   config::Unit::fraction,
                                   {0.0, 1.0},
                                   "10 %",
                                   [](double limit) -> std::unique_ptr<tasks::Condition> {
                                     return std::make_unique<LightIsEven>(limit);
                                   }});
  plugin.add(agent::body_entry<Post>("post", "stands and sees nothing"));
}

}  // namespace one_of_each

STRIATE_PLUGIN("one_of_each", one_of_each::enroll)
