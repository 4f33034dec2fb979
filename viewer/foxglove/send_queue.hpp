#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>

#include "striate/base/bytes.hpp"
#include "striate/viewer/foxglove/protocol.hpp"

namespace striate::viewer::foxglove {

/// What goes to one client as one message.
struct Frame {
  enum class Kind : std::uint8_t {
    answer,    ///< to what the client has asked: never left out
    newest,    ///< only the newest one of its key is of use
    replaced,  ///< one of many, of which the oldest are left out first
  };
  Kind kind = Kind::answer;
  bool text = false;
  std::int64_t key = 0;             ///< subscription, or another number below zero
  std::optional<MessageHead> head;  ///< before the body
  std::shared_ptr<const Bytes> body;

  [[nodiscard]] std::size_t size() const { return body->size() + sizeof(Frame); }
};

/// Frames that wait for one client. A client that is too slow misses the oldest frames, and keeps
/// the newest of each thing that changes slowly.
class SendQueue {
 public:
  /// By hand: three cycles of all channels with images of 640 x 480, some 2.5 MB each
  static constexpr std::size_t kMostBytes = std::size_t{8} << 20U;
  /// By hand: more than any viewer asks for at once (26 channels, 3 services)
  static constexpr std::size_t kMostAnswers = 256;

  /// @return false where more answers wait than any honest client leaves unread
  bool push(Frame frame);
  [[nodiscard]] bool empty() const { return frames_.empty(); }
  /// The oldest; not of an empty queue.
  Frame pop();
  /// Frees what waits for a subscription that has ended.
  void forget(std::int64_t key);
  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  [[nodiscard]] std::uint64_t left_out() const { return left_out_; }

 private:
  void erase(std::deque<Frame>::iterator frame);

  std::deque<Frame> frames_;
  std::size_t bytes_ = 0;
  std::size_t answers_ = 0;
  std::uint64_t left_out_ = 0;
};

}  // namespace striate::viewer::foxglove
