#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "striate/base/time.hpp"
#include "striate/perception/obstacles/view_geometry.hpp"
#include "striate/perception/recognition/finder_settings.hpp"
#include "striate/perception/recognition/look_windows.hpp"
#include "striate/perception/recognition/oriented_keypoints.hpp"
#include "striate/perception/recognition/recogniser.hpp"

namespace striate::perception {

/// Where memory expects a landmark, in the robot frame at the moment of the image.
struct LandmarkExpectation {
  int landmark = 0;
  SpacePoint place;      ///< of its middle
  double half_m = 0.15;  ///< it reaches so far to either side, up and down
};

/// How memory guides the eye in one image. Only looks at what is its maker's, who says for how
/// long it holds. Empty: nothing is looked for.
struct LandmarkExpectations {
  /// Numbers of views (their places in the list that the finder was made with) in the order in
  /// which they are compared, the most active first. Where they are more than the budget, the first
  /// take three quarters of it, and the others take turns from image to image. Views that are
  /// not in it are not looked for.
  std::span<const int> views;
  /// Where landmarks are expected; the first are looked at first.
  std::span<const LandmarkExpectation> places;
};

/// What looking for landmarks in one image came to; both empty where it was not its turn.
struct LandmarkLook {
  std::vector<Recognition> recognitions;  ///< most inliers first
  std::vector<ExpectedLook> expected;     ///< of each landmark that was expected somewhere
};

/// What a landmark looks like; landmarks are numbered by whoever remembers them.
struct KnownView {
  int landmark = 0;
  LandmarkView view;
};

/// Looks for landmarks in an image: where memory expects one, then in the salient regions, most
/// salient first. Keypoints of those windows, found at the camera's full size, are compared with
/// the views in the order that memory gives. The paper's section on recognition.
///
/// Knows nothing by itself: views, their order and what is expected are handed in. Without a view
/// it does nothing. Buffers are kept.
class LandmarkFinder {
 public:
  /// @param clock what the setting `most_time` is measured with; it must outlive this. nullptr:
  /// there is no limit of time.
  /// @throws UserError for settings out of range, std::invalid_argument as Recogniser::add.
  explicit LandmarkFinder(const LandmarkFinderSettings& settings,
                          std::span<const KnownView> views = {}, const Clock* clock = nullptr);

  [[nodiscard]] std::size_t views() const { return recogniser_.size(); }

  /// Looks where this image's turn has come.
  /// @param grey the left image at the camera's full size
  /// @param percept of the same image; its disparity and salient regions are at the working size
  [[nodiscard]] LandmarkLook find(const cv::Mat1b& grey, const ViewGeometry& geometry,
                                  const Percept& percept, const LandmarkExpectations& expected);

 private:
  void choose_windows(const cv::Mat1b& grey, const ViewGeometry& geometry, const Percept& percept,
                      std::span<const LandmarkExpectation> expected);
  void gather_keypoints(const cv::Mat1b& grey);
  void choose_views(std::span<const int> order);
  [[nodiscard]] const std::vector<Recognition>& compare();
  void keep_one_a_place(const std::vector<Recognition>& found,
                        std::vector<Recognition>& kept) const;
  void place(const ViewGeometry& geometry, const DisparityMap& map, Recognition& found);
  [[nodiscard]] LookResult judge(const LandmarkExpectation& expected, const ViewGeometry& geometry,
                                 const Percept& percept, std::span<const int> order);
  [[nodiscard]] bool compared(int landmark, std::span<const int> order) const;

  LandmarkFinderSettings settings_;
  Recogniser recogniser_;
  std::vector<int> landmark_of_view_;
  std::vector<int> chosen_;
  std::size_t turn_ = 0;  ///< of the views beyond the budget, the next one
  const Clock* clock_ = nullptr;
  std::int64_t pictures_ = 0;

  double zoom_ = 1.0;  ///< pixels of the image in a pixel of the working size
  LookWindows windows_;
  std::vector<ExpectedPlace> expected_;  ///< in pixels of the image
  std::array<std::unique_ptr<OrientedKeypoints>, LookWindows::kSizes> keypoints_of_size_;
  std::vector<Keypoint> in_window_, keypoints_;
  std::vector<float> disparities_;
};

}  // namespace striate::perception
