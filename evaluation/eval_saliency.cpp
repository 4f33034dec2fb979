#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <opencv2/imgproc.hpp>
#include <opencv2/saliency.hpp>

#include "striate/base/files.hpp"
#include "striate/base/index_within.hpp"
#include "striate/evaluation/evaluation.hpp"
#include "striate/evaluation/fixations.hpp"
#include "striate/evaluation/plot.hpp"
#include "striate/evaluation/report.hpp"
#include "striate/evaluation/saliency_scores.hpp"
#include "striate/perception/saliency/saliency.hpp"
#include "striate/platform/datasets/images/read_image.hpp"

namespace striate::evaluation {
namespace {

namespace fs = std::filesystem;

/// px: the stereo's working width, at which the robot computes it
constexpr int kWorkingWidth_px = 160;
constexpr int kJudgedWidth_px = 400;  // half of OSIE's 800: fixations are no finer
/// One degree of view where the image spans about 33 degrees, as in OSIE (24 px of 800).
constexpr double kDegree_of_width = 0.03;

cv::Mat1f opencv_map(cv::saliency::StaticSaliency& method, const cv::Mat3b& image) {
  cv::Mat map;
  method.computeSaliency(image, map);
  cv::Mat1f result;
  map.convertTo(result, CV_32F, map.depth() == CV_8U ? 1.0 / 255.0 : 1.0);
  return result;
}

cv::Mat1f our_map(const perception::SaliencySettings& settings, const cv::Mat3b& image) {
  const int height =
      std::max(1, static_cast<int>(std::lround(1.0 * image.rows * kWorkingWidth_px / image.cols)));
  cv::Mat3b small;
  cv::resize(image, small, {kWorkingWidth_px, height}, 0, 0, cv::INTER_AREA);
  return perception::SaliencyFinder(settings)
      .find(small, {}, perception::ViewGeometry({}, {}, {}))
      .salience;
}

struct Method {
  std::string name;
  std::function<cv::Mat1f(const cv::Mat3b&)> map;
  bool centre_prior = false;
  SaliencyScores sum;
};

std::vector<Method> methods() {
  perception::SaliencySettings paper;
  paper.mode = perception::SaliencyMode::paper;
  auto ours = [](perception::SaliencySettings s) {
    return [s](const cv::Mat3b& p) { return our_map(s, p); };
  };
  auto spectral = [](const cv::Mat3b& p) {
    return opencv_map(*cv::saliency::StaticSaliencySpectralResidual::create(), p);
  };
  auto fine = [](const cv::Mat3b& p) {
    return opencv_map(*cv::saliency::StaticSaliencyFineGrained::create(), p);
  };
  perception::SaliencySettings colour, texture, shape;
  colour.texture = colour.shape = 0.0;
  texture.colour = texture.shape = 0.0;
  shape.colour = shape.texture = 0.0;
  std::vector<Method> all = {{"paper", ours(paper), false, {}},
                             {"robust", ours({}), false, {}},
                             {"robust: colour alone", ours(colour), false, {}},
                             {"robust: texture alone", ours(texture), false, {}},
                             {"robust: shape alone", ours(shape), false, {}},
                             {"OpenCV spectral residual", spectral, false, {}},
                             {"OpenCV fine-grained", fine, false, {}}};
  auto one = [](const cv::Mat3b& p) { return cv::Mat1f(p.size(), 1.0F); };
  all.push_back({"centre prior alone", one, true, {}});
  for (const std::size_t k : {0U, 1U, 5U, 6U}) {
    all.push_back({all[k].name + " + centre prior", all[k].map, true, {}});
  }
  return all;
}

void judge(const cv::Mat3b& image, const std::vector<cv::Point2d>& fixations,
           std::vector<Method>& all) {
  const double scale = std::min(1.0, 1.0 * kJudgedWidth_px / image.cols);
  const cv::Size size(std::max(1, static_cast<int>(std::lround(image.cols * scale))),
                      std::max(1, static_cast<int>(std::lround(image.rows * scale))));
  std::vector<cv::Point> points;
  for (const cv::Point2d& p : fixations) {
    const cv::Point at(floor_within(p.x * scale, -1, size.width),
                       floor_within(p.y * scale, -1, size.height));
    if (at.x >= 0 && at.x < size.width && at.y >= 0 && at.y < size.height) points.push_back(at);
  }
  if (points.empty()) return;
  for (Method& method : all) {
    cv::Mat1f map = method.map(image);
    cv::resize(map, map, size, 0, 0, cv::INTER_LINEAR);
    if (method.centre_prior) perception::prefer_centre(1.0, map);
    const SaliencyScores s = score_salience(map, points, kDegree_of_width * size.width);
    method.sum.auc_judd += s.auc_judd;
    method.sum.nss += s.nss;
    method.sum.cc += s.cc;
  }
}

void tell(const std::vector<Method>& all, int pictures, const std::string& out) {
  Report report(fmt::format("Saliency against eye fixations, mean of {} images", pictures),
                {"method", "AUC-Judd", "NSS", "CC"});
  BarPlot plot{"Saliency against eye fixations", "score", {"AUC-Judd", "NSS", "CC"}, {}};
  for (const Method& m : all) {
    const double n = pictures;
    report.add_row({m.name, fmt::format("{:.3f}", m.sum.auc_judd / n),
                    fmt::format("{:.3f}", m.sum.nss / n), fmt::format("{:.3f}", m.sum.cc / n)});
    plot.series.push_back({m.name, {m.sum.auc_judd / n, m.sum.nss / n, m.sum.cc / n}});
  }
  fmt::print("{}", report.text());
  fmt::print("working width {} px; judged at {} px; fixations blurred with sigma {:.0f} px there\n",
             kWorkingWidth_px, kJudgedWidth_px, kDegree_of_width * kJudgedWidth_px);
  write_file(out + "/saliency.csv", report.csv());
  write_file(out + "/saliency.svg", plot.svg());
}

}  // namespace

int evaluate_saliency(const EvalOptions& options) {
  const fs::path folder = options.folder;
  if (!fs::is_directory(folder)) refuse_fixations(options.folder, "is no folder");
  const Fixations fixations = read_fixations(folder / "fixations.csv");
  check_writable(options.out + "/saliency.csv");
  std::vector<Method> all = methods();
  int pictures = 0;
  for (const auto& [name, points] : fixations) {
    const fs::path inner = folder / "stimuli" / name;
    judge(datasets::read_any_image(fs::exists(inner) ? inner : folder / name), points, all);
    ++pictures;
  }
  tell(all, pictures, options.out);
  return 0;
}

}  // namespace striate::evaluation
