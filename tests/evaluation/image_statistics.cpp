#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "striate/platform/simulator/render/renderer.hpp"
#include "striate/platform/simulator/world_reader.hpp"

/// image_statistics [world.yaml ...]: how like real corridors the simulator's images are.
/// Statistics of the images seen along each world (default: all shipped ones), beside those of
/// 84 frames of a real robot, and the reference numbers. More texture or less noise than in
/// reality would flatter the vision.
namespace striate::simulator {
namespace {

namespace fs = std::filesystem;

struct Statistics {
  double slope = 0.0;     ///< of the radially averaged power spectrum, log over log
  double kurtosis = 0.0;  ///< of horizontal and vertical differences of log grey
  double blank = 0.0;     ///< share of 16x16 blocks with a standard deviation below 2 grey levels
  double noise = 0.0;     ///< grey levels, from the finest differences
  double entropy = 0.0;   ///< bits of the grey histogram in 64 bins
  int pictures = 0;

  void add(const Statistics& other) {
    slope += other.slope;
    kurtosis += other.kurtosis;
    blank += other.blank;
    noise += other.noise;
    entropy += other.entropy;
    ++pictures;
  }
  [[nodiscard]] Statistics mean() const {
    const double n = std::max(1, pictures);
    return {slope / n, kurtosis / n, blank / n, noise / n, entropy / n, pictures};
  }
};

double spectrum_slope(const cv::Mat1f& grey) {
  const int side = std::min(grey.rows, grey.cols) / 2 * 2;
  cv::Mat1f square =
      grey(cv::Rect((grey.cols - side) / 2, (grey.rows - side) / 2, side, side)).clone();
  square -= static_cast<float>(cv::mean(square)[0]);
  cv::Mat window;
  cv::createHanningWindow(window, square.size(), CV_32F);
  square = square.mul(window);
  cv::Mat spectrum;
  cv::dft(square, spectrum, cv::DFT_COMPLEX_OUTPUT);
  std::vector<double> power(static_cast<std::size_t>(side / 2), 0.0);
  std::vector<int> count(power.size(), 0);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const int fy = y <= side / 2 ? y : y - side;
      const int fx = x <= side / 2 ? x : x - side;
      const auto ring = static_cast<std::size_t>(std::lround(std::hypot(fx, fy)));
      if (ring >= power.size()) continue;
      const auto c = spectrum.at<cv::Vec2f>(y, x);
      power[ring] += static_cast<double>(c[0]) * c[0] + static_cast<double>(c[1]) * c[1];
      ++count[ring];
    }
  }
  double n = 0.0, sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  for (std::size_t r = 3; r < power.size() * 3 / 4; ++r) {
    const double x = std::log(static_cast<double>(r));
    const double y = std::log(power[r] / count[r] + 1e-9);
    n += 1.0;
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

double gradient_kurtosis(const cv::Mat1f& grey) {
  double n = 0.0, s1 = 0.0, s2 = 0.0, s3 = 0.0, s4 = 0.0;
  const auto take = [&](float a, float b) {
    const double d = std::log(a + 1.0) - std::log(b + 1.0);
    n += 1.0;
    s1 += d;
    s2 += d * d;
    s3 += d * d * d;
    s4 += d * d * d * d;
  };
  for (int y = 0; y + 1 < grey.rows; ++y) {
    for (int x = 0; x + 1 < grey.cols; ++x) {
      take(grey(y, x), grey(y, x + 1));
      take(grey(y, x), grey(y + 1, x));
    }
  }
  const double m = s1 / n;
  const double variance = s2 / n - m * m;
  const double fourth = s4 / n - 4.0 * m * s3 / n + 6.0 * m * m * s2 / n - 3.0 * m * m * m * m;
  return fourth / (variance * variance);
}

double blank_blocks(const cv::Mat1f& grey) {
  int blank = 0;
  int blocks = 0;
  for (int y = 0; y + 16 <= grey.rows; y += 16) {
    for (int x = 0; x + 16 <= grey.cols; x += 16) {
      cv::Scalar mean, deviation;
      cv::meanStdDev(grey(cv::Rect(x, y, 16, 16)), mean, deviation);
      blank += deviation[0] < 2.0 ? 1 : 0;
      ++blocks;
    }
  }
  return static_cast<double>(blank) / blocks;
}

/// Immerkaer 1996, "Fast noise variance estimation", in the middle one of all 8x8 blocks.
double noise_level(const cv::Mat1f& grey) {
  const cv::Mat1f kernel = (cv::Mat1f(3, 3) << 1, -2, 1, -2, 4, -2, 1, -2, 1);
  cv::Mat1f rest;
  cv::filter2D(grey, rest, CV_32F, kernel);
  std::vector<double> blocks;
  for (int y = 8; y + 16 <= grey.rows; y += 8) {
    for (int x = 8; x + 16 <= grey.cols; x += 8) {
      const cv::Rect block(x, y, 8, 8);
      const double level = cv::mean(grey(block))[0];
      if (level < 8.0 || level > 247.0) continue;  // black and white hide noise
      blocks.push_back(cv::mean(cv::abs(rest(block)))[0] * std::sqrt(std::numbers::pi / 2.0) / 6.0);
    }
  }
  if (blocks.empty()) return 0.0;
  const std::size_t middle = blocks.size() / 2;
  std::nth_element(blocks.begin(), blocks.begin() + static_cast<std::ptrdiff_t>(middle),
                   blocks.end());
  return blocks[middle];
}

double grey_entropy(const cv::Mat1b& grey) {
  std::array<double, 64> histogram{};
  for (const std::uint8_t value : grey) histogram[value / 4U] += 1.0;
  double bits = 0.0;
  for (const double count : histogram) {
    const double p = count / static_cast<double>(grey.total());
    if (p > 0.0) bits -= p * std::log2(p);
  }
  return bits;
}

Statistics measure(const cv::Mat& image) {
  cv::Mat1b grey;
  cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  cv::Mat1f values;
  grey.convertTo(values, CV_32F);
  return {spectrum_slope(values), gradient_kurtosis(values), blank_blocks(values),
          noise_level(values),    grey_entropy(grey),        1};
}

void print(const std::string& name, const Statistics& s) {
  fmt::print("{:<34}{:>5}{:>9.2f}{:>10.1f}{:>8.2f}{:>8.2f}{:>9.2f}\n", name, s.pictures, s.slope,
             s.kurtosis, s.blank, s.noise, s.entropy);
}

Statistics along(const std::string& file) {
  const World world = load_world(file);
  const FloorPlan plan = build_floor_plan(world);
  CameraSettings camera;
  Renderer renderer(world, plan, camera, 1);
  Statistics sum;
  std::uint64_t frame = 0;
  for (double x = 1.0; x < world.length_m - 2.0; x += 0.7) {
    SceneState state;
    state.time_s = x;  // more than a second between images: no smear
    state.robot = plan.at(x, 0.25 * std::sin(x));
    state.robot.heading_rad += 0.15 * std::sin(0.8 * x);
    state.frame = frame++;
    PersonState person;
    person.look = static_cast<int>(frame % 8);
    person.pose =
        plan.at(std::min(x + 2.0 + std::fmod(x, 7.0), world.length_m - 0.5), 0.6 * std::cos(x));
    person.speed_m_s = 1.1;
    person.stride_rad = 3.0 * x;
    if (frame % 3 == 0) state.people.push_back(person);
    sum.add(measure(renderer.image(state).left));
  }
  return sum.mean();
}

void real_corridor() {
  const char* set = std::getenv("STRIATE_SHARED_DATA");
  const fs::path folder =
      fs::path(set != nullptr ? set : STRIATE_SHARED_DATA) / "corridor/rtabmap_samples";
  if (!fs::is_directory(folder)) {
    fmt::print("(real corridor: skipped, no {})\n", folder.string());
    return;
  }
  Statistics whole;
  Statistics small;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const cv::Mat image = cv::imread(entry.path().string());
    if (image.empty()) continue;
    whole.add(measure(image));
    cv::Mat reduced;
    cv::resize(image, reduced, {320, 240}, 0, 0, cv::INTER_AREA);
    small.add(measure(reduced));
  }
  print("real robot, as they are", whole.mean());
  print("real robot, at 320x240", small.mean());
}

int run(int count, char** arguments) {
  fmt::print("{:<34}{:>5}{:>9}{:>10}{:>8}{:>8}{:>9}\n", "", "n", "slope", "kurtosis", "blank",
             "noise", "entropy");
  fmt::print("{:<34}{:>5}{:>9.1f}{:>10}{:>8.2f}{:>8.2f}{:>9.1f}\n", "reference renders (stated)",
             "-", -3.0, 49, 0.21, 1.0, 4.9);
  fmt::print("{:<34}{:>5}{:>9.1f}{:>10}{:>8.2f}{:>8.2f}{:>9.1f}\n", "real robot (stated)", 84, -3.5,
             26, 0.28, 0.25, 5.2);
  fmt::print("{:<34}{:>5}{:>9.1f}{:>10}{:>8.2f}{:>8.2f}{:>9.1f}\n", "corridor photos (stated)", 255,
             -2.8, 54, 0.29, 0.5, 5.1);
  real_corridor();
  std::vector<std::string> worlds(arguments + 1, arguments + count);
  if (worlds.empty()) {
    for (const char* name : {"corridor_a", "corridor_b", "corridor_c"}) {
      worlds.push_back(std::string(STRIATE_SOURCE_DIR "/config/worlds/") + name + ".yaml");
    }
  }
  for (const std::string& world : worlds) print(fs::path(world).stem().string(), along(world));
  return 0;
}

}  // namespace
}  // namespace striate::simulator

int main(int count, char** arguments) {
  return striate::simulator::run(count, arguments);
}
