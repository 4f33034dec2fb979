#include "striate/viewer/dashboard/shown_run.hpp"

#include <fmt/format.h>

#include <exception>
#include <map>

#include "striate/agent/replay/replay_mission.hpp"
#include "striate/base/user_error.hpp"
#include "striate/platform/replay/recording_reader.hpp"
#include "striate/viewer/channels/channels.hpp"
#include "striate/viewer/mcap/mcap_reader.hpp"

namespace striate::viewer::dashboard {

/// From where the messages come, a cycle after the other.
class ShownRun::Source {
 public:
  virtual ~Source() = default;
  /// One more cycle into the store; false at the end.
  virtual bool next(RunStore& store) = 0;
  /// Of the run as a whole, as far as it is known by now.
  [[nodiscard]] virtual nlohmann::ordered_json facts() const = 0;
};

/// What it felt is thought through once more; what it saw and remembered is not in the file.
class ShownRun::Recorded final : public Source {
 public:
  explicit Recorded(const std::string& file)
      : mission_({file, "", ""}), channels_(mission_.robot(), mission_.executive().task()) {}

  bool next(RunStore& store) override {
    if (!mission_.step()) return false;
    taker_.take(mission_.cycle(), mission_.executive(), mission_.recorded().number, taken_);
    channels_.publish(taken_, [&](Topic topic, std::uint64_t time_ns, ByteView message) {
      store.put(topic, time_ns, message);
    });
    store.end_cycle();
    if (differs_in_ == 0 && !mission_.differences().empty()) {
      differs_in_ = mission_.recorded().number;
    }
    return true;
  }
  [[nodiscard]] nlohmann::ordered_json facts() const override {
    const replay::RecordedSetup& setup = mission_.setup();
    return {{"task", setup.task},
            {"world", setup.world},
            {"seed", setup.seed},
            {"software", setup.software},
            {"form", "recording"},
            {"differs_in_cycle", differs_in_},
            {"whole", mission_.ending() == replay::Ending::closed}};
  }

 private:
  agent::ReplayMission mission_;
  Channels channels_;
  FactsTaker taker_;
  CycleFacts taken_;
  std::uint64_t differs_in_ = 0;  ///< where today's program decides otherwise; 0: nowhere
};

class ShownRun::McapSource final : public Source {
 public:
  explicit McapSource(const std::string& file) : reader_(file) {
    for (const ChannelInfo& channel : channel_list()) topics_[channel.name] = channel.topic;
  }

  bool next(RunStore& store) override {
    mcap::Message message;
    while (reader_.next(message)) {
      const auto found = topics_.find(reader_.channel_of(message).topic);
      if (found == topics_.end()) continue;
      store.put(found->second, message.log_time_ns, message.data);
      if (found->second != Topic::cycle) continue;  // the last message of each cycle
      any_ = true;
      store.end_cycle();
      return true;
    }
    if (!any_) {
      throw UserError(
          fmt::format("{}: holds no channel /striate/cycle, so it is no run of Striate's\n"
                      "    Foxglove and Lichtblick show files of others",
                      reader_.name()));
    }
    return false;
  }
  [[nodiscard]] nlohmann::ordered_json facts() const override {
    nlohmann::ordered_json json = {{"form", "MCAP"},
                                   {"software", reader_.library()},
                                   {"differs_in_cycle", 0},
                                   {"whole", reader_.ending() != mcap::Ending::cut_off}};
    const auto found = reader_.metadata().find("striate");
    if (found == reader_.metadata().end()) return json;
    for (const char* key : {"task", "world", "seed"}) {
      const auto value = found->second.find(key);
      json[key] = value == found->second.end() ? "" : value->second;
    }
    return json;
  }

 private:
  mcap::Reader reader_;
  std::map<std::string, Topic> topics_;
  bool any_ = false;
};

ShownRun::ShownRun(const std::string& file) : name_(file) {
  if (mcap::is_mcap(file)) {
    source_ = std::make_unique<McapSource>(file);
  } else {
    source_ = std::make_unique<Recorded>(file);
  }
  facts_ = source_->facts();
  thread_ = std::thread([this] { work(); });
}

ShownRun::~ShownRun() {
  ending_ = true;
  thread_.join();
}

void ShownRun::work() {
  std::string error;
  try {
    while (!ending_ && source_->next(store_)) {
    }
  } catch (const std::exception& thrown) {  // what stood before the damage can be looked at
    error = thrown.what();
  }
  const std::lock_guard lock(mutex_);
  facts_ = source_->facts();
  error_ = error;
  done_ = true;
}

nlohmann::ordered_json ShownRun::about() const {
  const std::lock_guard lock(mutex_);
  nlohmann::ordered_json json = facts_;
  json["name"] = name_;
  json["cycles"] = store_.cycles();
  json["done"] = done_;
  json["error"] = error_;
  return json;
}

}  // namespace striate::viewer::dashboard
