#include "striate/perception/stereo/stereo_matcher.hpp"

#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>

#include "striate/base/user_error.hpp"
#include "striate/perception/descriptor/dense_descriptor.hpp"
#include "striate/perception/descriptor/phase_code.hpp"
#include "striate/perception/stereo/decision.hpp"
#include "striate/perception/stereo/match_kernels.hpp"
#include "striate/perception/stereo/median_kernel.hpp"
#include "striate/perception/stereo/phase_costs.hpp"
#include "striate/perception/stereo/row_offset.hpp"
#include "striate/perception/stereo/semi_global.hpp"
#include "striate/perception/v1/v1_cells.hpp"

namespace striate::perception {
namespace {

/// Rows of the working size: less costs hardly anything (bad-2 of a quarter: tests/evaluation)
constexpr double kLeastOffset_px = 0.25;
/// Share of the image that must become known by it: what noise alone makes is less (ours)
constexpr double kLeastGained = 0.01;
constexpr int kMostAlignments = 3;  // by hand: 1.5 rows are found in two

void check_stereo(const StereoSettings& s) {
  auto require = [](bool good, const std::string& what) {
    if (!good) throw UserError("stereo: " + what);
  };
  require(s.candidates >= 0 && s.candidates <= 256, "candidates must be 0 .. 256");
  require(s.width >= 1, "width must be at least 1 px");
  for (const V1Settings& v1 : {s.paper_v1, s.robust.v1}) {
    require(v1.wavelength_px >= 3.0 && v1.wavelength_px <= 12.0, "wavelength must be 3 .. 12 px");
  }
  require(s.robust.large_step_penalty >= 1 && s.robust.large_step_penalty <= 120 &&
              s.robust.small_step_penalty >= 0 && s.robust.small_step_penalty <= 120,
          "step penalties must be at most 120 bits");
}

}  // namespace

class StereoMatcher::Work {
 public:
  explicit Work(const StereoSettings& settings)
      : settings_(settings),
        robust_(settings.mode == StereoMode::robust),
        points_(descriptor_points(settings.paper_v1.wavelength_px, 1.0)),
        cells_(robust_ ? settings.robust.v1 : settings.paper_v1),
        semi_global_(settings.robust.small_step_penalty, settings.robust.large_step_penalty),
        decision_(settings.robust) {}

  void match(const cv::Mat& left, const cv::Mat& right, DisparityMap& out) {
    prepare(left.cols);
    if (!out.disparity_px.isContinuous()) out.disparity_px.release();
    if (!out.confidence.isContinuous()) out.confidence.release();
    out.disparity_px.create(left.size());
    out.confidence.create(left.size());
    out.right_lower_px = 0.0;
    if (robust_) {
      match_robust(left, right, out);
      if (settings_.robust.align_rows) align_rows(left, right, out);
    } else {
      match_as_paper(left, right, out);
    }
  }

  [[nodiscard]] const StereoSettings& settings() const { return settings_; }

 private:
  /// Disparities 0 .. candidates_ - 1; vector code fills a multiple of 4.
  void prepare(int width) {
    candidates_ = settings_.searched();
    rounded_ = (candidates_ + 3) / 4 * 4;
    outside_.resize(width, 1, std::max(rounded_ + 4, stereo_kernels::kReachBack), 0);
    std::fill(outside_.row(0) - outside_.margin(), outside_.row(0), std::uint8_t{255});
    std::fill(outside_.row(0), outside_.row(0) + width, std::uint8_t{0});
  }

  void match_as_paper(const cv::Mat& left_image, const cv::Mat& right_image, DisparityMap& out) {
    const cv::Size size = left_image.size();
    const int reach = descriptor_reach(settings_.paper_v1.wavelength_px, 1.0);
    cells_.respond(left_image, reach, false, left_);
    cells_.respond(right_image, reach, false, right_);
    left_row_.resize(size.width, kDescriptorPoints, 0, 0);
    right_row_.resize(size.width, kDescriptorPoints, stereo_kernels::kReachBack, 0);
    smallest_.resize(size.width, 1, 0, 0);
    nibbles_.resize(size.width, stereo_kernels::kNibbleRows, 0, 0);
    winners_.resize(size.width, size.height, 2, 0);
    const DescriptorRow left{left_row_.row(0), left_row_.stride()};
    const DescriptorRow right{right_row_.row(0), right_row_.stride()};
    for (int y = 0; y < size.height; ++y) {
      describe_row(left_, points_, y, left);
      describe_row(right_, points_, y, right);
      stereo_kernels::best_matches({left, right, outside_.row(0), size.width, candidates_,
                                    smallest_.row(0), winners_.row(y), nibbles_.row(0)});
    }
    stereo_kernels::median_5x5(winners_, median_);
    const cv::Mat1b median(size.height, size.width, median_.row(0),
                           static_cast<std::size_t>(median_.stride()));
    median.convertTo(out.disparity_px, CV_32F);
    out.confidence.setTo(1.0F);
  }

  void match_robust(const cv::Mat& left, const cv::Mat& right, DisparityMap& out) {
    const cv::Size size = left.size();
    // The left eye's responses take the place of the right one's, which is still in the cache.
    cells_.respond_simple(right, SimpleCells::even_and_odd, left_);
    phase_codes(left_, rounded_, right_phase_);
    cells_.respond(left, 0, true, left_);
    phase_codes(left_, 0, left_phase_);
    costs_.resize(size.height, rounded_, size.width);
    const PhaseCosts::Job job{left_phase_, right_phase_, outside_, costs_};
    semi_global_.begin(costs_, size.height);
    for (int y = 0; y < size.height; ++y) {
      phase_costs_.compute_row(job, y);
      semi_global_.take_row(y);
    }
    const Decision::Input input{costs_, outside_, left_, candidates_};
    decision_.begin(input);
    for (int y = size.height - 1; y >= 0; --y) {
      decision_.decide_row(input, y, semi_global_.finish_row(y), out);
    }
    decision_.finish(out);
  }

  /// Matches once more what the eyes show at different heights, if more becomes known by that. The
  /// offset is found anew in what was moved: from a bad match it is too small.
  void align_rows(const cv::Mat& left, const cv::Mat& right, DisparityMap& out) {
    const double guess_px = row_offset_of_means_px(left, right);
    if (std::abs(guess_px) >= kLeastOffset_px) match_raised(left, right, guess_px, out);
    for (int k = 0; k < kMostAlignments; ++k) {
      const cv::Mat seen = out.right_lower_px == 0.0 ? right : raised(right, out.right_lower_px);
      const double found_px = row_offset_px(left, seen, out);
      if (std::abs(found_px) < kLeastOffset_px) return;
      if (!match_raised(left, right, out.right_lower_px + found_px, out)) return;
    }
  }

  /// @returns false, with `out` as it was, if no more became known.
  bool match_raised(const cv::Mat& left, const cv::Mat& right, double rows_px, DisparityMap& out) {
    aligned_.disparity_px.create(left.size());
    aligned_.confidence.create(left.size());
    match_robust(left, raised(right, rows_px), aligned_);
    const double gained = cv::sum(aligned_.confidence)[0] - cv::sum(out.confidence)[0];
    if (gained < kLeastGained * static_cast<double>(left.total())) return false;
    aligned_.disparity_px.copyTo(out.disparity_px);
    aligned_.confidence.copyTo(out.confidence);
    out.right_lower_px = rows_px;
    return true;
  }

  StereoSettings settings_;
  bool robust_;
  std::array<DescriptorPoint, kDescriptorPoints> points_;
  V1Cells cells_;
  SemiGlobal semi_global_;
  Decision decision_;
  V1Responses left_, right_;
  PhaseCodes left_phase_, right_phase_;
  PhaseCosts phase_costs_;
  DisparityMap aligned_;
  int candidates_ = 0;
  int rounded_ = 0;
  Plane<std::uint8_t> left_row_, right_row_, outside_, smallest_, nibbles_, winners_, median_;
  Volume<std::uint8_t> costs_;
};

StereoMatcher::StereoMatcher(const StereoSettings& settings) {
  check_stereo(settings);
  work_ = std::make_unique<Work>(settings);
}
StereoMatcher::~StereoMatcher() = default;
StereoMatcher::StereoMatcher(StereoMatcher&&) noexcept = default;
StereoMatcher& StereoMatcher::operator=(StereoMatcher&&) noexcept = default;

const StereoSettings& StereoMatcher::settings() const {
  return work_->settings();
}

DisparityMap StereoMatcher::match(const cv::Mat& left, const cv::Mat& right) {
  DisparityMap out;
  match(left, right, out);
  return out;
}

void StereoMatcher::match(const cv::Mat& left, const cv::Mat& right, DisparityMap& out) {
  if (left.empty()) throw std::invalid_argument("StereoMatcher: the left image is empty");
  if (left.size() != right.size()) {
    throw std::invalid_argument("StereoMatcher: the images differ in size: left " +
                                std::to_string(left.cols) + "x" + std::to_string(left.rows) +
                                ", right " + std::to_string(right.cols) + "x" +
                                std::to_string(right.rows));
  }
  work_->match(left, right, out);
}

}  // namespace striate::perception
