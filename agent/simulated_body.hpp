#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "striate/agent/baselines/true_depth_images.hpp"
#include "striate/agent/body.hpp"
#include "striate/platform/simulator/render/renderer_images.hpp"
#include "striate/platform/simulator/simulated_pioneer.hpp"

namespace striate::agent {

/// Which simulated Pioneer.
struct WorldOptions {
  std::string world;
  std::uint64_t seed = 1;     ///< any; the first run of a series
  std::string baseline = {};  ///< whose disparities: paper, sgbm, truth; empty: Striate's own
  /// Along the corridor, left of its middle, heading; none: the world's own start.
  std::optional<Pose2> start = {};
};

/// The simulated Pioneer with all that it lives in: world, light, judge, and a baseline's eyes.
class SimulatedBody final : public Robot {
 public:
  /// @param world options.world as it was read. @throws UserError for a baseline that is none.
  SimulatedBody(const RobotSettings& settings, simulator::World world, const WorldOptions& options);

  [[nodiscard]] const RobotDescription& description() const override { return body_.description(); }
  [[nodiscard]] const Clock& clock() const override { return body_.clock(); }
  bool sense(Senses& senses) override { return body_.sense(senses); }
  void send(const MotorCommand& command) override { body_.send(command); }
  void stop() noexcept override { body_.stop(); }

  [[nodiscard]] const WorldOptions& options() const { return options_; }
  [[nodiscard]] const simulator::World& world() const { return world_; }
  [[nodiscard]] const simulator::FloorPlan& plan() const { return plan_; }
  [[nodiscard]] const simulator::ImageSource& light() const { return pictures_; }
  [[nodiscard]] const simulator::Judge& judge() const { return body_.judge(); }
  [[nodiscard]] const simulator::LateObstacles& late_obstacles() const {
    return body_.late_obstacles();
  }
  /// Of a baseline, else nullptr.
  [[nodiscard]] perception::DisparitySource* disparities() const { return disparities_.get(); }

 private:
  WorldOptions options_;
  simulator::World world_;
  simulator::FloorPlan plan_;
  simulator::RendererImages pictures_;
  std::unique_ptr<TrueDepthImages> true_images_;  ///< of the baseline `truth`, else null
  std::unique_ptr<perception::DisparitySource> disparities_;
  simulator::SimulatedPioneer body_;
};

/// The simulated Pioneer, watched by its judge, as fast as the machine. Reads the world at once.
/// @throws UserError with all mistakes of the world, or for a baseline that is none
[[nodiscard]] BodySource simulated_pioneer(const WorldOptions& options);

}  // namespace striate::agent
