#include "striate/evaluation/odometry/eval_odometry.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "striate/base/files.hpp"
#include "striate/evaluation/plot.hpp"
#include "striate/evaluation/report.hpp"

namespace striate::evaluation {
namespace {

nlohmann::ordered_json json_figures(const ErrorFigures& f) {
  return {{"count", f.count},
          {"rmse", f.rmse},
          {"mean", f.mean},
          {"median", f.median},
          {"max", f.most}};
}

std::vector<std::string> row_of(const std::string& name, const ErrorFigures& f) {
  const auto number = [](double value) { return fmt::format("{:.4f}", value); };
  if (f.count == 0) return {name, "-", "-", "-", "-", "0"};
  return {name,           number(f.rmse),         number(f.mean), number(f.median),
          number(f.most), std::to_string(f.count)};
}

std::string over_text(const OdometryScores& scores, const OdometryOptions& options) {
  return fmt::format("{:g} {}", options.over_s,
                     scores.timed            ? "s"
                     : options.over_s == 1.0 ? "pose"
                                             : "poses");
}

Report main_table(const OdometryScores& scores, const OdometryOptions& options) {
  Report table(fmt::format("{} poses, {:.2f} m of way", scores.poses.pairs.size(), scores.way_m),
               {"error", "rmse", "mean", "median", "most", "count"});
  table.add_row(
      row_of(fmt::format("ATE ({}), m", options.scale ? "Sim3" : "SE3"), scores.absolute));
  const std::string over = over_text(scores, options);
  table.add_row(row_of(fmt::format("RPE over {}, m", over), scores.relative.way_m));
  table.add_row(row_of(fmt::format("RPE over {}, deg", over), scores.relative.turn_deg));
  return table;
}

Report length_table(const OdometryScores& scores) {
  Report table("stretches, as KITTI counts them", {"length m", "percent", "deg per m", "count"});
  for (const LengthErrors& one : scores.kitti.lengths) {
    table.add_row({fmt::format("{:.1f}", one.length_m), fmt::format("{:.4f}", one.percent),
                   fmt::format("{:.6f}", one.deg_per_m), std::to_string(one.count)});
  }
  table.add_row({"all", fmt::format("{:.4f}", scores.kitti.percent),
                 fmt::format("{:.6f}", scores.kitti.deg_per_m),
                 std::to_string(scores.kitti.count)});
  return table;
}

double since_s(const OdometryScores& scores, std::size_t k) {
  return 1e-9 * static_cast<double>(scores.poses.pairs[k].estimate.stamp_ns -
                                    scores.poses.pairs.front().estimate.stamp_ns);
}

}  // namespace

OdometryScores score_odometry(const datasets::Trajectory& truth,
                              const datasets::Trajectory& estimate,
                              const OdometryOptions& options) {
  OdometryScores scores;
  scores.timed = truth.timed || estimate.timed;
  scores.poses = pair_poses(truth, estimate, options.pairing);
  invert_truth_if_it_is(options.body_from_sensor, options.scale, scores.poses);
  move_to_sensor(options.body_from_sensor, scores.poses.pairs);
  const std::vector<PosePair>& pairs = scores.poses.pairs;
  scores.alignment = align(pairs, options.scale);
  scores.absolute_m = absolute_errors(pairs, scores.alignment);
  scores.absolute = figures_of(scores.absolute_m);
  // A scale that is unknown is unknown in every motion, too.
  std::vector<PosePair> scaled = pairs;
  for (PosePair& pair : scaled) pair.estimate.position_m *= scores.alignment.scale;
  scores.relative = relative_errors(scaled, options.over_s);
  scores.way_m = way_of(pairs);
  scores.kitti = kitti_errors(
      scaled, options.lengths_m.empty() ? usual_lengths_m(scores.way_m) : options.lengths_m);
  return scores;
}

std::string scores_text(const OdometryScores& scores, const OdometryOptions& options) {
  std::string text = main_table(scores, options).text();
  if (options.scale) text += fmt::format("scale of the estimate: {:.6f}\n", scores.alignment.scale);
  if (scores.kitti.count > 0) {
    text += "\n" + length_table(scores).text();
    if (scores.kitti.lengths.front().length_m < 100.0 && options.lengths_m.empty()) {
      text +=
          "(KITTI's own lengths begin at 100 m; this way is shorter, and these are its tenths)\n";
    }
  } else {
    text += "no stretch of the lengths asked for: the way is too short\n";
  }
  return text;
}

std::string scores_json(const OdometryScores& scores, const OdometryOptions& options) {
  nlohmann::ordered_json json = {{"poses", scores.poses.pairs.size()},
                                 {"outside_truth", scores.poses.outside},
                                 {"in_gaps", scores.poses.in_gaps},
                                 {"way_m", scores.way_m},
                                 {"alignment", options.scale ? "Sim3" : "SE3"},
                                 {"scale", scores.alignment.scale},
                                 {"ate_m", json_figures(scores.absolute)},
                                 {"rpe_over", over_text(scores, options)},
                                 {"rpe_m", json_figures(scores.relative.way_m)},
                                 {"rpe_deg", json_figures(scores.relative.turn_deg)},
                                 {"kitti_percent", nullptr},
                                 {"kitti_deg_per_m", nullptr},
                                 {"kitti_lengths", nlohmann::ordered_json::array()},
                                 {"remarks", scores.poses.remarks}};
  if (scores.kitti.count > 0) {
    json["kitti_percent"] = scores.kitti.percent;
    json["kitti_deg_per_m"] = scores.kitti.deg_per_m;
  }
  for (const LengthErrors& one : scores.kitti.lengths) {
    json["kitti_lengths"].push_back({{"length_m", one.length_m},
                                     {"percent", one.percent},
                                     {"deg_per_m", one.deg_per_m},
                                     {"count", one.count}});
  }
  return json.dump(1) + "\n";
}

void write_scores(const OdometryScores& scores, const OdometryOptions& options,
                  const std::string& out) {
  write_file(out + "/odometry.csv", main_table(scores, options).csv());
  write_file(out + "/kitti_lengths.csv", length_table(scores).csv());
  Report errors("", {"time_s", "error_m"});
  PlotCurve curve{"position", {}, {}};
  std::vector<datasets::TimedPose> truth;
  std::vector<datasets::TimedPose> estimate;
  for (std::size_t k = 0; k < scores.poses.pairs.size(); ++k) {
    errors.add_row(
        {fmt::format("{:.6f}", since_s(scores, k)), fmt::format("{:.6f}", scores.absolute_m[k])});
    curve.x.push_back(since_s(scores, k));
    curve.y.push_back(scores.absolute_m[k]);
    truth.push_back(scores.poses.pairs[k].truth);
    truth.back().stamp_ns = scores.poses.pairs[k].estimate.stamp_ns;
    estimate.push_back(aligned(scores.poses.pairs[k].estimate, scores.alignment));
  }
  write_file(out + "/errors.csv", errors.csv());
  const Plot plot{"Absolute trajectory error", scores.timed ? "s" : "poses", "m", {curve}};
  write_file(out + "/odometry_error.svg", plot.svg());
  write_file(out + "/estimate_aligned.tum", datasets::tum_text(estimate));
  write_file(out + "/truth_at_estimate.tum", datasets::tum_text(truth));
}

}  // namespace striate::evaluation
