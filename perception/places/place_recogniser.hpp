#pragma once

#include <functional>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "striate/perception/gist/gist.hpp"
#include "striate/perception/places/place_settings.hpp"
#include "striate/perception/recognition/recogniser.hpp"

namespace striate::perception {

/// What a place looks like in one direction.
struct PlaceView {
  Gist gist;
  LandmarkView view;  ///< keypoints and descriptors of the whole image
};

/// Looks at an image as at a place. Keeps its buffers.
class PlaceEye {
 public:
  explicit PlaceEye(const PlaceSettings& settings = {});
  /// @param grey any size; empty throws std::invalid_argument.
  [[nodiscard]] PlaceView look(const cv::Mat1b& grey);

 private:
  GistFinder gist_;
  OrientedKeypoints keypoints_;
};

/// A place that the gist proposed, and what the keypoints say.
struct PlaceMatch {
  int place = 0;
  double gist_distance = 0.0;  ///< 0 to sqrt(2)
  /// Powers of ten by which the agreement is rarer than chance; 0: none
  double evidence = 0.0;
  int inliers = 0;     ///< keypoints that agree
  double scale = 0.0;  ///< pixels of the image a pixel of the place's view; above 1: nearer now
};

enum class PlaceVerdict {
  known,           ///< one place is confirmed, and no other one nearly as well
  ambiguous,       ///< another place agrees nearly as well
  nothing_agrees,  ///< no proposal is confirmed
  nothing_known    ///< there is no place to be compared with
};

struct PlaceAnswer {
  PlaceVerdict verdict = PlaceVerdict::nothing_known;
  /// 0..1; 0.5 is enough, and is reached where evidence and lead are just what is asked for
  double confidence = 0.0;
  std::vector<PlaceMatch> matches;  ///< all that were compared, most evidence first
  /// The best one of them that is another place than the first; -1: none
  int other = -1;
};

/// Knows places again: the gist proposes, and keypoints that agree on one pose confirm, by how rare
/// that would be by chance (../recognition). Never the gist alone. Deterministic: all is tried in
/// the order of the numbers, there are no random ones.
class PlaceRecogniser {
 public:
  /// @throws UserError for settings out of range.
  explicit PlaceRecogniser(const PlaceSettings& settings = {});

  /// @return the place's number, from 0 upwards
  /// @throws std::invalid_argument where keypoints and descriptors differ in number.
  int add(PlaceView view);
  [[nodiscard]] std::size_t size() const { return places_.size(); }
  [[nodiscard]] const PlaceView& view(int place) const {
    return places_[static_cast<std::size_t>(place)];
  }

  /// The nearest by gist, at most `most`, nearest first.
  /// @param may_be whether a place is to be looked at; empty: all are
  [[nodiscard]] std::vector<PlaceMatch> propose(const Gist& now, int most,
                                                const std::function<bool(int)>& may_be = {}) const;

  /// @param same whether two numbers stand for one place, as neighbours do: they do not contend,
  /// and those of the best proposal are compared, too. Empty: none do.
  [[nodiscard]] PlaceAnswer find(const PlaceView& now, const std::function<bool(int)>& may_be = {},
                                 const std::function<bool(int, int)>& same = {});

 private:
  void compare(std::span<const Keypoint> keypoints, PlaceMatch& match);
  void add_neighbours(const Gist& now, const std::function<bool(int)>& may_be,
                      const std::function<bool(int, int)>& same,
                      std::vector<PlaceMatch>& matches) const;
  void judge(const std::function<bool(int, int)>& same, PlaceAnswer& answer) const;

  PlaceSettings settings_;
  Recogniser recogniser_;
  std::vector<PlaceView> places_;
};

/// "known", "ambiguous", ...
[[nodiscard]] const char* word_of(PlaceVerdict verdict);

}  // namespace striate::perception
