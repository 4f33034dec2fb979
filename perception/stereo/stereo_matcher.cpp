#include "perception/stereo/stereo_matcher.hpp"

#include <array>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>

#include "config/user_error.hpp"
#include "perception/descriptor/dense_descriptor.hpp"
#include "perception/stereo/cost_kernels.hpp"
#include "perception/stereo/decision.hpp"
#include "perception/stereo/semi_global.hpp"
#include "perception/v1/v1_cells.hpp"

namespace striate {
namespace {

V1Settings v1_settings(const StereoSettings& s) {
  V1Settings v1;  // the paper's
  v1.wavelength_px = s.wavelength_px;
  if (s.setting == StereoSetting::robust) {
    v1.sigma_factor = s.robust.sigma_factor;
    v1.gamma = s.robust.gamma;
  }
  return v1;
}

void check(const StereoSettings& s) {
  auto require = [](bool good, const std::string& what) {
    if (!good) throw UserError("stereo: " + what);
  };
  require(s.candidates >= 0 && s.candidates <= 256, "candidates must be 0 .. 256");
  require(s.width >= 1, "width must be at least 1 px");
  require(s.wavelength_px >= 3.0 && s.wavelength_px <= 12.0, "wavelength must be 3 .. 12 px");
  require(s.robust.large_step_penalty >= 1 && s.robust.large_step_penalty <= 120 &&
              s.robust.small_step_penalty >= 0 && s.robust.small_step_penalty <= 120,
          "step penalties must be at most 120 bits");
}

}  // namespace

class StereoMatcher::Work {
 public:
  explicit Work(const StereoSettings& settings)
      : settings_(settings),
        robust_(settings.setting == StereoSetting::robust),
        widening_(robust_ ? settings.robust.widening : 1.0),
        points_(descriptor_points(settings.wavelength_px, widening_)),
        cells_(v1_settings(settings)),
        semi_global_(settings.robust.small_step_penalty, settings.robust.large_step_penalty),
        decision_(settings.robust) {}

  void match(const cv::Mat1b& left, const cv::Mat1b& right, DisparityMap& out) {
    const int reach = descriptor_reach(settings_.wavelength_px, widening_);
    cells_.respond(left, reach, false, left_);
    cells_.respond(right, reach, false, right_);
    prepare(left.cols);
    out.disparity_px.create(left.size());
    out.confidence.create(left.size());
    if (robust_) {
      match_robust(left.size(), out);
    } else {
      match_as_paper(left.size(), out);
    }
  }

  [[nodiscard]] const StereoSettings& settings() const { return settings_; }

 private:
  /// Disparities 0 .. candidates_ - 1; vector code fills a multiple of 4.
  void prepare(int width) {
    candidates_ = settings_.searched();
    rounded_ = (candidates_ + 3) / 4 * 4;
    left_row_.resize(width, kDescriptorPoints, 0, 0);
    right_row_.resize(width, kDescriptorPoints, rounded_ + 4, 0);
    outside_.resize(width, 1, rounded_ + 4, 0);
    std::fill(outside_.row(0) - outside_.margin(), outside_.row(0), std::uint8_t{255});
    std::fill(outside_.row(0), outside_.row(0) + width, std::uint8_t{0});
  }

  void cost_row(int y, int width, std::uint8_t* costs, int stride) {
    const DescriptorRow left{left_row_.row(0), left_row_.stride()};
    const DescriptorRow right{right_row_.row(0), right_row_.stride()};
    describe_row(left_, points_, y, left);
    describe_row(right_, points_, y, right);
    stereo_kernels::hamming_costs(left, right, outside_.row(0), width, rounded_, costs, stride);
  }

  void match_as_paper(cv::Size size, DisparityMap& out) {
    costs_.resize(1, rounded_, size.width);
    winners_.resize(size.width, 1, 0, 0);
    raw_.create(size);
    for (int y = 0; y < size.height; ++y) {
      cost_row(y, size.width, costs_.line(0), costs_.plane.stride());
      stereo_kernels::smallest_cost(costs_.line(0), costs_.plane.stride(), size.width, candidates_,
                                    winners_.row(0));
      std::copy(winners_.row(0), winners_.row(0) + size.width, raw_.ptr(y));
    }
    cv::medianBlur(raw_, median_, 5);
    median_.convertTo(out.disparity_px, CV_32F);
    out.confidence.setTo(1.0F);
  }

  void match_robust(cv::Size size, DisparityMap& out) {
    costs_.resize(size.height, rounded_, size.width);
    for (int y = 0; y < size.height; ++y) {
      cost_row(y, size.width, costs_.line(y), costs_.plane.stride());
    }
    costs_.disparities = rounded_;
    semi_global_.smooth(costs_, size.height, sums_);
    decision_.decide({costs_, sums_, left_, candidates_}, out);
  }

  StereoSettings settings_;
  bool robust_;
  double widening_;
  std::array<DescriptorPoint, kDescriptorPoints> points_;
  V1Cells cells_;
  SemiGlobal semi_global_;
  Decision decision_;
  V1Responses left_, right_;
  int candidates_ = 0;
  int rounded_ = 0;
  Plane<std::uint8_t> left_row_, right_row_, outside_, winners_;
  Volume<std::uint8_t> costs_;
  Volume<std::uint16_t> sums_;
  cv::Mat1b raw_, median_;
};

StereoMatcher::StereoMatcher(const StereoSettings& settings) {
  check(settings);
  work_ = std::make_unique<Work>(settings);
}
StereoMatcher::~StereoMatcher() = default;
StereoMatcher::StereoMatcher(StereoMatcher&&) noexcept = default;
StereoMatcher& StereoMatcher::operator=(StereoMatcher&&) noexcept = default;

const StereoSettings& StereoMatcher::settings() const {
  return work_->settings();
}

DisparityMap StereoMatcher::match(const cv::Mat1b& left, const cv::Mat1b& right) {
  DisparityMap out;
  match(left, right, out);
  return out;
}

void StereoMatcher::match(const cv::Mat1b& left, const cv::Mat1b& right, DisparityMap& out) {
  if (left.empty()) throw std::invalid_argument("StereoMatcher: the left picture is empty");
  if (left.size() != right.size()) {
    throw std::invalid_argument("StereoMatcher: the pictures differ in size: left " +
                                std::to_string(left.cols) + "x" + std::to_string(left.rows) +
                                ", right " + std::to_string(right.cols) + "x" +
                                std::to_string(right.rows));
  }
  work_->match(left, right, out);
}

}  // namespace striate
