#pragma once

#include "striate/config/settings.hpp"
#include "striate/perception/obstacles/view_geometry.hpp"
#include "striate/perception/percept.hpp"
#include "striate/perception/saliency/gaussian.hpp"
#include "striate/perception/saliency/image_change.hpp"
#include "striate/perception/saliency/v1_channels.hpp"

namespace striate::perception {

/// Which channels make the salience.
enum class SaliencyMode { paper, robust };

struct SaliencySettings {
  SaliencyMode mode = SaliencyMode::robust;
  /// Weights of the robust channels; 0 switches one off. All 1 and not tuned (tests/evaluation)
  double colour = 1.0;
  double texture = 1.0;  ///< as colour: 1, not tuned
  double shape = 1.0;    ///< as colour: 1, not tuned
  double near = 1.0;     ///< as colour: 1, not tuned
  double motion = 0.0;   ///< needs the image before: off unless asked for
  double centre = 0.0;   ///< 0..1: how much a Gaussian about the image's middle counts
  /// Robust: the sum is blurred by this, at width 160: a cell of the channels (ours)
  double smooth_px = 4.0;
  /// Disparities above count as near: 4 m away at width 160. The paper gives no figure
  double near_px = 6.0;
  /// Weight of one px of disparity against one unit of CIE L*; the paper gives none (ours)
  double near_gain = 1.5;
  /// A image whose strongest response is below stays dim: a blank wall's noise (ours)
  double least_contrast = 6.0;
  /// Of the salience that regions are cut at; the paper gives no figure (ours)
  double threshold = 0.5;
  int smallest_px = 12;  ///< smaller regions are left out: 4 x 3 px, 4 cm at 2 m (ours)
  /// Regions handed on; looking at more in one image would cost more than the cycle has (ours)
  int most_regions = 12;
};

template <class V>
void visit(V& v, SaliencySettings& s) {
  using config::Unit;
  v.renamed("setting", "mode");
  v.choice("mode", s.mode, {"paper", "robust"}, "the paper's channels, or ours too");
  v.number("colour_weight", s.colour, Unit::none, {0.0, 10.0}, "robust: L*a*b* blobs");
  v.number("texture_weight", s.texture, Unit::none, {0.0, 10.0},
           "robust: V1 energy against its surround");
  v.number("shape_weight", s.shape, Unit::none, {0.0, 10.0}, "robust: middles of compact things");
  v.number("near_weight", s.near, Unit::none, {0.0, 10.0}, "robust: near things");
  v.number("motion_weight", s.motion, Unit::none, {0.0, 10.0},
           "robust: change that a shift of the image does not explain");
  v.number("centre_prior", s.centre, Unit::fraction, {0.0, 1.0},
           "robust: how much the middle of the image is preferred");
  v.number("smooth", s.smooth_px, Unit::pixels, {0.5, 20.0},
           "robust: blur of the sum, at width 160");
  v.number("near", s.near_px, Unit::pixels, {0.0, 200.0}, "larger disparities count as near");
  v.number("near_gain", s.near_gain, Unit::none, {0.0, 100.0},
           "weight of a pixel of disparity against a unit of CIE L*");
  v.number("least_contrast", s.least_contrast, Unit::none, {0.0, 100.0},
           "response below which an image stays dim; 0: normalise always, as the paper");
  v.number("threshold", s.threshold, Unit::fraction, {0.05, 0.99}, "salience of a region's border");
  v.integer("smallest", s.smallest_px, {1, 100000}, "least pixels of a region");
  v.integer("most_regions", s.most_regions, {1, 1000}, "regions handed on");
}

/// Salience of an image at the working size (BGR) and its disparity map, which may be empty.
///
/// Paper, section on saliency: six maps in CIE L*a*b* (L, a, b and their complements), blobs by
/// differences of Gaussians with sigma+ in {5, 10, 20} px and sigma- = 2 sigma+, half-rectified;
/// the same on the disparity thresholded to the near; sum, normalise, threshold. A map and its
/// complement have opposite responses, so their rectified sum is the absolute value: three maps
/// suffice, exactly. Gaussians run on a pyramid; tests hold the result against the direct sum.
/// Deviation: the normalisation has a floor (`least_contrast`), else noise on a blank wall would
/// be as salient as a poster.
[[nodiscard]] SaliencyMap find_salience(const cv::Mat3b& image, const DisparityMap& map,
                                        const ViewGeometry& geometry,
                                        const SaliencySettings& settings);

/// Weighs a map of any size with a Gaussian about its middle, sigma a quarter of width and height.
/// `share` 0 leaves it alone, 1 multiplies. People look there more often, and images are taken
/// so.
void prefer_centre(double share, cv::Mat1f& salience);

/// Salience in either setting. Keeps its buffers and, when motion is asked for, the image before,
/// which the first call and a change of size forget.
///
/// Robust (ours; the paper's future work): channels at a quarter of the working size, each divided
/// by its own mean so that weights compare: colour (the paper's blobs), texture and shape (from V1
/// energy at lambda = 4), near (the paper's), motion. Their sum is squared, which favours few
/// strong peaks over many alike (the purpose of Itti's map normalisation), and blurred. A channel
/// whose mean is below its noise counts less, so a blank wall stays dim.
class SaliencyFinder {
 public:
  explicit SaliencyFinder(const SaliencySettings& settings);
  /// As find_salience(); `image` may be empty.
  [[nodiscard]] SaliencyMap find(const cv::Mat3b& image, const DisparityMap& map,
                                 const ViewGeometry& geometry);

 private:
  void sum_of_channels(const cv::Mat3b& image, const DisparityMap& map);
  void add_v1_channels(const cv::Mat1b& grey);
  void add_motion(const cv::Mat1b& grey);
  void add_channel(double weight, double least_mean);

  SaliencySettings settings_;
  V1Cells cells_;
  V1Responses responses_;
  V1Channels v1_channels_;
  ImageChange change_;
  cv::Mat1f half_;           ///< a channel at half the working size
  cv::Mat1f channel_, sum_;  ///< at a quarter
  cv::Mat1f small_grey_;
  Gaussian smooth_{1.0};  ///< remade where the image's width changes
};

}  // namespace striate::perception
