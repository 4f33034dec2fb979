#include <fmt/format.h>

#include <memory>

#include "striate/app/command_line/whole_number.hpp"
#include "striate/app/commands/commands.hpp"
#include "striate/base/files.hpp"
#include "striate/evaluation/learning/learn_descriptor.hpp"

namespace striate::app {

void add_learn_descriptor_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<evaluation::LearnOptions>();
  CLI::App* command = app.add_subcommand(
      "learn-descriptor",
      "Learns which V1 responses Striate's 256-bit descriptor compares, from made images,\n"
      "and writes the table. Building the program anew takes it in:\n"
      "          striate learn-descriptor --picture-count 60 --out "
      "perception/descriptor/striate_256.inc");
  command->add_option("--picture-count", options->pictures, "how many images are made")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  command->add_option("--seed", options->seed, "the same seed, the same table")
      ->check(whole_number_from(0))
      ->capture_default_str();
  command->add_option("--out", options->out, "the file to write")->capture_default_str();
  command->callback([options, &exit_code] {
    check_writable(options->out);
    write_file(options->out, evaluation::learn_descriptor(*options));
    fmt::print("{}: 256 bits\n", options->out);
    exit_code = 0;
  });
}

}  // namespace striate::app
