#include <fmt/format.h>

#include "striate/viewer/foxglove/conversation.hpp"

namespace striate::viewer::foxglove {
namespace {

/// Of a client at once; by hand: a viewer announces one for each panel that publishes.
constexpr std::size_t kMostClientChannels = 64;

}  // namespace

void Conversation::hear(const Subscribe& request) {
  for (const auto& [id, channel] : request.subscriptions) {
    if (channel >= kTopics) {
      complain(StatusLevel::error, fmt::format("there is no channel {}", channel));
      continue;
    }
    if (subscription_of_[channel] || subscriptions_.count(id) > 0) {
      complain(StatusLevel::warning,
               fmt::format("subscription {} of channel {}: one of both is in use", id, channel));
      continue;
    }
    subscriptions_[id] = static_cast<Topic>(channel);
    subscription_of_[channel] = id;
    wants_.set(channel);
    for (const Published& line : host_.log) {
      if (static_cast<Topic>(channel) == Topic::log) tell(Topic::log, line);
    }
    const Published& newest = host_.newest[channel];
    if (newest.payload) tell(static_cast<Topic>(channel), newest);
  }
}

void Conversation::hear(const Unsubscribe& request) {
  for (const std::uint32_t id : request.subscriptions) {
    const auto found = subscriptions_.find(id);
    if (found == subscriptions_.end()) {
      complain(StatusLevel::warning, fmt::format("there is no subscription {}", id));
      continue;
    }
    const auto channel = static_cast<std::size_t>(found->second);
    subscription_of_[channel].reset();
    wants_.reset(channel);
    queue_.forget(id);
    subscriptions_.erase(found);
  }
}

void Conversation::advertise(const ClientChannel& channel) {
  if (!host_.facts.drives) {
    return complain(StatusLevel::error, "this robot takes no messages: --foxglove-drive lets it");
  }
  if (channel.topic != "/cmd_vel" || !is_twist(channel)) {
    return complain(StatusLevel::error,
                    fmt::format("'{}' of type '{}' in '{}' is not taken; /cmd_vel is, as "
                                "geometry_msgs/msg/Twist or TwistStamped in cdr or json",
                                channel.topic, channel.schema_name, channel.encoding));
  }
  if (channels_.size() >= kMostClientChannels) {
    return complain(StatusLevel::error, "there are too many channels");
  }
  if (!channels_.try_emplace(channel.id, channel).second) {
    return complain(StatusLevel::error, fmt::format("channel {} is there already", channel.id));
  }
  drives_ = true;
}

void Conversation::hear(const ClientAdvertise& request) {
  for (const ClientChannel& channel : request.channels) advertise(channel);
}

void Conversation::hear(const ClientUnadvertise& request) {
  for (const std::uint32_t id : request.channels) channels_.erase(id);
  if (drives_ && channels_.empty()) {
    host_.pilot->leave(id_);
    drives_ = false;
  }
}

void Conversation::hear(const ClientMessage& message) {
  const auto channel = channels_.find(message.channel);
  if (channel == channels_.end()) {
    return complain(StatusLevel::error, fmt::format("channel {} is unknown", message.channel));
  }
  const WantedMotion motion = read_twist(channel->second, message.payload);
  // That young commands come is known after the first answer to a ping; nobody is told of it.
  if (!sent_after_) return;
  switch (host_.pilot->command(id_, motion, *sent_after_)) {
    case RemotePilot::Taken::taken:
      return;
    case RemotePilot::Taken::too_old:
      return complain(StatusLevel::warning, "the command was too old and does not drive");
    case RemotePilot::Taken::another_drives:
      return complain(StatusLevel::warning, "another viewer drives");
    case RemotePilot::Taken::paused:
      return complain(StatusLevel::warning, "the robot is paused");
  }
}

std::string Conversation::serve(Service service) {
  switch (service) {
    case Service::pause:
      host_.pilot->pause();
      return "the robot stands; the task's clock goes on";
    case Service::resume:
      host_.pilot->resume();
      return "the task goes on";
    case Service::stop:
      host_.stop();
      return "the mission ends: its 'finally', then it stands";
  }
  throw BadBytes("there is no such service");
}

void Conversation::hear(const ServiceCall& call) {
  const bool known = call.encoding == "cdr" || call.encoding == "json";
  try {
    if (!known) throw BadBytes("services are called in cdr or json");
    answer(service_response(call, true, serve(static_cast<Service>(call.service))));
  } catch (const BadBytes& error) {
    answer(service_failure(call.service, call.call, error.what()));
  }
}

void Conversation::hear(const GetParameters& request) {
  answer(parameter_values(host_.facts, request.names, request.request));
}

void Conversation::hear(const SetParameters& request) {
  complain(StatusLevel::error, "settings cannot be changed while the robot runs");
  if (request.request) answer(parameter_values(host_.facts, {}, request.request));
}

void Conversation::hear(const NotOffered& request) {
  complain(StatusLevel::warning, fmt::format("'{}' is not offered", request.what));
}

}  // namespace striate::viewer::foxglove
