#include "striate/platform/pioneer/laser/scip.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <limits>
#include <numbers>

namespace striate::pioneer::scip {
namespace {

/// More than any device sends before an empty line: then it is no reply.
constexpr std::size_t kLongestReply = 1 << 14;
constexpr std::size_t kDataLine = 64;  // SCIP 2.0: data comes in lines of 64 characters
constexpr int kTimeCharacters = 4;     // SCIP 2.0: 24 bits of time, 6 a character

bool all_digits(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

int number(const std::string& text) {
  int value = -1;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

bool is_data(const std::string& echo) {
  const std::string kind = echo.substr(0, 2);
  return kind == "MD" || kind == "MS" || kind == "GD" || kind == "GS";
}

}  // namespace

char sum_of(const std::string& line) {
  unsigned sum = 0;
  for (const char c : line) sum += static_cast<unsigned char>(c);
  return static_cast<char>((sum & 0x3fU) + 0x30U);
}

std::string write_request(const ScanRequest& request) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "M%c%04d%04d%02d%d%02d",
                request.three_characters ? 'D' : 'S', request.first_step, request.last_step,
                request.group, request.skip, request.count);
  return text.data();
}

std::optional<ScanRequest> read_request(const std::string& line) {
  const bool endless = line.rfind('M', 0) == 0;
  if (line.size() < (endless ? 15U : 12U) || !is_data(line)) return std::nullopt;
  const std::string digits = line.substr(2, endless ? 13 : 10);
  if (!all_digits(digits)) return std::nullopt;
  ScanRequest request;
  request.three_characters = line[1] == 'D';
  request.first_step = number(digits.substr(0, 4));
  request.last_step = number(digits.substr(4, 4));
  request.group = std::max(1, number(digits.substr(8, 2)));
  if (endless) {
    request.skip = number(digits.substr(10, 1));
    request.count = number(digits.substr(11, 2));
  }
  if (request.last_step < request.first_step) return std::nullopt;
  return request;
}

void ReplyStream::push(ByteView bytes) {
  buffer_.erase(0, at_);
  at_ = 0;
  buffer_.append(bytes.begin(), bytes.end());
}

bool ReplyStream::take_line(std::string& line) {
  if (after_cr_ && at_ < buffer_.size()) {
    if (buffer_[at_] == '\n') ++at_;  // CR LF is one end of a line, also when a split parts them
    after_cr_ = false;
  }
  const std::size_t end = buffer_.find_first_of("\n\r", at_);
  if (end == std::string::npos) return false;
  line = buffer_.substr(at_, end - at_);
  after_cr_ = buffer_[end] == '\r';
  at_ = end + 1;
  return true;
}

std::optional<Reply> ReplyStream::next() {
  std::string line;
  while (take_line(line)) {
    if (!line.empty()) {
      block_.push_back(line);
      if (block_.size() * kDataLine > kLongestReply) {
        block_.clear();
        ++counters_.malformed;
      }
      continue;
    }
    if (block_.empty()) continue;  // some devices send an empty line too many
    auto reply = finish();
    block_.clear();
    if (reply) return reply;
  }
  if (buffer_.size() - at_ > kLongestReply) {
    at_ = buffer_.size();
    ++counters_.malformed;
  }
  return std::nullopt;
}

std::optional<Reply> ReplyStream::finish() {
  // SCIP2.0 of a device that starts in the older protocol: echo and a bare status.
  Reply reply;
  reply.echo = block_[0];
  if (block_.size() < 2 || block_[1].empty() || block_[1].size() > 3) {
    ++counters_.malformed;
    return std::nullopt;
  }
  const std::string& status = block_[1];
  reply.status = status.substr(0, 2);
  if (status.size() == 3 && sum_of(reply.status) != status[2]) {
    ++counters_.bad_sum;
    return std::nullopt;
  }
  const bool data = is_data(reply.echo);
  for (std::size_t i = 2; i < block_.size(); ++i) {
    std::string text = block_[i];
    const char sum = text.back();
    text.pop_back();
    if (!data && !text.empty() && text.back() == ';') text.pop_back();
    const bool trusted = data || text.rfind("SERI:", 0) != 0;
    if (trusted && sum_of(text) != sum) {
      ++counters_.bad_sum;
      return std::nullopt;
    }
    reply.lines.push_back(std::move(text));
  }
  ++counters_.replies;
  return reply;
}

std::string write_reply(const Reply& reply, bool info) {
  std::string text = reply.echo + "\n" + reply.status + sum_of(reply.status) + "\n";
  for (const std::string& line : reply.lines) {
    text += line;
    if (info) text += ';';
    text += sum_of(line);
    text += '\n';
  }
  return text + "\n";
}

int decode(const char* text, int size) {
  int value = 0;
  for (int i = 0; i < size; ++i) {
    const int six = text[i] - 0x30;
    if (six < 0 || six > 0x3f) return -1;
    value = value << 6 | six;
  }
  return value;
}

std::string encode(int value, int size) {
  std::string text;
  for (int i = size - 1; i >= 0; --i) {
    text.push_back(static_cast<char>((value >> (6 * i) & 0x3f) + 0x30));
  }
  return text;
}

std::map<std::string, std::string> read_info(const Reply& reply) {
  std::map<std::string, std::string> info;
  for (const std::string& line : reply.lines) {
    const std::size_t colon = line.find(':');
    if (colon != std::string::npos) info[line.substr(0, colon)] = line.substr(colon + 1);
  }
  return info;
}

std::optional<Parameters> read_parameters(const Reply& reply) {
  if (reply.echo.rfind("PP", 0) != 0 || reply.status != "00") return std::nullopt;
  const auto info = read_info(reply);
  Parameters parameters;
  bool all = true;
  const auto take = [&](const char* key, int& field) {
    const auto entry = info.find(key);
    const int value = entry == info.end() ? -1 : number(entry->second);
    all = all && value >= 0;
    field = value;
  };
  take("DMIN", parameters.nearest_mm);
  take("DMAX", parameters.farthest_mm);
  take("ARES", parameters.steps_a_turn);
  take("AMIN", parameters.first_step);
  take("AMAX", parameters.last_step);
  take("AFRT", parameters.front_step);
  take("SCAN", parameters.rpm);
  if (!all || parameters.steps_a_turn == 0) return std::nullopt;
  if (const auto model = info.find("MODL"); model != info.end()) parameters.model = model->second;
  return parameters;
}

std::optional<Scan> read_scan(const Reply& reply, const Parameters& parameters) {
  const auto request = read_request(reply.echo);
  if (!request || reply.lines.size() < 2 || (reply.status != "99" && reply.status != "00")) {
    return std::nullopt;
  }
  if (reply.lines[0].size() != kTimeCharacters) return std::nullopt;
  Scan scan;
  scan.device_time_ms = decode(reply.lines[0].data(), kTimeCharacters);
  scan.left = request->count;
  std::string data;
  for (std::size_t i = 1; i < reply.lines.size(); ++i) data += reply.lines[i];
  const int size = request->three_characters ? 3 : 2;
  const int count = (request->last_step - request->first_step) / request->group + 1;
  if (scan.device_time_ms < 0 || data.size() != static_cast<std::size_t>(count * size)) {
    return std::nullopt;
  }
  const double step_rad = 2.0 * std::numbers::pi / parameters.steps_a_turn;
  for (int i = 0; i < count; ++i) {
    const int range_mm = decode(data.data() + i * size, size);
    if (range_mm < 0) return std::nullopt;
    const bool echo = range_mm >= parameters.nearest_mm && range_mm <= parameters.farthest_mm;
    const int step = request->first_step + i * request->group;
    scan.rays.push_back({(step - parameters.front_step) * step_rad,
                         echo ? range_mm / 1000.0 : std::numeric_limits<double>::infinity()});
  }
  return scan;
}

int read_time(const Reply& reply) {
  if (reply.lines.size() != 1 || reply.lines[0].size() != kTimeCharacters) return -1;
  return decode(reply.lines[0].data(), kTimeCharacters);
}

Reply write_time(const std::string& echo, int device_time_ms) {
  return {echo, "00", {encode(device_time_ms, kTimeCharacters)}};
}

Reply write_scan(const ScanRequest& request, int device_time_ms,
                 const std::vector<int>& ranges_mm) {
  return write_scan(write_request(request), device_time_ms, ranges_mm,
                    request.three_characters ? 3 : 2);
}

Reply write_scan(const std::string& echo, int device_time_ms, const std::vector<int>& ranges_mm,
                 int characters) {
  const bool endless = echo.rfind('M', 0) == 0;
  Reply reply{echo, endless ? "99" : "00", {encode(device_time_ms, kTimeCharacters)}};
  std::string data;
  for (const int range_mm : ranges_mm) data += encode(range_mm, characters);
  for (std::size_t at = 0; at < data.size(); at += kDataLine) {
    reply.lines.push_back(data.substr(at, kDataLine));
  }
  return reply;
}

}  // namespace striate::pioneer::scip
