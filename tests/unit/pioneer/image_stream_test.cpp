#include "striate/platform/pioneer/camera/image_stream.hpp"

#include <gtest/gtest.h>

namespace striate::pioneer::image_stream {
namespace {

StereoFrame pair_of(int width_px, int height_px, int value) {
  StereoFrame frame;
  frame.stamp = TimePoint(from_seconds(12.5));
  frame.left.create(height_px, width_px);
  frame.right.create(height_px, width_px);
  for (int v = 0; v < height_px; ++v) {
    for (int u = 0; u < width_px; ++u) {
      frame.left(v, u) = cv::Vec3b(static_cast<uchar>(value + u), static_cast<uchar>(v), 'S');
      frame.right(v, u) =
          cv::Vec3b('S', static_cast<uchar>(value - u), static_cast<uchar>('T' + v));
    }
  }
  frame.focal_px = 403.125;
  frame.centre_u_px = 159.5;
  frame.centre_v_px = 119.5;
  frame.baseline_m = 0.12;
  return frame;
}

bool same(const cv::Mat3b& a, const cv::Mat3b& b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin());
}

TEST(ImageStream, GivesThePairsThatWereSentInAnySplit) {
  Bytes stream;
  for (int i = 0; i < 3; ++i) {
    Bytes packet = encode(pair_of(12 + i, 5, 10 * i), static_cast<std::uint32_t>(i));
    set_age(packet, std::chrono::milliseconds(80 + i));
    append(stream, packet);
  }
  for (const std::size_t chunk : {std::size_t{1}, std::size_t{7}, stream.size()}) {
    Reader reader;
    std::uint32_t number = 0;
    for (std::size_t at = 0; at < stream.size(); at += chunk) {
      reader.push(ByteView(stream).subspan(at, std::min(chunk, stream.size() - at)));
      while (const auto image = reader.next()) {
        const StereoFrame sent =
            pair_of(12 + static_cast<int>(number), 5, 10 * static_cast<int>(number));
        EXPECT_EQ(image->number, number);
        EXPECT_TRUE(same(image->frame.left, sent.left));
        EXPECT_TRUE(same(image->frame.right, sent.right));
        EXPECT_NEAR(image->frame.focal_px, 403.125, 1e-3);
        EXPECT_NEAR(image->frame.centre_v_px, 119.5, 1e-3);
        EXPECT_NEAR(image->frame.baseline_m, 0.12, 1e-6);
        EXPECT_EQ(image->age, std::chrono::milliseconds(80 + number));
        ++number;
      }
    }
    EXPECT_EQ(number, 3u) << "chunks of " << chunk;
    EXPECT_FALSE(reader.waiting());
    EXPECT_EQ(reader.counters().junk_bytes, 0u);
  }
}

TEST(ImageStream, FindsTheNextPairAfterJunkAndAHeaderThatMakesNoSense) {
  Bytes stream{'S', 'T', 'P', 'x', 0, 1, 2};
  Bytes huge = encode(pair_of(4, 4, 0), 1);
  huge[20] = huge[21] = 0xff;  // 65535 px wide
  append(stream, huge);
  append(stream, encode(pair_of(4, 4, 7), 2));
  Reader reader;
  reader.push(stream);
  const auto image = reader.next();
  ASSERT_TRUE(image);
  EXPECT_EQ(image->number, 2u);
  EXPECT_FALSE(reader.next());
  EXPECT_EQ(reader.counters().bad_headers, 1u);
  EXPECT_GT(reader.counters().junk_bytes, 7u);
}

TEST(ImageStream, ANewLineBeginsAnew) {
  const Bytes packet = encode(pair_of(4, 4, 0), 1);
  Reader reader;
  reader.push(ByteView(packet).first(60));
  EXPECT_TRUE(reader.waiting());
  reader.clear();
  reader.push(packet);
  EXPECT_TRUE(reader.next());
}

}  // namespace
}  // namespace striate::pioneer::image_stream
