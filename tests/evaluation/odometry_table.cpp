// Visual odometry of Striate's features beside ORB's and SIFT's on sequences that are disturbed in
// many ways: odometry_table SEQUENCE... [--only NAME] [--width PX] [--features N] [--keyframes N]
// A sequence without ground truth shows how far its end is from its beginning.

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "striate/evaluation/odometry/compare_odometry.hpp"
#include "striate/evaluation/report.hpp"
#include "striate/platform/datasets/sequences/sequence.hpp"
#include "tests/reference/test_images.hpp"

namespace {

using namespace striate;

struct Moment {
  perception::StereoView view;
  datasets::TimedPose truth;  ///< of the rectified left camera
};

struct Loaded {
  std::vector<Moment> moments;
  bool has_truth = false;
};

Loaded load(const std::string& path) {
  Loaded loaded;
  const auto sequence = datasets::open_sequence(path, {});
  evaluation::SequenceViews views(*sequence, false);
  evaluation::SequenceView view;
  datasets::Trajectory truth;
  loaded.has_truth = !datasets::ground_truth_file(path).empty();
  if (loaded.has_truth) truth = datasets::find_ground_truth(path);
  while (views.next(view)) {
    Moment moment{view.view, {}};
    if (loaded.has_truth) {
      for (std::size_t k = 0; k < truth.poses.size(); ++k) {
        if (truth.timed && view.stamp_ns ? truth.poses[k].stamp_ns == *view.stamp_ns
                                         : k == view.number) {
          moment.truth = truth.poses[k];
        }
      }
      moment.truth.rotation = moment.truth.rotation * views.rectifier().left_turn().t();
    }
    moment.truth.stamp_ns = static_cast<std::int64_t>(loaded.moments.size()) * 100'000'000;
    loaded.moments.push_back(moment);
  }
  return loaded;
}

using Disturb = std::function<std::vector<Moment>(const std::vector<Moment>&)>;

template <class Change>
Disturb each_image(Change change) {
  return [change](const std::vector<Moment>& given) {
    std::vector<Moment> result = given;
    for (std::size_t k = 0; k < result.size(); ++k) {
      result[k].view.left = change(given[k].view.left, static_cast<int>(2 * k));
      result[k].view.right = change(given[k].view.right, static_cast<int>(2 * k + 1));
    }
    return result;
  };
}

std::vector<Moment> every(const std::vector<Moment>& given, std::size_t step) {
  std::vector<Moment> result;
  for (std::size_t k = 0; k < given.size(); k += step) result.push_back(given[k]);
  return result;
}

std::vector<Moment> mirrored(const std::vector<Moment>& given) {
  std::vector<Moment> result = given;
  const cv::Matx33d mirror(-1, 0, 0, 0, 1, 0, 0, 0, 1);
  for (std::size_t k = 0; k < given.size(); ++k) {
    const perception::StereoView& view = given[k].view;
    cv::Mat1b left, right;
    cv::flip(view.right, left, 1);
    cv::flip(view.left, right, 1);
    result[k].view.left = left;
    result[k].view.right = right;
    result[k].view.eyes.centre_u_px =
        view.left.cols - 1 - (view.eyes.centre_u_px + view.eyes.doffs_px);
    datasets::TimedPose& truth = result[k].truth;
    truth.position_m += truth.rotation * cv::Vec3d(view.eyes.baseline_m, 0, 0);
    truth.position_m = mirror * truth.position_m;
    truth.rotation = mirror * truth.rotation * mirror;
  }
  return result;
}

cv::Mat1b with_gamma(const cv::Mat1b& image, double gamma) {
  cv::Mat1b table(1, 256), result;
  for (int k = 0; k < 256; ++k) {
    table(0, k) = cv::saturate_cast<std::uint8_t>(255.0 * std::pow(k / 255.0, gamma));
  }
  cv::LUT(image, table, result);
  return result;
}

cv::Mat1b blurred(const cv::Mat1b& image, double sigma) {
  cv::Mat1b result;
  cv::GaussianBlur(image, result, {}, sigma);
  return result;
}

cv::Mat1b swept(const cv::Mat1b& image, int px) {
  cv::Mat1b result;
  cv::blur(image, result, {px, 1});
  return result;
}

std::vector<std::pair<std::string, Disturb>> disturbances() {
  return {
      {"as it is", [](const auto& given) { return given; }},
      {"every 2nd", [](const auto& given) { return every(given, 2); }},
      {"every 3rd", [](const auto& given) { return every(given, 3); }},
      {"reversed",
       [](const auto& given) { return std::vector<Moment>(given.rbegin(), given.rend()); }},
      {"mirrored", mirrored},
      {"half light",
       each_image([](const cv::Mat1b& image, int) { return cv::Mat1b(image * 0.5); })},
      {"light by turns", each_image([](const cv::Mat1b& image, int k) {
         return cv::Mat1b(image * (k / 2 % 2 == 0 ? 0.6 : 1.1));
       })},
      {"gamma 0.6, 1.6", each_image([](const cv::Mat1b& image, int k) {
         return with_gamma(image, k / 2 % 4 < 2 ? 0.6 : 1.6);
       })},
      {"noise 8", each_image([](const cv::Mat1b& image, int k) {
         return reference::with_noise(image, 8.0, k);
       })},
      {"blur 1.5", each_image([](const cv::Mat1b& image, int) { return blurred(image, 1.5); })},
      {"swept 9 px", each_image([](const cv::Mat1b& image, int k) {
         return k / 2 % 3 == 0 ? image : swept(image, 9);
       })},
  };
}

evaluation::MethodRun run(const Loaded& loaded, const std::vector<Moment>& moments,
                          const evaluation::OdometryMethod& method,
                          const perception::VisualOdometrySettings& settings) {
  evaluation::MethodRun result;
  result.name = method.name;
  perception::VisualOdometry odometry(settings, method.source);
  datasets::Trajectory truth;
  const double before_s = evaluation::processor_s();
  for (std::size_t k = 0; k < moments.size(); ++k) {
    const perception::VisualPose& pose = odometry.see(moments[k].view);
    const auto stamp_ns = static_cast<std::int64_t>(k) * 100'000'000;
    truth.poses.push_back(moments[k].truth);
    truth.poses.back().stamp_ns = stamp_ns;
    evaluation::take_pose(pose, k, stamp_ns, cv::Matx33d::eye(), result);
  }
  result.ms = 1e3 * (evaluation::processor_s() - before_s);
  evaluation::take_means(result);
  if (loaded.has_truth && result.estimate.poses.size() > 3) {
    result.scores = evaluation::score_odometry(truth, result.estimate, {});
  }
  return result;
}

std::vector<std::string> row_of(const std::string& disturbance, const evaluation::MethodRun& run) {
  std::vector<std::string> row = {disturbance, run.name};
  if (run.scores) {
    row.push_back(fmt::format("{:.3f}", evaluation::end_error_m(*run.scores)));
    row.push_back(fmt::format("{:.3f}", run.scores->absolute.rmse));
    row.push_back(fmt::format("{:.2f}", run.scores->kitti.percent));
    row.push_back(fmt::format("{:.4f}", run.scores->kitti.deg_per_m));
  } else {
    const auto& poses = run.estimate.poses;
    row.push_back(poses.empty() ? "-" : fmt::format("{:.2f}", cv::norm(poses.back().position_m)));
    row.insert(row.end(), 3, "-");
  }
  row.push_back(fmt::format(
      "{:.1f}", 100.0 * static_cast<double>(run.without) / static_cast<double>(run.views)));
  row.push_back(std::to_string(run.begun_anew));
  row.push_back(fmt::format("{:.2f}", run.noise_px));
  row.push_back(fmt::format("{:.1f}", run.ms));
  return row;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> paths;
  std::string only, how;
  perception::VisualOdometrySettings settings;
  for (int k = 1; k < argc; ++k) {
    const bool more = k + 1 < argc;
    if (std::strcmp(argv[k], "--only") == 0 && more) {
      only = argv[++k];
    } else if (std::strcmp(argv[k], "--how") == 0 && more) {
      how = argv[++k];
    } else if (std::strcmp(argv[k], "--width") == 0 && more) {
      settings.width_px = std::atoi(argv[++k]);
    } else if (std::strcmp(argv[k], "--features") == 0 && more) {
      settings.most_features = std::atoi(argv[++k]);
    } else if (std::strcmp(argv[k], "--keyframes") == 0 && more) {
      settings.keyframes = std::atoi(argv[++k]);
    } else if (std::strcmp(argv[k], "--keep") == 0 && more) {
      settings.keep_share = std::atof(argv[++k]);
    } else {
      paths.emplace_back(argv[k]);
    }
  }
  for (const std::string& path : paths) {
    const Loaded loaded = load(path);
    evaluation::Report table(fmt::format("{}, {} views", path, loaded.moments.size()),
                             {"disturbed", "features", "end m", "ATE m", "KITTI %", "deg/m",
                              "none %", "anew", "noise px", "ms"});
    for (const auto& [name, disturb] : disturbances()) {
      if (!how.empty() && name.find(how) == std::string::npos) continue;
      const std::vector<Moment> moments = disturb(loaded.moments);
      for (const evaluation::OdometryMethod& method : evaluation::odometry_methods()) {
        if (!only.empty() && method.name != only) continue;
        table.add_row(row_of(name, run(loaded, moments, method, settings)));
      }
    }
    fmt::print("{}\n", table.text());
    std::fflush(stdout);
  }
  return 0;
}
