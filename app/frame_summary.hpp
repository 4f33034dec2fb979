#pragma once

#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "striate/app/perceive_frame.hpp"

namespace striate::app {

/// One frame in a line: how dense, how near, how free, what stands out.
struct FrameSummary {
  std::size_t number = 0;
  std::string name;
  std::optional<double> since_s;  ///< the beginning of the sequence
  std::optional<double> dense;    ///< 0..1 of the pixels with a trusted disparity; two eyes only
  std::optional<double> nearest;  ///< obstacle, in `unit`
  double nearest_bearing_deg = 0.0;
  std::optional<double> free_share;  ///< 0..1 of the columns that see free floor; floor known only
  std::optional<double> free_ahead;  ///< within 10 degrees of straight on, how far it is free
  std::size_t salient = 0;           ///< regions
  double most_salient_bearing_deg = 0.0;
  std::optional<double> most_salient;  ///< how far the most salient region is, in `unit`
  std::string unit = "m";
  bool warned = false;  ///< something speaks against the pair
};

[[nodiscard]] FrameSummary summary_of(const JudgedFrame& judged);
[[nodiscard]] std::string text_of(const FrameSummary& summary);
[[nodiscard]] nlohmann::ordered_json json_of(const FrameSummary& summary);

/// All frames together; holds a few numbers whatever the length.
class SequenceSummary {
 public:
  void add(const FrameSummary& frame);
  [[nodiscard]] std::uint64_t frames() const { return frames_; }
  [[nodiscard]] std::string text() const;
  [[nodiscard]] nlohmann::ordered_json json() const;

 private:
  std::uint64_t frames_ = 0;
  std::uint64_t with_two_eyes_ = 0;
  std::uint64_t with_floor_ = 0;
  std::uint64_t warned_ = 0;
  double dense_sum_ = 0.0;
  double least_dense_ = 1.0;
  double free_sum_ = 0.0;
  double salient_sum_ = 0.0;
  std::optional<double> nearest_;
  std::size_t nearest_frame_ = 0;
  std::string unit_ = "m";
};

}  // namespace striate::app
