#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "striate/base/bytes.hpp"

/// SCIP 2.0, the protocol of Hokuyo's range finders: lines of text. A command is a line; a reply is
/// its echo, a status with a sum, lines with sums, and an empty line.
namespace striate::pioneer::scip {

/// Data comes in lines of so many characters; SCIP 2.0.
constexpr std::size_t kDataLine = 64;

/// The number that is written there; -1 where not all of it is digits.
[[nodiscard]] int decimal_of(const std::string& text);

/// One line of a reply: (sum of its bytes & 3F) + 30.
[[nodiscard]] char sum_of(const std::string& line);

/// "MD0044072503000": steps, grouped, every `skip + 1`th scan, `count` of them (0: endless).
struct ScanRequest {
  int first_step = 44;
  int last_step = 725;
  int group = 1;
  int skip = 0;
  int count = 0;
  bool three_characters = true;  ///< MD, 18 bits; otherwise MS, 12 bits
};
[[nodiscard]] std::string write_request(const ScanRequest& request);
/// Empty: no such command, or not well-formed.
[[nodiscard]] std::optional<ScanRequest> read_request(const std::string& line);

/// What a device says in one go.
struct Reply {
  std::string echo;                ///< the command without its LF
  std::string status;              ///< "00" done, "99" data of an endless scan, "0x" errors
  std::vector<std::string> lines;  ///< without their sums
};

/// Why replies were not taken.
struct Counters {
  std::uint64_t replies = 0;
  std::uint64_t bad_sum = 0;
  std::uint64_t malformed = 0;
};

/// Cuts a stream of text into replies; any split gives the same ones. A reply with a wrong sum is
/// dropped whole. Sums of information lines stand behind ';'; that of the serial number is wrong in
/// real devices and is not looked at.
class ReplyStream {
 public:
  void push(ByteView bytes);
  [[nodiscard]] std::optional<Reply> next();
  [[nodiscard]] const Counters& counters() const { return counters_; }

 private:
  [[nodiscard]] bool take_line(std::string& line);
  std::optional<Reply> finish();

  std::string buffer_;
  std::size_t at_ = 0;
  bool after_cr_ = false;
  std::vector<std::string> block_;
  Counters counters_;
};

/// As bytes, with sums: what a device sends. `info` lines carry their sum behind ';'.
[[nodiscard]] std::string write_reply(const Reply& reply, bool info = false);

/// A value of `size` characters, six bits each, most significant first; -1: not such characters.
[[nodiscard]] int decode(const char* text, int size);
[[nodiscard]] std::string encode(int value, int size);

/// VV, PP and II as key and value.
[[nodiscard]] std::map<std::string, std::string> read_info(const Reply& reply);

/// What PP says; the defaults are those of a URG-04LX.
struct Parameters {
  std::string model = "URG-04LX";
  int nearest_mm = 20;
  int farthest_mm = 5600;
  int steps_a_turn = 1024;
  int first_step = 44;
  int last_step = 725;
  int front_step = 384;
  int rpm = 600;
};
[[nodiscard]] std::optional<Parameters> read_parameters(const Reply& reply);

struct Ray {
  double bearing_rad = 0.0;  ///< counter-clockwise, 0: ahead
  double distance_m = 0.0;   ///< +inf: no echo, or one of the device's error codes
};
struct Scan {
  int device_time_ms = 0;  ///< 24 bits, wraps
  int left = 0;            ///< scans still to come of those that were asked for
  std::vector<Ray> rays;
};
/// Empty when the reply holds no scan or not as many values as its echo says.
[[nodiscard]] std::optional<Scan> read_scan(const Reply& reply, const Parameters& parameters);
/// What the device's clock shows, in ms of 24 bits, in its reply to TM1; -1: it does not say.
[[nodiscard]] int read_time(const Reply& reply);
/// A device's reply to a running MD or MS. ranges_mm: as many as the request asks for.
[[nodiscard]] Reply write_scan(const ScanRequest& request, int device_time_ms,
                               const std::vector<int>& ranges_mm);
/// The same under an echo of the device's own. @param characters 3 of MD and GD, 2 of MS and GS
[[nodiscard]] Reply write_scan(const std::string& echo, int device_time_ms,
                               const std::vector<int>& ranges_mm, int characters);
/// A device's reply to TM1. @param echo the command
[[nodiscard]] Reply write_time(const std::string& echo, int device_time_ms);

}  // namespace striate::pioneer::scip
