#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "striate/base/counted.hpp"
#include "striate/base/files.hpp"
#include "striate/evaluation/odometry/compare_odometry.hpp"
#include "striate/evaluation/plot.hpp"
#include "striate/evaluation/report.hpp"

namespace striate::evaluation {
namespace {

double share_without(const MethodRun& run) {
  return run.views > 0 ? static_cast<double>(run.without) / static_cast<double>(run.views) : 0.0;
}

/// From where it began to where it ended, m.
double apart_m_of(const MethodRun& run) {
  if (run.estimate.poses.empty()) return 0.0;
  return cv::norm(run.estimate.poses.back().position_m - run.estimate.poses.front().position_m);
}

std::string title_of(const std::vector<MethodRun>& runs) {
  bool has_truth = false;
  for (const MethodRun& run : runs) {
    if (run.scores) {
      return fmt::format("{}, {:.2f} m of way", counted(run.views, "view"), run.scores->way_m);
    }
    has_truth = has_truth || !run.why_no_scores.empty();
  }
  return fmt::format("{}, {}", counted(runs.empty() ? 0 : runs.front().views, "view"),
                     has_truth ? "no run could be judged" : "no ground truth");
}

Report method_table(const std::vector<MethodRun>& runs, const OdometryOptions& options) {
  Report table(title_of(runs),
               {"features", "ATE m", fmt::format("RPE m ({:g} s)", options.over_s), "RPE deg",
                "KITTI %", "deg/m", "end m", "end %", "way m", "none %", "anew", "noise px", "ms"});
  for (const MethodRun& run : runs) {
    std::vector<std::string> row = {run.name};
    if (run.scores) {
      const OdometryScores& s = *run.scores;
      const bool stretches = s.kitti.count > 0;
      const double end_m = end_error_m(s);
      for (const double value :
           {s.absolute.rmse, s.relative.way_m.rmse, s.relative.turn_deg.rmse}) {
        row.push_back(fmt::format("{:.4f}", value));
      }
      row.push_back(stretches ? fmt::format("{:.3f}", s.kitti.percent) : "-");
      row.push_back(stretches ? fmt::format("{:.5f}", s.kitti.deg_per_m) : "-");
      row.push_back(fmt::format("{:.4f}", end_m));
      row.push_back(s.way_m > 0.0 ? fmt::format("{:.3f}", 100.0 * end_m / s.way_m) : "-");
    } else {
      row.insert(row.end(), 7, "-");
    }
    row.push_back(fmt::format("{:.2f}", estimated_way_m(run)));
    row.push_back(fmt::format("{:.1f}", 100.0 * share_without(run)));
    row.push_back(std::to_string(run.begun_anew));
    row.push_back(fmt::format("{:.3f}", run.noise_px));
    row.push_back(fmt::format("{:.1f}", run.ms));
    table.add_row(std::move(row));
  }
  return table;
}

std::string why_text(const std::vector<MethodRun>& runs) {
  std::string text;
  for (const MethodRun& run : runs) {
    if (run.without == 0) continue;
    text += run.name + " without an estimate:";
    for (const auto& [why, count] : run.why) text += fmt::format(" {} {}", why, count);
    text += "\n";
  }
  return text;
}

void write_error_plot(const std::vector<MethodRun>& runs, const std::string& file) {
  Plot plot{"Absolute trajectory error", "s", "m", {}};
  for (const MethodRun& run : runs) {
    if (!run.scores) continue;
    if (!run.scores->timed) plot.x_label = "poses";
    PlotCurve curve{run.name, {}, run.scores->absolute_m};
    const auto& pairs = run.scores->poses.pairs;
    for (const PosePair& pair : pairs) {
      curve.x.push_back(
          1e-9 * static_cast<double>(pair.estimate.stamp_ns - pairs.front().estimate.stamp_ns));
    }
    plot.curves.push_back(std::move(curve));
  }
  if (!plot.curves.empty()) write_file(file, plot.svg());
}

}  // namespace

std::string runs_text(const std::vector<MethodRun>& runs, const OdometryOptions& options) {
  return method_table(runs, options).text() + why_text(runs);
}

std::string runs_json(const std::vector<MethodRun>& runs, const OdometryOptions& options) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const MethodRun& run : runs) {
    nlohmann::ordered_json one = {{"features", run.name},
                                  {"views", run.views},
                                  {"without_estimate", run.without},
                                  {"share_without", share_without(run)},
                                  {"why", run.why},
                                  {"begun_anew", run.begun_anew},
                                  {"estimated_way_m", estimated_way_m(run)},
                                  {"begin_to_end_m", apart_m_of(run)},
                                  {"noise_px", run.noise_px},
                                  {"ms", run.ms},
                                  {"end_error_m", nullptr},
                                  {"scores", nullptr},
                                  {"why_no_scores", nullptr}};
    if (!run.why_no_scores.empty()) one["why_no_scores"] = run.why_no_scores;
    if (run.scores) {
      one["end_error_m"] = end_error_m(*run.scores);
      one["scores"] = nlohmann::ordered_json::parse(scores_json(*run.scores, options));
    }
    json.push_back(std::move(one));
  }
  return json.dump(1) + "\n";
}

void write_runs(const std::vector<MethodRun>& runs, const OdometryOptions& options,
                const std::string& out) {
  write_file(out + "/methods.csv", method_table(runs, options).csv());
  write_error_plot(runs, out + "/errors.svg");
  for (const MethodRun& run : runs) {
    write_file(out + "/" + run.name + ".tum", datasets::tum_text(run.estimate.poses));
    if (!run.scores) continue;
    make_folder(out + "/" + run.name);
    write_scores(*run.scores, options, out + "/" + run.name);
  }
}

}  // namespace striate::evaluation
