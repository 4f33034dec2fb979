#include "striate/viewer/foxglove/conversation.hpp"

namespace striate::viewer::foxglove {
namespace {

/// Of frames that tell the time; subscriptions are not negative.
constexpr std::int64_t kTimeKey = -1;

std::shared_ptr<const Bytes> shared_bytes(std::string_view text) {
  return std::make_shared<const Bytes>(text.begin(), text.end());
}

}  // namespace

const TopicSet& slow_topics() {
  static const TopicSet kSlow = [] {
    TopicSet topics;
    for (const Topic topic :
         {Topic::left_info, Topic::right_info, Topic::map_local, Topic::map_global,
          Topic::trajectory, Topic::landmarks, Topic::route, Topic::battery, Topic::diagnostics,
          Topic::task, Topic::task_nodes, Topic::short_term}) {
      topics.set(static_cast<std::size_t>(topic));
    }
    return topics;
  }();
  return kSlow;
}

Conversation::~Conversation() {
  if (drives_) host_.pilot->leave(id_);
}

void Conversation::greet() {
  answer(server_info(host_.facts));
  answer(advertise_channels());
  answer(advertise_services());
}

void Conversation::answer(std::string text) {
  push({Frame::Kind::answer, true, 0, std::nullopt, shared_bytes(text)});
}

void Conversation::answer(Bytes bytes) {
  push({Frame::Kind::answer, false, 0, std::nullopt, std::make_shared<const Bytes>(bytes)});
}

void Conversation::complain(StatusLevel level, const std::string& what) {
  answer(status(level, what));
}

void Conversation::hear_text(std::string_view text) {
  try {
    std::visit([this](const auto& request) { hear(request); }, read_text_request(text));
  } catch (const BadBytes& error) {
    complain(StatusLevel::error, error.what());
  }
}

void Conversation::hear_binary(ByteView bytes, std::optional<TimePoint> sent_after) {
  sent_after_ = sent_after;
  try {
    std::visit([this](const auto& request) { hear(request); }, read_binary_request(bytes));
  } catch (const BadBytes& error) {
    complain(StatusLevel::error, error.what());
  }
}

void Conversation::tell(Topic topic, const Published& message) {
  const auto& subscription = subscription_of_[static_cast<std::size_t>(topic)];
  if (!subscription) return;
  const bool slow = slow_topics()[static_cast<std::size_t>(topic)];
  push({slow ? Frame::Kind::newest : Frame::Kind::replaced, false, *subscription,
        message_head(*subscription, message.time_ns), message.payload});
}

void Conversation::tell_time(const std::shared_ptr<const Bytes>& message) {
  push({Frame::Kind::newest, false, kTimeKey, std::nullopt, message});
}

}  // namespace striate::viewer::foxglove
