#include <memory>

#include "app/commands/commands.hpp"
#include "app/evaluation/evaluation.hpp"

namespace striate {
namespace {

struct Kind {
  const char* name;
  const char* help;  ///< what is measured, and the layout of the folder
  int (*evaluate)(const EvalOptions&);
};

/// What can be measured; each has its own file in app/evaluation/.
constexpr Kind kKinds[] = {
    {"saliency",
     "Saliency against eye fixations: AUC-Judd, NSS, CC.\n"
     "FOLDER/fixations.csv: image,subject,order,x,y,duration_ms; pictures beside it or in stimuli/",
     evaluate_saliency},
};

}  // namespace

void add_eval_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand(
      "eval",
      "Measures the vision on your own data, beside OpenCV's methods in the same run;\n"
      "prints a table and writes it as CSV and as a plot (SVG).");
  command->require_subcommand(1);
  for (const Kind& kind : kKinds) {
    if (kind.name == nullptr) continue;
    auto options = std::make_shared<EvalOptions>();
    options->out = std::string("out/eval_") + kind.name;
    CLI::App* one = command->add_subcommand(kind.name, kind.help);
    one->add_option("folder", options->folder, "the data")->required();
    one->add_option("--out", options->out, "folder for the CSV file and the plot")
        ->capture_default_str();
    one->callback(
        [options, &exit_code, evaluate = kind.evaluate] { exit_code = evaluate(*options); });
  }
}

}  // namespace striate
