#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "striate/base/user_error.hpp"
#include "striate/viewer/dashboard/shown_run.hpp"
#include "striate/viewer/foxglove/protocol.hpp"

namespace striate::viewer::dashboard {
namespace {

/// @throws UserError where the query has no such number
std::size_t number_in_query(const HttpRequest& request, const char* name) {
  const std::string text = query_value(request.query, name);
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) {
    throw UserError(fmt::format("'{}' is no number for '{}'", text, name));
  }
  return value;
}

/// "topics=/odom,/striate/cycle"
TopicSet topics_in_query(const HttpRequest& request) {
  const std::string names = "," + query_value(request.query, "topics") + ",";
  TopicSet topics;
  for (const ChannelInfo& channel : channel_list()) {
    if (names.find("," + channel.name + ",") != std::string::npos) {
      topics.set(static_cast<std::size_t>(channel.topic));
    }
  }
  return topics;
}

const ShownRun& run_in_query(const ShownRuns& runs, const HttpRequest& request) {
  const std::size_t number = number_in_query(request, "run");
  if (number >= runs.size()) throw UserError(fmt::format("there is no run {}", number));
  return *runs[number];
}

nlohmann::ordered_json difference_json(const ShownRuns& runs) {
  if (runs.size() < 2) throw UserError("there is no second run to compare with");
  const RunStore& one = runs[0]->store();
  const RunStore& other = runs[1]->store();
  // What was wanted and sent, and what came of it.
  const std::size_t decided = RunStore::first_difference(one, other, Topic::wish);
  const std::size_t moved = RunStore::first_difference(one, other, Topic::odom);
  const std::size_t compared = std::min(one.cycles(), other.cycles());
  return {{"compared", compared},
          {"decided", decided < compared ? nlohmann::ordered_json(decided) : nullptr},
          {"moved", moved < compared ? nlohmann::ordered_json(moved) : nullptr}};
}

}  // namespace

void add_recording_pages(Site& site, const ShownRuns& runs) {
  constexpr const char* kBytes = "application/octet-stream";
  site.on_get("/api/recording", [runs](const HttpRequest&) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const auto& run : runs) list.push_back(run->about());
    return json_answer({{"runs", list}});
  });
  site.on_get("/api/recording/channels", [](const HttpRequest&) {
    return HttpAnswer{200, "application/json", foxglove::advertise_channels()};
  });
  site.on_get("/api/recording/cycle", [runs](const HttpRequest& request) {
    return HttpAnswer{200, kBytes,
                      run_in_query(runs, request)
                          .store()
                          .newest(number_in_query(request, "n"), topics_in_query(request))};
  });
  site.on_get("/api/recording/span", [runs](const HttpRequest& request) {
    return HttpAnswer{200, kBytes,
                      run_in_query(runs, request)
                          .store()
                          .span(number_in_query(request, "from"), number_in_query(request, "to"),
                                topics_in_query(request))};
  });
  site.on_get("/api/recording/difference",
              [runs](const HttpRequest&) { return json_answer(difference_json(runs)); });
}

}  // namespace striate::viewer::dashboard
