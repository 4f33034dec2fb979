#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "striate/base/bytes.hpp"
#include "striate/platform/interface/senses.hpp"

/// Stereo images over TCP, one packet a pair, little-endian:
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
///
/// How long a packet was under way nobody can tell by that. So the receiver may ask, and the sender
/// answers at once, behind what it has already sent:
///
///     0  "STPE"                 0  "STPE"
///     4  u32 question           4  u32 question; 0: nobody asked
///                               8  u64 sender's clock, in us
///
/// From the first question on the sender puts such a packet, with question 0, before each image: it
/// tells when that was sent. A sender that does not know the question sends what it always sent,
/// and a receiver that does not ask gets no such packet.
namespace striate::pioneer::image_stream {

inline constexpr std::size_t kHeader = 44;  ///< bytes of the header above
inline constexpr std::size_t kAgeAt = 12;   ///< where the age stands in it
/// A header that promises more is junk; four times the Bumblebee-2's 1024
inline constexpr int kWidest_px = 4096;

/// @param frame with both images, of the same size; its stamp is sent.
[[nodiscard]] Bytes encode(const StereoFrame& frame, std::uint32_t number);
/// Notes in an encoded packet how old its image is now.
void set_age(Bytes& packet, Duration age);

/// Asks how long the line takes. @param question any number but 0
[[nodiscard]] Bytes ask(std::uint32_t question);
/// What the sender's clock shows. @param question that is answered; 0: none
[[nodiscard]] Bytes tell_time(std::uint32_t question, Duration sender_clock);

struct Image {
  StereoFrame frame;  ///< without a stamp
  std::uint32_t number = 0;
  Duration age{};                ///< when it was sent
  Duration stamp{};              ///< of the exposure, by the sender's own count
  std::optional<Duration> sent;  ///< when it was sent, by the sender's clock; nothing: not told
};

struct Answer {
  std::uint32_t question = 0;
  Duration sent{};  ///< by the sender's clock
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
  /// The answers that were met on the way to the images so far.
  [[nodiscard]] std::vector<Answer> take_answers() { return std::exchange(answers_, {}); }
  /// A packet has begun and is not complete.
  [[nodiscard]] bool waiting() const { return at_ < buffer_.size(); }
  /// Forgets what has begun: the line is new.
  void clear();
  [[nodiscard]] const Counters& counters() const { return counters_; }

 private:
  enum class Found : std::uint8_t { nothing, image, time };
  [[nodiscard]] Found find();
  void take_time();
  [[nodiscard]] std::optional<Image> take_image();
  Bytes buffer_;
  std::size_t at_ = 0;
  std::optional<Duration> told_;  ///< by the packet before
  std::vector<Answer> answers_;
  Counters counters_;
};

/// The other side's: cuts what a receiver sends into its questions.
class QuestionReader {
 public:
  void push(ByteView bytes) { append(buffer_, bytes); }
  [[nodiscard]] std::optional<std::uint32_t> next();
  void clear() { buffer_.clear(); }

 private:
  Bytes buffer_;
};

}  // namespace striate::pioneer::image_stream
