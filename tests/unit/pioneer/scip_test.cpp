#include "striate/platform/pioneer/laser/scip.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/reference/captures.hpp"

namespace striate::pioneer::scip {
namespace {

Bytes bytes_of(const std::string& text) {
  return {text.begin(), text.end()};
}

std::vector<Reply> decode_all(const Bytes& bytes, std::size_t chunk) {
  ReplyStream stream;
  std::vector<Reply> replies;
  for (std::size_t at = 0; at < bytes.size(); at += chunk) {
    stream.push(ByteView(bytes).subspan(at, std::min(chunk, bytes.size() - at)));
    while (auto reply = stream.next()) replies.push_back(std::move(*reply));
  }
  return replies;
}

TEST(Scip, SumsAreThoseOfTheManual) {
  EXPECT_EQ(sum_of("00"), 'P');
  EXPECT_EQ(sum_of("99"), 'b');
  EXPECT_EQ(sum_of("VEND:Hokuyo Automatic Co.,Ltd."), '[');
}

TEST(Scip, ValuesAreSixBitsACharacter) {
  EXPECT_EQ(decode("1Dh", 3), 5432);
  EXPECT_EQ(decode("CB", 2), 1234);
  EXPECT_EQ(encode(5432, 3), "1Dh");
  EXPECT_EQ(encode(1234, 2), "CB");
  EXPECT_EQ(decode("  ", 2), -1);
}

TEST(Scip, RequestsAreWrittenAsTheyAreRead) {
  EXPECT_EQ(write_request({}), "MD0044072501000");
  const auto request = read_request("MD0044072503000");
  ASSERT_TRUE(request);
  EXPECT_EQ(request->group, 3);
  EXPECT_EQ(read_request("GS0000010001")->last_step, 100);
  for (const char* wrong : {"", "MD", "MD00440725", "XX0044072503000", "MD0725004401000", "BM"}) {
    EXPECT_FALSE(read_request(wrong)) << wrong;
  }
}

TEST(Scip, AScanComesBackAsItWasWritten) {
  const ScanRequest request{.first_step = 44, .last_step = 725, .group = 1, .count = 7};
  std::vector<int> ranges_mm(682, 1500);
  ranges_mm[340] = 2750;
  ranges_mm[0] = 7;  // an error code
  const auto replies = decode_all(bytes_of(write_reply(write_scan(request, 123456, ranges_mm))), 7);
  ASSERT_EQ(replies.size(), 1u);
  const auto scan = read_scan(replies[0], {});
  ASSERT_TRUE(scan);
  EXPECT_EQ(scan->device_time_ms, 123456);
  EXPECT_EQ(scan->left, 7);
  ASSERT_EQ(scan->rays.size(), 682u);
  EXPECT_DOUBLE_EQ(scan->rays[340].distance_m, 2.75);
  EXPECT_NEAR(scan->rays[340].bearing_rad, 0.0, 1e-12) << "step 384 looks ahead";
  EXPECT_NEAR(scan->rays[681].bearing_rad, 341 * 2 * std::numbers::pi / 1024, 1e-12);
  EXPECT_TRUE(std::isinf(scan->rays[0].distance_m));
}

TEST(Scip, AWrongSumDropsTheReplyAndTheNextOneComes) {
  std::string bad = write_reply(write_scan({}, 1, std::vector<int>(682, 1500)));
  bad[100] = bad[100] == '0' ? '1' : '0';
  const std::string good = write_reply(write_scan({}, 2, std::vector<int>(682, 1500)));
  ReplyStream stream;
  stream.push(bytes_of(bad + "\n" + good));
  const auto reply = stream.next();
  ASSERT_TRUE(reply);
  EXPECT_EQ(read_scan(*reply, {})->device_time_ms, 2);
  EXPECT_EQ(stream.counters().bad_sum, 1u);
}

TEST(Scip, CarriageReturnsEndLinesWhereverTheStreamIsSplit) {
  const Bytes bytes = bytes_of("BM\r\n00P\r\n\r\nQT\r\n00P\r\n\r\n");
  for (std::size_t chunk = 1; chunk <= bytes.size(); ++chunk) {
    EXPECT_EQ(decode_all(bytes, chunk).size(), 2u) << chunk;
  }
}

TEST(Scip, TheSerialNumbersSumIsNotLookedAt) {
  const auto replies = decode_all(bytes_of("VV\n00P\nSERI:H0000001;!\nPROT:SCIP 2.0;N\n\n"), 100);
  ASSERT_EQ(replies.size(), 1u);
  EXPECT_EQ(read_info(replies[0]).at("PROT"), "SCIP 2.0");
}

TEST(ScipCapture, DecodesInAnyChunkingAndWithAFlippedBit) {
  for (const auto& file : reference::urg_captures()) {
    SCOPED_TRACE(file);
    Bytes bytes = reference::one_way(reference::read_capture(file), "L>H");
    const std::vector<Reply> all = decode_all(bytes, bytes.size());
    EXPECT_GT(all.size(), 25u);
    for (const std::size_t chunk : {1, 2, 3, 7, 64, 1000}) {
      EXPECT_EQ(decode_all(bytes, chunk).size(), all.size()) << chunk;
    }
    const bool ours = reference::named(file, "urg_scip");
    std::optional<Parameters> parameters;
    int scans = 0;
    for (const Reply& reply : all) {
      if (const auto read = read_parameters(reply)) parameters = read;
      if (reply.status != "99") continue;
      ASSERT_TRUE(parameters);
      const auto scan = read_scan(reply, *parameters);
      ASSERT_TRUE(scan);
      ASSERT_EQ(scan->rays.size(), 228u);
      // Ours sees 3 mm more each step from 440 mm on, here every third step from the 44th.
      for (std::size_t i = 0; ours && i < 228; ++i) {
        EXPECT_NEAR(scan->rays[i].distance_m, 0.572 + 0.009 * static_cast<double>(i), 1e-9);
      }
      ++scans;
    }
    EXPECT_GT(scans, 20);
    EXPECT_EQ(parameters->farthest_mm, 5600);
    bytes.resize(2200);
    const std::size_t whole = decode_all(bytes, bytes.size()).size();
    for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
      Bytes flipped = bytes;
      flipped[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
      // A line's end that is flipped can tie two replies together: both are lost then.
      ASSERT_GE(decode_all(flipped, 64).size() + 2, whole) << bit;
      for (const Reply& reply : decode_all(flipped, 64)) (void)read_scan(reply, *parameters);
    }
  }
}

}  // namespace
}  // namespace striate::pioneer::scip
