#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "striate/base/files.hpp"
#include "striate/evaluation/evaluation.hpp"
#include "striate/evaluation/object_methods.hpp"
#include "striate/evaluation/plot.hpp"
#include "striate/evaluation/report.hpp"

namespace striate::evaluation {
namespace {

/// One object in one scene.
struct Judged {
  std::string scene, object;
  double score;
  bool present;
};

struct Point {
  double threshold;  ///< a score at or above it counts as found
  int found, false_alarms;
};

std::vector<Judged> judge(ObjectMethod& method, const ObjectSet& set) {
  method.teach(set.objects);
  std::vector<Judged> result;
  for (const ObjectScene& scene : set.scenes) {
    const ObjectScores scores = method.look(scene.grey);
    for (std::size_t k = 0; k < set.objects.size(); ++k) {
      const std::string& name = set.objects[k].name;
      if (scene.not_judged.contains(name)) continue;
      result.push_back({scene.name, name, scores[k], scene.present.contains(name)});
    }
  }
  return result;
}

std::vector<Point> sweep(const std::vector<Judged>& judged) {
  std::set<double, std::greater<>> thresholds;
  for (const Judged& one : judged) {
    if (one.score > 0.0) thresholds.insert(one.score);
  }
  std::vector<Point> points;
  for (const double threshold : thresholds) {
    Point point{threshold, 0, 0};
    for (const Judged& one : judged) {
      if (one.score < threshold) continue;
      ++(one.present ? point.found : point.false_alarms);
    }
    points.push_back(point);
  }
  return points;
}

std::string percent(int part, int whole) {
  return whole > 0 ? fmt::format("{:.1f}", 100.0 * part / whole) : "-";
}

/// The lowest threshold that lets no more than so many false alarms through.
Point at_false_alarms(const std::vector<Point>& points, int most) {
  Point best{0.0, 0, 0};
  for (const Point& point : points) {
    if (point.false_alarms <= most) best = point;
  }
  return best;
}

}  // namespace

int evaluate_objects(const EvalOptions& options) {
  const ObjectSet set = read_object_set(options.folder);
  int present = 0;
  for (const ObjectScene& scene : set.scenes) present += static_cast<int>(scene.present.size());
  Report summary(
      fmt::format("{} objects, {} scenes, {} to be found", set.objects.size(), set.scenes.size(),
                  present),
      {"method", "threshold", "found without false alarm", "with 1", "with 3", "recall % without"});
  Report curve("", {"method", "threshold", "found", "false alarms", "recall %", "precision %"});
  Report scores("", {"method", "scene", "object", "present", "score"});
  Plot plot{"Objects found", "recall %", "precision %", {}};
  for (const auto& method : object_methods()) {
    const std::vector<Judged> judged = judge(*method, set);
    const std::vector<Point> points = sweep(judged);
    PlotCurve line{method->name(), {}, {}};
    for (const Point& point : points) {
      const int claimed = point.found + point.false_alarms;
      curve.add_row({method->name(), fmt::format("{:g}", point.threshold),
                     std::to_string(point.found), std::to_string(point.false_alarms),
                     percent(point.found, present), percent(point.found, claimed)});
      line.x.push_back(100.0 * point.found / std::max(1, present));
      line.y.push_back(100.0 * point.found / claimed);
    }
    plot.curves.push_back(std::move(line));
    for (const Judged& one : judged) {
      scores.add_row({method->name(), one.scene, one.object, one.present ? "1" : "0",
                      fmt::format("{:g}", one.score)});
    }
    const Point none = at_false_alarms(points, 0);
    summary.add_row({method->name(), fmt::format("{:g}", none.threshold),
                     std::to_string(none.found), std::to_string(at_false_alarms(points, 1).found),
                     std::to_string(at_false_alarms(points, 3).found),
                     percent(none.found, present)});
  }
  fmt::print("{}", summary.text());
  write_file(options.out + "/objects.csv", summary.csv());
  write_file(options.out + "/objects_curves.csv", curve.csv());
  write_file(options.out + "/objects_scores.csv", scores.csv());
  write_file(options.out + "/objects.svg", plot.svg());
  return 0;
}

}  // namespace striate::evaluation
