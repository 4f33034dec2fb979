#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "base/time.hpp"
#include "perception/obstacles/view_geometry.hpp"
#include "perception/recognition/finder_settings.hpp"
#include "perception/recognition/look_windows.hpp"
#include "perception/recognition/oriented_keypoints.hpp"
#include "perception/recognition/recogniser.hpp"

namespace striate {

/// Where memory expects a landmark, in the robot frame at the moment of the picture.
struct LandmarkExpectation {
  int landmark = 0;
  SpacePoint place;      ///< of its middle
  double half_m = 0.15;  ///< it reaches so far to either side, up and down
};

/// Looks for landmarks in a picture: where memory expects one, then in the salient regions, most
/// salient first. Keypoints of those windows, found at the camera's full size, are compared with
/// the views in the order that memory gives. The paper's section on recognition.
///
/// Knows nothing by itself: views, their order and what is expected are handed in. Without a view
/// it does nothing. Buffers are kept.
class LandmarkFinder {
 public:
  /// @throws UserError for settings out of range.
  explicit LandmarkFinder(const LandmarkFinderSettings& settings);

  /// @return the view's number, for look_for(). @throws std::invalid_argument as Recogniser::add.
  int know(int landmark, const LandmarkView& view);
  [[nodiscard]] bool knows_any() const { return recogniser_.size() > 0; }
  /// Views in the order in which they are compared, the most active first. Where they are more than
  /// the budget, the first take three quarters of it, and the others take turns from picture to
  /// picture. Views that are not in it are not looked for.
  void look_for(std::span<const int> views) { order_.assign(views.begin(), views.end()); }
  /// For the next pictures, until it is called again. The first are looked at first.
  void expect(std::span<const LandmarkExpectation> places) {
    expected_.assign(places.begin(), places.end());
  }
  /// What the setting `most_time` is measured with; it must outlive this. Without one there is no
  /// limit of time.
  void set_clock(const Clock* clock) { clock_ = clock; }

  /// Fills `percept.recognitions` and `percept.expected`, where this picture's turn has come.
  /// @param grey the left picture at the camera's full size; the percept's disparity and salient
  /// regions are at the working size
  void find(const cv::Mat1b& grey, const ViewGeometry& geometry, Percept& percept);

 private:
  void choose_windows(const cv::Mat1b& grey, const ViewGeometry& geometry, const Percept& percept);
  void gather_keypoints(const cv::Mat1b& grey);
  void choose_views();
  [[nodiscard]] const std::vector<Recognition>& compare();
  void keep_one_a_place(const std::vector<Recognition>& found,
                        std::vector<Recognition>& kept) const;
  void place(const ViewGeometry& geometry, const DisparityMap& map, Recognition& found);
  [[nodiscard]] LookResult judge(const LandmarkExpectation& expected, const ViewGeometry& geometry,
                                 const Percept& percept);
  [[nodiscard]] bool compared(int landmark) const;

  LandmarkFinderSettings settings_;
  Recogniser recogniser_;
  std::vector<int> landmark_of_view_;
  std::vector<int> order_, chosen_;
  std::size_t turn_ = 0;  ///< of the views beyond the budget, the next one
  std::vector<LandmarkExpectation> expected_;
  const Clock* clock_ = nullptr;
  std::int64_t pictures_ = 0;

  double zoom_ = 1.0;  ///< pixels of the picture in a pixel of the working size
  LookWindows windows_;
  std::array<std::unique_ptr<OrientedKeypoints>, LookWindows::kSizes> keypoints_of_size_;
  std::vector<Keypoint> in_window_, keypoints_;
  std::vector<float> disparities_;
};

}  // namespace striate
