#include "render_world.hpp"
#include "striate/platform/simulator/render/camera_model.hpp"

namespace striate::simulator::test {
namespace {

CameraSettings small_camera() {
  CameraSettings camera;
  camera.width_px = 96;
  return camera;
}

TEST(Renderer, MakesTheSameBytesFromTheSameSeed) {
  const World world = bright_corridor();
  const FloorPlan plan = build_floor_plan(world);
  Renderer a(world, plan, small_camera(), 5);
  Renderer b(world, plan, small_camera(), 5);
  Renderer other(world, plan, small_camera(), 6);
  SceneState state = standing_at(3.0, 0.2, 4.0);
  for (std::uint64_t frame = 0; frame < 3; ++frame) {
    state.frame = frame;
    const StereoFrame fa = a.image(state);
    const StereoFrame fb = b.image(state);
    EXPECT_TRUE(same(fa.left, fb.left));
    EXPECT_TRUE(same(fa.right, fb.right));
    EXPECT_FALSE(same(fa.left, other.image(state).left));
  }
}

TEST(Renderer, DrawsNewNoiseForEachFrame) {
  const World world = bright_corridor();
  Renderer renderer(world, build_floor_plan(world), small_camera(), 5);
  SceneState state = standing_at(3.0, 0.2);
  const cv::Mat3b first = renderer.image(state).left.clone();
  EXPECT_TRUE(same(first, renderer.image(state).left)) << "the same frame has the same noise";
  state.frame = 1;
  EXPECT_FALSE(same(first, renderer.image(state).left));
}

/// Standard deviation in time of the middle of an even wall, in grey levels.
double noise_at_light(double level) {
  World world = bright_corridor();
  world.lights[0].level = level;
  CameraSettings camera = small_camera();
  camera.flicker = 0.0;
  Renderer renderer(world, build_floor_plan(world), camera, 5);
  SceneState state = standing_at(6.0, 0.0, 90.0);
  cv::Mat sum = cv::Mat::zeros(72, 96, CV_64FC3);
  cv::Mat squares = sum.clone();
  constexpr int kFrames = 12;
  for (int i = 0; i < kFrames; ++i) {
    state.frame = static_cast<std::uint64_t>(i);
    cv::Mat image;
    renderer.image(state).left.convertTo(image, CV_64F);
    sum += image;
    squares += image.mul(image);
  }
  const cv::Mat variance = (squares - sum.mul(sum) / kFrames) / (kFrames - 1);
  return std::sqrt(cv::mean(variance(cv::Rect(24, 18, 48, 36)))[1]);
}

TEST(Renderer, IsNoisierInTheDark) {
  const double bright = noise_at_light(1.0);
  const double dim = noise_at_light(0.08);
  const double dark = noise_at_light(0.008);
  EXPECT_GT(bright, 0.3);
  EXPECT_LT(bright, 2.5);
  EXPECT_GT(dim, 1.4 * bright);
  EXPECT_GT(dark, 1.8 * dim);
}

TEST(ExposureControl, UsesTheShutterFirstAndThenTheGain) {
  const CameraSettings camera;
  const auto settle = [&](float light) {
    render::ExposureControl control(camera);
    return control.choose(std::vector<render::V4>(10000, render::splat(light)));
  };
  EXPECT_LT(settle(0.5F).shutter_s, 0.02);
  EXPECT_DOUBLE_EQ(settle(0.5F).gain, 1.0);
  EXPECT_DOUBLE_EQ(settle(0.03F).shutter_s, camera.max_shutter_s);
  EXPECT_GT(settle(0.03F).gain, 2.0);
  EXPECT_DOUBLE_EQ(settle(1e-4F).gain, camera.max_gain);
}

TEST(ExposureControl, FollowsAChangeOfLightOverSeveralImages) {
  const CameraSettings camera;
  render::ExposureControl control(camera);
  const std::vector<render::V4> bright(10000, render::splat(1.0F));
  const std::vector<render::V4> dim(10000, render::splat(0.25F));
  const double before = control.choose(bright).shutter_s;
  const double first = control.choose(dim).shutter_s;
  EXPECT_GT(first, 1.2 * before);
  EXPECT_LT(first, 3.0 * before);
  double last = first;
  for (int i = 0; i < 20; ++i) last = control.choose(dim).shutter_s;
  EXPECT_NEAR(last, 4.0 * before, 0.05 * before);
}

TEST(Sensor, LosesLightTowardsTheCornerAndHoldsNoMoreThanAFullWell) {
  CameraSettings camera = clean_camera(96);
  render::Sensor sensor(camera, render::Eye::left, 1);
  const render::Exposure exposure{0.01, 1.0};
  const double one = 1.0 / (render::ExposureControl(camera).sensitivity() * exposure.shutter_s);
  const auto image_of = [&](double level) {
    return sensor.expose(
        std::vector<render::V4>(96 * 72, render::splat(static_cast<float>(level * one))), exposure,
        {}, 0);
  };
  const auto linear = [](int grey) { return std::pow((grey / 255.0 + 0.055) / 1.055, 2.4); };
  const cv::Mat3b half = image_of(0.5);
  EXPECT_NEAR(linear(half(36, 48)[1]), 0.5, 0.01);
  EXPECT_NEAR(linear(half(0, 0)[1]) / linear(half(36, 48)[1]), 1.0 - camera.vignetting, 0.02);
  EXPECT_EQ(image_of(50.0)(36, 48)[1], 255);
}

TEST(Sensor, SmearsAlongTheTurn) {
  const CameraSettings camera = clean_camera(96);
  render::Sensor sensor(camera, render::Eye::left, 1);
  std::vector<render::V4> light(96 * 72, render::splat(0.05F));
  for (int y = 0; y < 72; ++y) light[static_cast<std::size_t>(y * 96 + 48)] = render::splat(1.0F);
  const render::Exposure exposure{0.01, 1.0};
  const auto lit = [](const cv::Mat3b& image) {
    int count = 0;
    for (int x = 0; x < 96; ++x) count += image(36, x)[1] > image(36, 5)[1] + 15 ? 1 : 0;
    return count;
  };
  const int still = lit(sensor.expose(light, exposure, {}, 0));
  EXPECT_LE(still, 3);
  const int moved = lit(sensor.expose(light, exposure, {8.0F, 0.0F}, 0));
  EXPECT_GE(moved, 8);
  EXPECT_LE(moved, 13);
}

TEST(Renderer, KeepsLeftAndRightApartByGainAndHeightAsSettingsSay) {
  World world = bright_corridor();
  world.wall_material = "brick";
  CameraSettings camera = clean_camera(160);
  camera.gain_mismatch = 0.2;
  camera.rectification_px = 0.0;
  Renderer renderer(world, build_floor_plan(world), camera, 3);
  const StereoFrame frame = renderer.image(standing_at(4.0, 0.0));
  const cv::Rect middle(40, 30, 80, 60);
  const double ratio = mean_of(frame.left, middle) / mean_of(frame.right, middle);
  EXPECT_GT(std::max(ratio, 1.0 / ratio), 1.05);
}

}  // namespace
}  // namespace striate::simulator::test
