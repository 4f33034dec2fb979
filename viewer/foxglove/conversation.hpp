#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "striate/base/time.hpp"
#include "striate/viewer/channels/channel_list.hpp"
#include "striate/viewer/dashboard/site.hpp"
#include "striate/viewer/foxglove/protocol.hpp"
#include "striate/viewer/foxglove/remote_pilot.hpp"
#include "striate/viewer/foxglove/send_queue.hpp"

namespace striate::viewer::foxglove {

/// A message as it goes to all who want it.
struct Published {
  std::uint64_t time_ns = 0;
  std::shared_ptr<const Bytes> payload;
};

/// What all conversations with one server share. Used by the server's thread alone, but for the
/// pilot.
struct Host {
  ServerFacts facts;
  /// The newest message of each channel that changes slowly: who comes late gets it at once.
  std::array<Published, kTopics> newest;
  /// The last lines of the log, for who comes late.
  std::deque<Published> log;
  static constexpr std::size_t kMostLog = 200;  ///< by hand: a few minutes of decisions
  RemotePilot* pilot = nullptr;
  std::function<void()> stop;  ///< asks the mission for a safe end
  /// What browsers are shown at the same address; nullptr: nothing.
  std::shared_ptr<dashboard::Site> site;
};

/// The channels of which the newest message is kept for who comes late.
[[nodiscard]] const TopicSet& slow_topics();

/// What is said to one client, and heard from it, once it is let in. Knows no sockets.
class Conversation {
 public:
  /// @param id no other client's. The host must live as long.
  Conversation(Host& host, std::uint64_t id) : host_(host), id_(id) {}
  ~Conversation();
  Conversation(const Conversation&) = delete;
  Conversation& operator=(const Conversation&) = delete;

  /// What every client is told first.
  void greet();
  /// @param sent_after when what is heard was surely not sent yet, on the machine's clock; none:
  /// that is not known. What is wrong with a request is told to the client as a status.
  void hear_text(std::string_view text);
  void hear_binary(ByteView bytes, std::optional<TimePoint> sent_after);
  /// To all who have subscribed to it.
  void tell(Topic topic, const Published& message);
  void tell_time(const std::shared_ptr<const Bytes>& message);

  [[nodiscard]] const TopicSet& wants() const { return wants_; }
  /// It has announced to publish on /cmd_vel: how old its commands are must be known.
  [[nodiscard]] bool drives() const { return drives_; }
  [[nodiscard]] SendQueue& queue() { return queue_; }
  /// It asks on and never reads: nothing more is said to it.
  [[nodiscard]] bool hopeless() const { return hopeless_; }

 private:
  void answer(std::string text);
  void answer(Bytes bytes);
  void push(Frame frame) { hopeless_ = !queue_.push(std::move(frame)) || hopeless_; }
  void complain(StatusLevel level, const std::string& what);
  void hear(const Subscribe& request);
  void hear(const Unsubscribe& request);
  void hear(const ClientAdvertise& request);
  void hear(const ClientUnadvertise& request);
  void hear(const ClientMessage& message);
  void hear(const ServiceCall& call);
  void hear(const GetParameters& request);
  void hear(const SetParameters& request);
  void hear(const NotOffered& request);
  void advertise(const ClientChannel& channel);
  std::string serve(Service service);

  Host& host_;
  std::uint64_t id_;
  SendQueue queue_;
  std::map<std::uint32_t, Topic> subscriptions_;
  std::array<std::optional<std::uint32_t>, kTopics> subscription_of_;
  TopicSet wants_;
  std::map<std::uint32_t, ClientChannel> channels_;
  std::optional<TimePoint> sent_after_;  ///< of the message in hand
  bool drives_ = false;
  bool hopeless_ = false;
};

}  // namespace striate::viewer::foxglove
