#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "striate/base/time.hpp"
#include "striate/platform/rosbridge/bridge_address.hpp"

namespace striate::rosbridge {

/// A client of a rosbridge server in a thread of its own: connects, and connects again when the
/// line breaks, waiting longer each time, up to 2 s. It asks ten times a second whether the server
/// still answers, by WebSocket's own pings.
class BridgeClient {
 public:
  /// What the client's thread calls; nothing of it may wait.
  struct Hears {
    /// What is to be said first on a new line.
    std::function<std::vector<std::string>()> greetings;
    std::function<void(std::string_view message)> message;
    /// A line that was open is no more.
    std::function<void()> broke;
    /// Each 50 ms, whether the line is open or not.
    std::function<void()> tick;
  };

  /// Looks the host up and begins to connect.
  /// @param most_message_bytes a line on which a larger message comes is closed
  /// @throws std::runtime_error where the host is not known
  BridgeClient(const BridgeAddress& address, std::size_t most_message_bytes, Hears hears);
  /// Without a good-bye: see end().
  ~BridgeClient();

  /// Sends after what was said before. Where the line is not open it is forgotten.
  void say(std::string message);
  /// The same for what only the newest of is wanted: replaces one that still waits.
  void say_newest(std::string message);
  /// Says these, closes the line and ends the thread; waits for it, 0.5 s at most. `hears` is not
  /// called any more afterwards.
  void end(std::vector<std::string> last_words) noexcept;

  [[nodiscard]] bool is_open() const;
  /// Since the server last answered; since the client was made where it never did.
  [[nodiscard]] Duration silent_for() const;
  /// Why the line is not open, or broke last, in plain words; "": nothing was ever wrong.
  [[nodiscard]] std::string trouble() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace striate::rosbridge
