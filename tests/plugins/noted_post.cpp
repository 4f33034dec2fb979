#include <chrono>
#include <fstream>
#include <memory>
#include <string>
#include <thread>

#include "striate/agent/plugins/plugin.hpp"

/// A body that notes when it is stopped, for the tests of how missions end.
namespace noted_post {

using namespace striate;

/// Stands without a camera, in real time, and for ever.
class NotedPost final : public Robot, private Clock {
 public:
  struct Settings {
    std::string notes;  ///< file that each stop() adds a line to
  };
  NotedPost(const Settings& settings, const RobotDescription& described)
      : settings_(settings), description_(described) {}
  [[nodiscard]] const RobotDescription& description() const override { return description_; }
  [[nodiscard]] const Clock& clock() const override { return *this; }
  bool sense(Senses& senses) override {
    std::this_thread::sleep_for(description_.cycle);
    now_ += description_.cycle;
    senses = {};
    senses.now = senses.odometry.stamp = now_;
    return true;
  }
  void send(const MotorCommand& /*command*/) override {}
  void stop() noexcept override { std::ofstream(settings_.notes, std::ios::app) << "stopped\n"; }

 private:
  [[nodiscard]] TimePoint now() const override { return now_; }

  Settings settings_;
  RobotDescription description_;
  TimePoint now_;
};

template <class V>
void visit(V& v, NotedPost::Settings& s) {
  v.text("notes", s.notes, "file that tells of each stop");
}

void enroll(agent::PluginRegistrar& plugin) {
  plugin.add(agent::body_entry<NotedPost>("noted_post", "stands, and notes when it is stopped"));
}

}  // namespace noted_post

STRIATE_PLUGIN("noted_post", noted_post::enroll)
