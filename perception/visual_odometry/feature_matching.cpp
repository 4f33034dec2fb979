#include "striate/perception/visual_odometry/feature_matching.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace striate::perception {
namespace {

constexpr double kFeatureCell_px = 24.0;  // a cell of the grid: some features each (by hand)
constexpr double kSameThing_px = 3.0;  // features so near each other may be of one thing (by hand)
constexpr std::size_t kNoFeature = std::numeric_limits<std::size_t>::max();
constexpr double kFar = std::numeric_limits<double>::infinity();

/// The nearest, and the second nearest that is not the same thing found twice.
class BestTwo {
 public:
  BestTwo(const FeatureSet& set) : set_(&set) {}
  void offer(std::size_t index, double distance) {
    if (distance < best_) {
      if (best_index_ != kNoFeature && !beside(index, best_index_)) second_ = best_;
      best_ = distance;
      best_index_ = index;
    } else if (distance < second_ && !beside(index, best_index_)) {
      second_ = distance;
    }
  }
  [[nodiscard]] std::size_t index() const { return best_index_; }
  [[nodiscard]] double distance() const { return best_; }
  [[nodiscard]] bool clear(double most_ratio) const {
    return best_index_ != kNoFeature && best_ <= set_->most_distance && best_ < second_ &&
           best_ <= most_ratio * second_;
  }

 private:
  [[nodiscard]] bool beside(std::size_t a, std::size_t b) const {
    const Feature& x = set_->features[a];
    const Feature& y = set_->features[b];
    const double near_px = kSameThing_px * std::max(x.scale, y.scale);
    return std::abs(x.u_px - y.u_px) < near_px && std::abs(x.v_px - y.v_px) < near_px;
  }
  const FeatureSet* set_;
  std::size_t best_index_ = kNoFeature;
  double best_ = kFar, second_ = kFar;
};

bool alike_in_scale(const Feature& a, const Feature& b, double most_scale) {
  return a.scale <= most_scale * b.scale && b.scale <= most_scale * a.scale;
}

/// Of pairs with their distances, those whose second is nobody else's nearer one.
class MutualPairs {
 public:
  explicit MutualPairs(std::size_t count) : nearest_(count, kFar) {}
  void saw(std::size_t to, double distance) { nearest_[to] = std::min(nearest_[to], distance); }
  void add(std::size_t from, std::size_t to, double distance) {
    pairs_.push_back({from, to});
    distances_.push_back(distance);
  }
  [[nodiscard]] std::vector<FeaturePair> mutual() const {
    std::vector<FeaturePair> result;
    std::vector<char> taken(nearest_.size(), 0);
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
      if (distances_[k] > nearest_[pairs_[k].to] || taken[pairs_[k].to] != 0) continue;
      taken[pairs_[k].to] = 1;
      result.push_back(pairs_[k]);
    }
    return result;
  }

 private:
  std::vector<double> nearest_;
  std::vector<FeaturePair> pairs_;
  std::vector<double> distances_;
};

}  // namespace

FeatureGrid::FeatureGrid(const FeatureSet& set, cv::Size image)
    : columns_(static_cast<int>(image.width / kFeatureCell_px) + 1),
      rows_(static_cast<int>(image.height / kFeatureCell_px) + 1),
      cells_(static_cast<std::size_t>(columns_ * rows_)) {
  for (std::size_t k = 0; k < set.size(); ++k) {
    const int at = row_at(set.features[k].v_px) * columns_ + column_at(set.features[k].u_px);
    cells_[static_cast<std::size_t>(at)].push_back(k);
  }
}

int FeatureGrid::column_at(double u_px) const {
  return static_cast<int>(std::clamp(u_px / kFeatureCell_px, 0.0, columns_ - 1.0));
}

int FeatureGrid::row_at(double v_px) const {
  return static_cast<int>(std::clamp(v_px / kFeatureCell_px, 0.0, rows_ - 1.0));
}

std::vector<FeaturePair> match_eyes(const FeatureSet& left, const FeatureSet& right,
                                    const FeatureGrid& right_grid, cv::Size image, double doffs_px,
                                    const FeatureMatchSettings& settings) {
  MutualPairs pairs(right.size());
  const double most_px = settings.most_disparity * image.width;
  for (std::size_t i = 0; i < left.size(); ++i) {
    const Feature& a = left.features[i];
    const double row_px = settings.row_px * a.scale;
    // A point at infinity lies doffs to the right; keypoints err a little beyond it.
    const double to_u = a.u_px + doffs_px + row_px;
    const double from_u = a.u_px + doffs_px - most_px;
    BestTwo best(right);
    right_grid.visit(from_u, to_u, a.v_px - row_px, a.v_px + row_px, [&](std::size_t j) {
      const Feature& b = right.features[j];
      if (b.u_px < from_u || b.u_px > to_u || std::abs(b.v_px - a.v_px) > row_px) return;
      if (!alike_in_scale(a, b, settings.most_scale)) return;
      const double distance = descriptor_distance(left, i, right, j);
      pairs.saw(j, distance);
      best.offer(j, distance);
    });
    if (best.clear(settings.most_ratio)) pairs.add(i, best.index(), best.distance());
  }
  return pairs.mutual();
}

std::vector<FeaturePair> match_near(const FeatureSet& then,
                                    const std::vector<LookedFor>& looked_for, const FeatureSet& now,
                                    const FeatureGrid& now_grid, double radius_px,
                                    const FeatureMatchSettings& settings) {
  MutualPairs pairs(now.size());
  for (std::size_t k = 0; k < looked_for.size(); ++k) {
    const LookedFor& look = looked_for[k];
    const Feature& a = then.features[look.feature];
    BestTwo best(now);
    now_grid.visit(look.u_px - radius_px, look.u_px + radius_px, look.v_px - radius_px,
                   look.v_px + radius_px, [&](std::size_t j) {
                     const Feature& b = now.features[j];
                     const double du = b.u_px - look.u_px, dv = b.v_px - look.v_px;
                     if (du * du + dv * dv > radius_px * radius_px) return;
                     if (!alike_in_scale(a, b, settings.most_scale)) return;
                     const double distance = descriptor_distance(then, look.feature, now, j);
                     pairs.saw(j, distance);
                     best.offer(j, distance);
                   });
    if (best.clear(settings.most_ratio)) pairs.add(k, best.index(), best.distance());
  }
  return pairs.mutual();
}

}  // namespace striate::perception
