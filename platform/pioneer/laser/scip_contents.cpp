#include <limits>
#include <numbers>

#include "striate/platform/pioneer/laser/scip.hpp"

namespace striate::pioneer::scip {
namespace {

constexpr int kTimeCharacters = 4;  // SCIP 2.0: 24 bits of time, 6 a character

}  // namespace

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
    const int value = entry == info.end() ? -1 : decimal_of(entry->second);
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
