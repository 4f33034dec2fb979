#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "striate/base/counted.hpp"
#include "striate/base/files.hpp"
#include "striate/evaluation/places/eval_places.hpp"
#include "striate/evaluation/plot.hpp"
#include "striate/evaluation/report.hpp"

namespace striate::evaluation {
namespace {

std::string percent_of(double share) {
  return fmt::format("{:.1f}", 100.0 * share);
}

Report claims_table(const std::vector<PlaceRun>& runs) {
  Report table(fmt::format("{} asked, no truth",
                           counted(runs.empty() ? 0 : runs[0].questions.size(), "image")),
               {"method", "claimed", "ms"});
  for (const PlaceRun& run : runs) {
    table.add_row(
        {run.name,
         run.threshold ? std::to_string(at_threshold(run.questions, *run.threshold).claimed) : "-",
         fmt::format("{:.1f}", run.ms)});
  }
  return table;
}

Report scores_table(const std::vector<PlaceRun>& runs) {
  const std::size_t asked = runs.empty() ? 0 : runs[0].questions.size();
  const int revisits = runs.empty() ? 0 : without_false(runs[0].questions).revisits;
  Report table(
      fmt::format("{} asked, {}", counted(asked, "image"),
                  counted(static_cast<std::size_t>(revisits), "revisit")),
      {"method", "found without a false one", "recall %", "claimed", "right", "false", "ms"});
  for (const PlaceRun& run : runs) {
    const PlaceScore sure = without_false(run.questions);
    std::vector<std::string> row = {run.name, std::to_string(sure.right),
                                    revisits > 0 ? percent_of(sure.recall()) : "-"};
    if (run.threshold) {
      const PlaceScore own = at_threshold(run.questions, *run.threshold);
      for (const int number : {own.claimed, own.right, own.claimed - own.right}) {
        row.push_back(std::to_string(number));
      }
    } else {
      row.insert(row.end(), 3, "-");
    }
    row.push_back(fmt::format("{:.1f}", run.ms));
    table.add_row(std::move(row));
  }
  return table;
}

nlohmann::ordered_json score_json(const PlaceScore& score) {
  return {{"threshold", score.threshold},
          {"claimed", score.claimed},
          {"right", score.right},
          {"recall", score.revisits > 0 ? nlohmann::ordered_json(score.recall())
                                        : nlohmann::ordered_json(nullptr)}};
}

nlohmann::ordered_json question_json(const PlaceQuestion& one,
                                     const std::vector<PlacedImage>& images, bool judged) {
  nlohmann::ordered_json json = {{"image", images[one.image].name}, {"place", nullptr}};
  if (one.guess.image >= 0) {
    json["place"] = images[static_cast<std::size_t>(one.guess.image)].name;
    json["score"] = one.guess.score;
  }
  if (judged) json["revisit"] = one.revisit, json["right"] = one.right;
  return json;
}

Report guesses_table(const std::vector<PlaceRun>& runs, const std::vector<PlacedImage>& images,
                     bool judged) {
  std::vector<std::string> columns = {"method", "image", "place", "score"};
  if (judged) columns.insert(columns.end(), {"revisit", "right"});
  Report table("", columns);
  for (const PlaceRun& run : runs) {
    for (const PlaceQuestion& one : run.questions) {
      const bool any = one.guess.image >= 0;
      std::vector<std::string> row = {
          run.name, images[one.image].name,
          any ? images[static_cast<std::size_t>(one.guess.image)].name : "",
          any ? fmt::format("{:g}", one.guess.score) : ""};
      if (judged) row.push_back(one.revisit ? "1" : "0"), row.push_back(one.right ? "1" : "0");
      table.add_row(std::move(row));
    }
  }
  return table;
}

void write_curves(const std::vector<PlaceRun>& runs, const std::string& out) {
  Report curves("", {"method", "threshold", "claimed", "right", "recall %", "precision %"});
  Plot plot{"Places known again", "recall %", "precision %", {}};
  for (const PlaceRun& run : runs) {
    PlotCurve line{run.name, {}, {}};
    for (const PlaceScore& score : sweep_places(run.questions)) {
      curves.add_row({run.name, fmt::format("{:g}", score.threshold), std::to_string(score.claimed),
                      std::to_string(score.right), percent_of(score.recall()),
                      percent_of(score.precision())});
      line.x.push_back(100.0 * score.recall());
      line.y.push_back(100.0 * score.precision());
    }
    if (!line.x.empty()) plot.curves.push_back(std::move(line));
  }
  write_file(out + "/places_curves.csv", curves.csv());
  if (!plot.curves.empty()) write_file(out + "/places.svg", plot.svg());
}

}  // namespace

std::string places_text(const std::vector<PlaceRun>& runs, bool judged) {
  return judged ? scores_table(runs).text() : claims_table(runs).text();
}

std::string places_json(const std::vector<PlaceRun>& runs, const std::vector<PlacedImage>& images,
                        bool judged) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const PlaceRun& run : runs) {
    nlohmann::ordered_json one = {{"method", run.name},       {"asked", run.questions.size()},
                                  {"revisits", nullptr},      {"without_false", nullptr},
                                  {"own_threshold", nullptr}, {"ms", run.ms}};
    if (judged) {
      const PlaceScore sure = without_false(run.questions);
      one["revisits"] = sure.revisits;
      one["without_false"] = score_json(sure);
      if (sure.claimed == 0) one["without_false"]["threshold"] = nullptr;  // there is none
    }
    if (run.threshold) {
      one["own_threshold"] = score_json(at_threshold(run.questions, *run.threshold));
      if (!judged) one["own_threshold"]["right"] = nullptr;
    }
    one["guesses"] = nlohmann::ordered_json::array();
    for (const PlaceQuestion& question : run.questions) {
      one["guesses"].push_back(question_json(question, images, judged));
    }
    json.push_back(std::move(one));
  }
  return json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

void write_places(const std::vector<PlaceRun>& runs, const std::vector<PlacedImage>& images,
                  bool judged, const std::string& out) {
  write_file(out + "/places.csv", (judged ? scores_table(runs) : claims_table(runs)).csv());
  write_file(out + "/places_guesses.csv", guesses_table(runs, images, judged).csv());
  if (judged) write_curves(runs, out);
}

}  // namespace striate::evaluation
