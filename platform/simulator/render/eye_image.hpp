#pragma once

#include <vector>

#include "striate/platform/simulator/render/shader.hpp"
#include "striate/platform/simulator/render/view.hpp"

namespace striate::simulator::render {

/// The light that falls on one sensor: one ray a pixel, three along edges, and the mirror image in
/// the floor at half the resolution, blurred as a worn floor blurs it.
class EyeImage {
 public:
  EyeImage(const Tracer& tracer, const Shader& shader, const PeopleOnStage& people)
      : tracer_(tracer), shader_(shader), people_(people) {}

  /// Linear light, row by row, blue green red in lanes 0..2. Valid until the next call.
  const std::vector<V4>& render(const View& view, bool smooth_edges);

 private:
  /// Part of the image that a person may cover, in pixels.
  struct Frame {
    float left, right, top, bottom;
  };
  void frame_people(const View& view);
  [[nodiscard]] bool people_in(int left, int top, int right, int bottom) const;
  void trace_all(const View& view);
  void trace_tile(const View& view, int left, int top);
  void mark_steps(std::size_t here, std::size_t there, int count);
  [[nodiscard]] std::vector<int> edges(const View& view);
  void resample(const View& view, const std::vector<int>& pixels, std::size_t first);
  void want_mirror(const Packet& packet, unsigned lane, Vec3 normal, int cell);
  void flush_mirror(const View& view);
  void blur_mirror();
  void add_mirror(const View& view);

  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  /// Nothing comes nearer to the eyes: they stand 0.2 m within the robot's outline
  static constexpr float kNear_m = 0.03F;
  static constexpr float kFar_m = 300.0F;  // farther than any corridor is long

  const Tracer& tracer_;
  const Shader& shader_;
  const PeopleOnStage& people_;
  std::vector<Frame> frames_;
  std::vector<V4> light_;
  std::vector<int> group_;
  std::vector<float> brightness_;
  std::vector<int> is_edge_;  ///< 0 or 1
  std::vector<int> step_;     ///< of one row
  std::vector<V4> mirror_;    ///< half resolution; lane 3: 1 where there is one
  std::vector<V4> scratch_;
  int mirror_width_ = 0;
  int mirror_height_ = 0;
  std::array<int, Packet::kSize> pending_cell_{};
  std::array<float, Packet::kSize> pending_before_m_{};
  unsigned pending_count_ = 0;
  Packet pending_;
};

}  // namespace striate::simulator::render
