#include "striate/app/commands/foxglove_options.hpp"

#include <charconv>

namespace striate::app {
namespace {

/// What CLI11 gives for an option without its value.
bool is_left_out(const std::string& port) {
  return port.empty() || port == "true" || port == "{}";
}

/// "" for a good one. The greatest port is 65535.
std::string why_no_port(const std::string& text) {
  if (is_left_out(text)) return {};
  std::uint16_t port = 0;
  const char* end = text.data() + text.size();
  const auto [read, error] = std::from_chars(text.data(), end, port);
  if (error == std::errc() && read == end) return {};
  return "'" + text +
         "' is no port from 0 to 65535; put this option behind the other words, or give it a port";
}

}  // namespace

viewer::foxglove::ServerOptions FoxgloveOptions::for_server() const {
  viewer::foxglove::ServerOptions options = server;
  options.others = wants_foxglove();
  if (wants_view()) options.site = std::make_shared<viewer::dashboard::Site>();
  if (wants_view() && !wants_foxglove()) options.port = kViewPort;
  for (const std::string& given : {port, view_port}) {
    if (!is_left_out(given)) {
      std::from_chars(given.data(), given.data() + given.size(), options.port);
    }
  }
  return options;
}

std::string FoxgloveOptions::addresses(const std::string& url, const std::string& page_url) const {
  std::string lines;
  if (wants_view()) lines += "Dashboard: " + page_url + "\n";
  if (wants_foxglove()) lines += "Foxglove, Lichtblick: " + url + "\n";
  return lines;
}

void add_foxglove_options(CLI::App& command, FoxgloveOptions& options, bool may_drive) {
  options.asked =
      command
          .add_option("--foxglove", options.port,
                      "shows the robot to Foxglove and Lichtblick on this port, 8765 where none is "
                      "given; 0: any, and the address is printed")
          ->expected(0, 1)
          ->type_name("[PORT]")
          ->check(CLI::Validator(why_no_port, ""));
  options.asked_view =
      command
          .add_option("--view", options.view_port,
                      "shows the robot as a page in a browser, on this port, 8780 where none is "
                      "given; 0: any, and the address is printed")
          ->expected(0, 1)
          ->type_name("[PORT]")
          ->check(CLI::Validator(why_no_port, ""));
  if (may_drive) {
    command
        .add_flag("--view-drive", options.server.drives,
                  "lets the page drive by keys: before the task, behind the safety limiter")
        ->needs(options.asked_view);
    command
        .add_flag(
            "--foxglove-drive", options.server.drives,
            "lets those viewers drive by /cmd_vel: before the task, behind the safety limiter")
        ->needs(options.asked);
  }
  command
      .add_option("--listen", options.server.address,
                  "address for viewers on other machines, 0.0.0.0 for all; a token is needed then, "
                  "and printed")
      ->type_name("ADDRESS");
  command
      .add_option("--allow-origin", options.server.more_origins,
                  "a web page that may look, as https://app.foxglove.dev")
      ->type_name("ORIGIN")
      ->allow_extra_args(false)
      ->take_all();
  command.parse_complete_callback([&command, &options] {
    for (const char* name : {"--listen", "--allow-origin", "--speed"}) {
      const CLI::Option* option = command.get_option_no_throw(name);
      if (option != nullptr && option->count() > 0 && !options.wanted()) {
        throw CLI::RequiresError(name, "--foxglove or --view");
      }
    }
  });
}

}  // namespace striate::app
