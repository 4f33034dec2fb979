#include "striate/platform/simulator/render/renderer.hpp"

#include <limits>

#include "striate/platform/simulator/render/camera_model.hpp"
#include "striate/platform/simulator/render/eye_image.hpp"
#include "striate/platform/simulator/render/lens_faults.hpp"

namespace striate::simulator {

using namespace render;

namespace {

constexpr double kPeopleReach_m = 45.0;  ///< people farther off are a pixel or two wide

}  // namespace

struct Renderer::Parts {
  Parts(const World& world, const FloorPlan& plan, const CameraSettings& camera, std::uint64_t key)
      : settings(camera),
        seed(key),
        stage(build_stage(world, plan)),
        people(stage.materials),
        tracer(stage.patches),
        baked(bake_light(stage, tracer)),
        probes(stage, plan, baked, tracer),
        shader(stage, baked, people, tracer),
        eye(tracer, shader, people),
        exposure_control(settings),
        faults(world.eyes),
        left_lens(faults, settings, Eye::left, key),
        right_lens(faults, settings, Eye::right, key),
        left(settings, Eye::left, key, faults.fixed_pattern),
        right(settings, Eye::right, key, faults.fixed_pattern) {}

  void set_scene(const SceneState& state) {
    people.pose(state, probes, kPeopleReach_m);
    tracer.set_people(people.patches());
  }
  [[nodiscard]] View view(const SceneState& state, Eye which) const;
  [[nodiscard]] EyeMotion motion(const SceneState& state) const;
  [[nodiscard]] Smear smear(const SceneState& state, const EyeMotion& motion) const;

  CameraSettings settings;
  std::uint64_t seed;
  Stage stage;
  PeopleOnStage people;
  Tracer tracer;
  BakedLight baked;
  LightProbes probes;
  Shader shader;
  EyeImage eye;
  ExposureControl exposure_control;
  Exposure exposure;
  EyeFaults faults;
  LensFaults left_lens;
  LensFaults right_lens;
  Sensor left;
  Sensor right;
  GaussTable gauss;
  bool has_last = false;
  SceneState last;  ///< of the image before: how fast the head turns
};

/// Each camera keeps half of what rectification left. Where the head's calibration is wrong it
/// looks elsewhere than the frame will say.
View Renderer::Parts::view(const SceneState& state, Eye which) const {
  SceneState looks = state;
  looks.head.tilt_rad += faults.tilt_rad;
  CameraSettings true_eyes = settings;
  true_eyes.baseline_m *= 1.0 + faults.baseline;
  View view = view_of(looks, true_eyes, which, settings.width_px);
  if (which == Eye::right) {
    const Vec3 origin = view.origin;
    looks.head.pan_rad += faults.yaw_rad;
    view = view_of(looks, true_eyes, which, settings.width_px);
    view.origin = origin;
  }
  view.focal_px *= static_cast<float>(1.0 + faults.focal);
  const double sign = which == Eye::left ? 0.5 : -0.5;
  const auto draw = [&](std::uint64_t k) {
    return static_cast<double>(gauss(key_of(seed, 0xCA11 + k)));
  };
  // Offset, roll and a tilt, equal parts of the whole error at the image's border.
  const double part = sign * settings.rectification_px / std::sqrt(1.0 + 1.0 / 3.0 + 1.0 / 3.0);
  const double sign_of_offset = draw(0) < 0.0 ? -1.0 : 1.0;
  view.skew_px = static_cast<float>(part * sign_of_offset);
  view.skew_by_u =
      static_cast<float>(part * std::clamp(draw(1), -1.5, 1.5) / (settings.width_px / 2.0));
  view.skew_by_v =
      static_cast<float>(part * std::clamp(draw(2), -1.5, 1.5) / (settings.height_px() / 2.0));
  if (which == Eye::right) view.skew_px += static_cast<float>(faults.rows_px);
  return view;
}

EyeMotion Renderer::Parts::motion(const SceneState& state) const {
  EyeMotion motion{state.time_s, exposure.shutter_s, state.turn_rad_s, 0.0};
  const double passed = state.time_s - last.time_s;
  if (has_last && passed > 0.0 && passed < 0.5) {
    motion.turn_rad_s += (state.head.pan_rad - last.head.pan_rad) / passed;
    motion.nod_rad_s = (state.head.tilt_rad - last.head.tilt_rad) / passed;
  }
  return motion;
}

Smear Renderer::Parts::smear(const SceneState& state, const EyeMotion& motion) const {
  const View v = view_of(state, settings, Eye::left, settings.width_px);
  const double px = static_cast<double>(v.focal_px) * exposure.shutter_s;
  return {static_cast<float>(std::abs(motion.turn_rad_s) * px),
          static_cast<float>(std::abs(motion.nod_rad_s) * px)};
}

Renderer::Renderer(const World& world, const FloorPlan& plan, const CameraSettings& settings,
                   std::uint64_t seed)
    : parts_(std::make_unique<Parts>(world, plan, settings, seed)) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

StereoFrame Renderer::image(const SceneState& state) {
  Parts& p = *parts_;
  p.set_scene(state);
  const float flicker = p.gauss(key_of(p.seed ^ 0xF11CULL, state.frame));
  p.shader.begin_image(1.0F + static_cast<float>(p.settings.flicker) * flicker);
  const View left = p.view(state, Eye::left);
  const std::vector<V4>& left_light = p.eye.render(left, p.settings.smooth_edges);
  p.exposure = p.exposure_control.choose(left_light);
  const EyeMotion motion = p.motion(state);
  const Smear smear = p.smear(state, motion);
  StereoFrame frame;
  frame.left = p.left.expose(p.left_lens.apply(left_light, motion), p.exposure, smear, state.frame);
  const std::vector<V4>& right_light =
      p.eye.render(p.view(state, Eye::right), p.settings.smooth_edges);
  frame.right =
      p.right.expose(p.right_lens.apply(right_light, motion), p.exposure, smear, state.frame);
  // What the head is told of itself, right or not. Without a fault that is the view's own number to
  // the last bit.
  frame.focal_px = static_cast<double>(left.focal_px) / (1.0 + p.faults.focal);
  frame.centre_u_px = static_cast<double>(left.centre_u_px);
  frame.centre_v_px = static_cast<double>(left.centre_v_px);
  frame.baseline_m = p.settings.baseline_m;
  p.last = state;
  p.has_last = true;
  return frame;
}

cv::Mat1f Renderer::true_depth(const SceneState& state, int width_px) {
  Parts& p = *parts_;
  p.set_scene(state);
  const View view = view_of(state, p.settings, Eye::left, width_px);
  cv::Mat1f depth(view.height_px, view.width_px, std::numeric_limits<float>::infinity());
  Packet packet;
  for (int y = 0; y < view.height_px; ++y) {
    for (int x = 0; x < view.width_px; x += static_cast<int>(Packet::kSize)) {
      for (unsigned i = 0; i < Packet::kSize; ++i) {
        const int u = x + static_cast<int>(i);
        packet.set(i, view.origin, view.ray(static_cast<float>(u), static_cast<float>(y)), 0.03F,
                   300.0F);
        if (u >= view.width_px) packet.valid[i] = 0;
      }
      p.tracer.intersect(packet, true);
      for (unsigned i = 0; i < Packet::kSize; ++i) {
        if (packet.valid[i] != 0 && packet.hit(i))
          depth(y, x + static_cast<int>(i)) = packet.rays.ray.tfar[i];
      }
    }
  }
  return depth;
}

double Renderer::light_level(Point2 plan) const {
  const Vec3 at{static_cast<float>(plan.x_m), static_cast<float>(plan.y_m), 0.5F};
  const V4 light = parts_->probes.irradiance(at, {0.0F, 0.0F, 1.0F});
  return std::min(1.0, static_cast<double>(luminance(light)));
}

Renderer::LastExposure Renderer::last_exposure() const {
  return {parts_->exposure.shutter_s, parts_->exposure.gain};
}

}  // namespace striate::simulator
