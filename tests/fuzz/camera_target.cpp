#include "striate/platform/pioneer/camera/image_stream.hpp"
#include "tests/fuzz/fuzz_target.hpp"

using namespace striate;
using namespace striate;
using namespace striate::pioneer;

namespace {

/// What came out of a stream: number and first byte of each pair.
std::vector<std::pair<std::uint32_t, int>> pairs(ByteView bytes, std::size_t chunk) {
  image_stream::Reader reader;
  std::vector<std::pair<std::uint32_t, int>> all;
  for (std::size_t at = 0; at < bytes.size(); at += chunk) {
    reader.push(bytes.subspan(at, std::min(chunk, bytes.size() - at)));
    while (const auto image = reader.next()) {
      all.emplace_back(image->number, *image->frame.left.data);
    }
  }
  return all;
}

StereoFrame small_pair() {
  StereoFrame frame;
  frame.left = cv::Mat3b(3, 4, cv::Vec3b(1, 2, 3));
  frame.right = cv::Mat3b(3, 4, cv::Vec3b(4, 5, 6));
  frame.focal_px = 400.0;
  frame.centre_u_px = 1.5;
  frame.centre_v_px = 1.0;
  frame.baseline_m = 0.12;
  return frame;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (pairs({data, size}, 1) != pairs({data, size}, size + 1)) __builtin_trap();
  return 0;
}

std::vector<std::string> striate::fuzz::seeds() {
  const Bytes one = image_stream::encode(small_pair(), 1);
  const Bytes two = image_stream::encode(small_pair(), 2);
  return {std::string(one.begin(), one.end()) + std::string(two.begin(), two.end())};
}
