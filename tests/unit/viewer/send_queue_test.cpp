#include "striate/viewer/foxglove/send_queue.hpp"

#include <gtest/gtest.h>

namespace striate::viewer::foxglove {
namespace {

Frame some_frame(Frame::Kind kind, std::int64_t key, std::size_t size, std::uint8_t byte) {
  return {kind, false, key, std::nullopt, std::make_shared<const Bytes>(size, byte)};
}

TEST(SendQueue, LeavesOutTheOldestAndKeepsAnswersAndTheNewestOfSlowThings) {
  SendQueue queue;
  const std::size_t big = SendQueue::kMostBytes / 4;
  ASSERT_TRUE(queue.push(some_frame(Frame::Kind::answer, 0, 10, 1)));
  for (int k = 0; k < 5; ++k) queue.push(some_frame(Frame::Kind::newest, 7, 10, 2));
  for (std::uint8_t k = 10; k < 30; ++k) queue.push(some_frame(Frame::Kind::replaced, 8, big, k));
  EXPECT_LE(queue.bytes(), SendQueue::kMostBytes);
  EXPECT_EQ(queue.pop().body->front(), 1);
  EXPECT_EQ(queue.pop().body->front(), 2);
  EXPECT_EQ(queue.pop().body->front(), 27);
  EXPECT_EQ(queue.left_out(), 4U + 17U);
  queue.forget(8);
  EXPECT_TRUE(queue.empty());
  EXPECT_EQ(queue.bytes(), 0U);
}

TEST(SendQueue, TakesOneFrameHoweverLargeAndNoEndlessAnswers) {
  SendQueue queue;
  EXPECT_TRUE(queue.push(some_frame(Frame::Kind::replaced, 1, 2 * SendQueue::kMostBytes, 1)));
  EXPECT_FALSE(queue.empty());
  bool taken = true;
  for (std::size_t k = 0; k <= SendQueue::kMostAnswers; ++k) {
    taken = queue.push(some_frame(Frame::Kind::answer, 0, 1, 1));
  }
  EXPECT_FALSE(taken);
}

}  // namespace
}  // namespace striate::viewer::foxglove
