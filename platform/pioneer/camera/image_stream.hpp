#pragma once

#include <optional>

#include "striate/base/bytes.hpp"
#include "striate/platform/interface/senses.hpp"

/// Stereo images over TCP, one packet a pair, little-endian, nothing goes the other way:
///
///     0  "STPP"                20  u16 width, u16 height
///     4  u32 number            24  u32 focal, u32 centre u, u32 centre v, in 1/1000 px
///     8  u32 stamp, ms         36  u32 baseline, in um
///    12  u32 age, us           40  u32 size of what follows: 2 * 3 * width * height
///    16  u32 encoding: 0       44  left image, right image: rows of B, G, R bytes
///
/// Images are rectified and not compressed: what is sent is what was seen, and the sender needs
/// no time for it. The age is that of the middle of the exposure when the packet was sent, so that
/// neither side needs the other's clock.
namespace striate::pioneer::image_stream {

inline constexpr std::size_t kHeader = 44;  ///< bytes of the header above
inline constexpr std::size_t kAgeAt = 12;   ///< where the age stands in it
/// A header that promises more is junk; four times the Bumblebee-2's 1024
inline constexpr int kWidest_px = 4096;

/// @param frame with both images, of the same size; its stamp is sent.
[[nodiscard]] Bytes encode(const StereoFrame& frame, std::uint32_t number);
/// Notes in an encoded packet how old its image is now.
void set_age(Bytes& packet, Duration age);

struct Image {
  StereoFrame frame;  ///< without a stamp
  std::uint32_t number = 0;
  Duration age{};  ///< when it was sent
};

struct Counters {
  std::uint64_t pictures = 0;
  std::uint64_t bad_headers = 0;
  std::uint64_t junk_bytes = 0;
};

/// Cuts a stream into images; any split gives the same ones. What is no header is skipped, byte
/// by byte, up to the next one.
class Reader {
 public:
  void push(ByteView bytes);
  [[nodiscard]] std::optional<Image> next();
  /// A packet has begun and is not complete.
  [[nodiscard]] bool waiting() const { return at_ < buffer_.size(); }
  /// Forgets what has begun: the line is new.
  void clear();
  [[nodiscard]] const Counters& counters() const { return counters_; }

 private:
  [[nodiscard]] bool find_header();
  Bytes buffer_;
  std::size_t at_ = 0;
  Counters counters_;
};

}  // namespace striate::pioneer::image_stream
