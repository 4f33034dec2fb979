#include "striate/platform/pioneer/laser/scip.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>

namespace striate::pioneer::scip {
namespace {

/// More than any device sends before an empty line: then it is no reply.
constexpr std::size_t kLongestReply = 1 << 14;

bool all_digits(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

bool is_data(const std::string& echo) {
  const std::string kind = echo.substr(0, 2);
  return kind == "MD" || kind == "MS" || kind == "GD" || kind == "GS";
}

}  // namespace

int decimal_of(const std::string& text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool all = error == std::errc{} && end == text.data() + text.size() && text[0] != '-';
  return all ? value : -1;
}

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
  request.first_step = decimal_of(digits.substr(0, 4));
  request.last_step = decimal_of(digits.substr(4, 4));
  request.group = std::max(1, decimal_of(digits.substr(8, 2)));
  if (endless) {
    request.skip = decimal_of(digits.substr(10, 1));
    request.count = decimal_of(digits.substr(11, 2));
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

}  // namespace striate::pioneer::scip
