#include "striate/viewer/foxglove/send_queue.hpp"

#include <algorithm>

namespace striate::viewer::foxglove {

void SendQueue::erase(std::deque<Frame>::iterator frame) {
  bytes_ -= frame->size();
  if (frame->kind == Frame::Kind::answer) --answers_;
  frames_.erase(frame);
}

bool SendQueue::push(Frame frame) {
  if (frame.kind == Frame::Kind::answer && ++answers_ > kMostAnswers) return false;
  if (frame.kind == Frame::Kind::newest) {
    const auto older = std::find_if(frames_.begin(), frames_.end(), [&](const Frame& one) {
      return one.kind == Frame::Kind::newest && one.key == frame.key;
    });
    if (older != frames_.end()) {
      ++left_out_;
      erase(older);
    }
  }
  bytes_ += frame.size();
  frames_.push_back(std::move(frame));
  while (bytes_ > kMostBytes) {
    // The last one stays: however large, it is the newest.
    const auto last = std::prev(frames_.end());
    const auto oldest = std::find_if(
        frames_.begin(), last, [](const Frame& one) { return one.kind == Frame::Kind::replaced; });
    if (oldest == last) break;
    ++left_out_;
    erase(oldest);
  }
  return true;
}

Frame SendQueue::pop() {
  Frame frame = std::move(frames_.front());
  bytes_ -= frame.size();
  if (frame.kind == Frame::Kind::answer) --answers_;
  frames_.pop_front();
  return frame;
}

void SendQueue::forget(std::int64_t key) {
  for (auto frame = frames_.begin(); frame != frames_.end();) {
    if (frame->kind != Frame::Kind::answer && frame->key == key) {
      bytes_ -= frame->size();
      frame = frames_.erase(frame);
    } else {
      ++frame;
    }
  }
}

}  // namespace striate::viewer::foxglove
