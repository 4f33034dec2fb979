#include "striate/platform/rosbridge/json_fields.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "striate/base/base64.hpp"

namespace striate::rosbridge {
namespace {

using nlohmann::json;

/// Braces within braces; an odometry message in its envelope has five (ours)
constexpr int kDeepest = 16;

}  // namespace

json read_object(std::string_view text) {
  const auto not_too_deep = [](int depth, json::parse_event_t, const json&) {
    if (depth > kDeepest) throw BadMessage("a message is nested too deeply");
    return true;
  };
  try {
    json message = json::parse(text.begin(), text.end(), not_too_deep);
    if (message.is_object()) return message;
  } catch (const json::exception&) {
  }
  throw BadMessage("a message is no JSON object");
}

const json& field_at(const json& message, std::string_view path) {
  const json* field = &message;
  std::string_view rest = path;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('.'), rest.size());
    const auto found =
        field->is_object() ? field->find(std::string(rest.substr(0, end))) : field->end();
    if (found == field->end()) throw BadMessage(fmt::format("'{}' is missing", path));
    field = &*found;
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return *field;
}

double number_at(const json& message, std::string_view path) {
  const json& field = field_at(message, path);
  const double number = field.is_number() ? field.get<double>() : std::nan("");
  if (!std::isfinite(number)) throw BadMessage(fmt::format("'{}' is no number", path));
  return number;
}

std::int64_t count_at(const json& message, std::string_view path, std::int64_t most) {
  const json& field = field_at(message, path);
  if (field.is_number_unsigned() &&
      field.get<std::uint64_t>() <= static_cast<std::uint64_t>(most)) {
    return field.get<std::int64_t>();
  }
  throw BadMessage(fmt::format("'{}' is no whole number from 0 to {}", path, most));
}

const std::string& text_at(const json& message, std::string_view path) {
  const json& field = field_at(message, path);
  if (!field.is_string()) throw BadMessage(fmt::format("'{}' is no text", path));
  return field.get_ref<const std::string&>();
}

std::vector<double> numbers_at(const json& message, std::string_view path, std::size_t most) {
  const json& field = field_at(message, path);
  if (!field.is_array()) throw BadMessage(fmt::format("'{}' is no list", path));
  if (field.size() > most) {
    throw BadMessage(fmt::format("'{}' has {} numbers; {} can be used", path, field.size(), most));
  }
  std::vector<double> numbers;
  numbers.reserve(field.size());
  for (const json& one : field) {
    numbers.push_back(one.is_number() ? one.get<double>()
                                      : std::numeric_limits<double>::quiet_NaN());
  }
  return numbers;
}

std::vector<std::uint8_t> bytes_at(const json& message, std::string_view path) {
  const json& field = field_at(message, path);
  if (field.is_string()) {
    try {
      return from_base64(field.get_ref<const std::string&>());
    } catch (const std::invalid_argument&) {
      throw BadMessage(fmt::format("'{}' is no base64", path));
    }
  }
  if (!field.is_array()) throw BadMessage(fmt::format("'{}' is neither base64 nor a list", path));
  std::vector<std::uint8_t> bytes;
  bytes.reserve(field.size());
  for (const json& one : field) {
    if (!one.is_number_unsigned() || one.get<std::uint64_t>() > 255) {
      throw BadMessage(fmt::format("'{}' has numbers that are no bytes", path));
    }
    bytes.push_back(static_cast<std::uint8_t>(one.get<unsigned>()));
  }
  return bytes;
}

}  // namespace striate::rosbridge
