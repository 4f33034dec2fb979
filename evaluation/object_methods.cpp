#include "striate/evaluation/object_methods.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/features2d.hpp>

#include "striate/perception/recognition/evidence.hpp"
#include "striate/perception/recognition/oriented_keypoints.hpp"
#include "striate/perception/recognition/recogniser.hpp"

namespace striate::evaluation {
namespace {

constexpr double kMostChance = 1e9;  // all but what agrees in four keypoints of hundreds

/// So that the threshold can be chosen afterwards.
perception::RecognitionSettings everything(perception::RecognitionMode mode) {
  perception::RecognitionSettings settings;
  settings.mode = mode;
  settings.least_inliers = 4;  // three carry any pose
  settings.most_chance = kMostChance;
  settings.paper_share = 0.0;
  return settings;
}

/// How unlikely by chance a recognition is: from 0 up, a power of ten each.
double unlikeliness(double score) {
  return std::log10(kMostChance) - perception::log10_expected_of(score, kMostChance);
}

class Ours final : public ObjectMethod {
 public:
  /// @param keypoints how images become keypoints.
  Ours(std::string name, perception::RecognitionMode mode, perception::KeypointSource keypoints)
      : name_(std::move(name)),
        settings_(everything(mode)),
        keypoints_(std::move(keypoints)),
        recogniser_(settings_) {}

  [[nodiscard]] std::string name() const override { return name_; }
  void teach(const std::vector<TaughtObject>& objects) override {
    recogniser_ = perception::Recogniser(settings_);
    count_ = objects.size();
    for (std::size_t k = 0; k < count_; ++k) {
      for (const TaughtImage& image : objects[k].pictures) {
        recogniser_.add(static_cast<int>(k),
                        perception::make_view(image.grey, image.region, keypoints_));
      }
    }
  }
  [[nodiscard]] ObjectScores look(const cv::Mat1b& scene) override {
    ObjectScores scores(count_, 0.0);
    for (const perception::Recognition& found : recogniser_.recognise(keypoints_(scene))) {
      scores[static_cast<std::size_t>(found.landmark)] =
          settings_.mode == perception::RecognitionMode::paper ? 100.0 * found.matched_fraction
                                                               : unlikeliness(found.score);
    }
    return scores;
  }

 private:
  std::string name_;
  perception::RecognitionSettings settings_;
  perception::KeypointSource keypoints_;
  std::size_t count_ = 0;
  perception::Recogniser recogniser_;
};

/// One of OpenCV's detectors and descriptors, through our choice of pairs and our consensus.
class OpenCvMethod final : public ObjectMethod {
 public:
  OpenCvMethod(std::string name, cv::Ptr<cv::Feature2D> feature)
      : name_(std::move(name)),
        feature_(std::move(feature)),
        matcher_(feature_->defaultNorm()),
        settings_(everything(perception::RecognitionMode::robust)),
        consensus_(settings_) {}

  [[nodiscard]] std::string name() const override { return name_; }
  void teach(const std::vector<TaughtObject>& objects) override {
    views_.clear();
    count_ = objects.size();
    for (std::size_t k = 0; k < objects.size(); ++k) {
      for (const TaughtImage& image : objects[k].pictures) {
        views_.push_back(describe(image.grey, image.region));
        views_.back().object = k;
      }
    }
  }
  [[nodiscard]] ObjectScores look(const cv::Mat1b& scene) override {
    ObjectScores scores(count_, 0.0);
    const View seen = describe(scene, {0, 0, scene.cols, scene.rows});
    for (const View& view : views_) {
      const perception::Consensus consensus =
          consensus_.find(pairs(seen, view), view.size.width, view.size.height);
      scores[view.object] = std::max(scores[view.object], static_cast<double>(consensus.inliers));
    }
    return scores;
  }

 private:
  struct View {
    std::size_t object = 0;
    cv::Size size;
    std::vector<perception::KeypointFrame> places;
    cv::Mat descriptors;
  };

  [[nodiscard]] View describe(const cv::Mat1b& grey, const cv::Rect& region) const {
    View view{0, region.size(), {}, {}};
    std::vector<cv::KeyPoint> points;
    cv::Mat1b mask(grey.size(), std::uint8_t{0});
    mask(region).setTo(255);
    feature_->detectAndCompute(grey, mask, points, view.descriptors);
    for (const cv::KeyPoint& point : points) {
      view.places.push_back({point.pt.x - region.x, point.pt.y - region.y, point.size,
                             point.angle * std::numbers::pi / 180.0});
    }
    return view;
  }

  /// The rule of Recogniser::add_pair, without a limit of distance.
  [[nodiscard]] std::vector<perception::PlacePair> pairs(const View& seen, const View& view) const {
    std::vector<perception::PlacePair> result;
    if (seen.places.empty() || view.places.size() < 2) return result;
    std::vector<std::vector<cv::DMatch>> nearest;
    matcher_.knnMatch(seen.descriptors, view.descriptors, nearest, 6);
    for (const std::vector<cv::DMatch>& of_point : nearest) {
      const int first = of_point.front().trainIdx;
      const perception::KeypointFrame& place = view.places[static_cast<std::size_t>(first)];
      double second = of_point.back().distance;
      for (const cv::DMatch& match : of_point) {
        const perception::KeypointFrame& other =
            view.places[static_cast<std::size_t>(match.trainIdx)];
        const double apart = std::hypot(other.u_px - place.u_px, other.v_px - place.v_px);
        if (apart >= place.size_px) second = std::min<double>(second, match.distance);
      }
      if (of_point.front().distance >= settings_.ratio * second) continue;
      result.push_back(
          {place, seen.places[static_cast<std::size_t>(of_point.front().queryIdx)], first});
    }
    return result;
  }

  std::string name_;
  cv::Ptr<cv::Feature2D> feature_;
  cv::BFMatcher matcher_;
  perception::RecognitionSettings settings_;
  perception::ConsensusFinder consensus_;
  std::size_t count_ = 0;
  std::vector<View> views_;
};

}  // namespace

std::vector<std::unique_ptr<ObjectMethod>> object_methods() {
  std::vector<std::unique_ptr<ObjectMethod>> methods;
  auto oriented = std::make_shared<perception::OrientedKeypoints>(perception::OrientedSettings{});
  methods.push_back(
      std::make_unique<Ours>("Striate", perception::RecognitionMode::robust,
                             [oriented](const cv::Mat1b& grey) { return (*oriented)(grey); }));
  auto finder = std::make_shared<perception::KeypointFinder>(perception::KeypointSettings{});
  methods.push_back(
      std::make_unique<Ours>("paper's rule", perception::RecognitionMode::paper,
                             [finder](const cv::Mat1b& grey) { return finder->find(grey); }));
  methods.push_back(std::make_unique<OpenCvMethod>("ORB", cv::ORB::create(2000)));
  methods.push_back(std::make_unique<OpenCvMethod>("BRISK", cv::BRISK::create()));
  methods.push_back(std::make_unique<OpenCvMethod>("SIFT", cv::SIFT::create()));
  return methods;
}

}  // namespace striate::evaluation
