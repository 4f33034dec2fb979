#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "striate/viewer/cdr/cdr_writer.hpp"

namespace striate::viewer {

/// Writes what a message is made of as a `ros2msg` schema: its own fields, then each type within it
/// once, behind a line of 80 `=` and its name. Made from the same list of fields as the bytes, so
/// that the two cannot differ.
class RosSchemaWriter {
 public:
  /// @return the whole schema of a type
  template <RosMessage Message>
  [[nodiscard]] static std::string of() {
    RosSchemaWriter writer;
    writer.types_.push_back({Message::kType, {}});
    writer.describe<Message>(0);
    std::string text = writer.types_.front().second;
    for (std::size_t k = 1; k < writer.types_.size(); ++k) {
      text.append(80, '=').append("\nMSG: ").append(writer.types_[k].first) += '\n';
      text += writer.types_[k].second;
    }
    return text;
  }

  template <class T>
  void operator()(const char* name, const T& /*value*/) {
    const std::string line = type_name(static_cast<const T*>(nullptr)) + " " + name + "\n";
    types_[current_].second += line;
  }

 private:
  template <class Message>
  void describe(std::size_t place) {
    const std::size_t before = std::exchange(current_, place);
    Message().each_field(*this);
    current_ = before;
  }
  template <class T>
  std::string type_name(const T* /*unused*/) {
    if constexpr (std::is_same_v<T, bool>) {
      return "bool";
    } else if constexpr (std::is_same_v<T, std::byte>) {
      return "byte";
    } else if constexpr (std::is_floating_point_v<T>) {
      return "float" + std::to_string(8 * sizeof(T));
    } else if constexpr (std::is_integral_v<T>) {
      return (std::is_signed_v<T> ? "int" : "uint") + std::to_string(8 * sizeof(T));
    } else {
      return message_name<T>();
    }
  }
  std::string type_name(const std::string* /*unused*/) { return "string"; }
  template <class T>
  std::string type_name(const std::vector<T>* /*unused*/) {
    return type_name(static_cast<const T*>(nullptr)) + "[]";
  }
  template <class T, std::size_t kSize>
  std::string type_name(const std::array<T, kSize>* /*unused*/) {
    return type_name(static_cast<const T*>(nullptr)) + "[" + std::to_string(kSize) + "]";
  }
  template <class Message>
  std::string message_name() {
    for (const auto& known : types_) {
      if (known.first == Message::kType) return Message::kType;
    }
    types_.push_back({Message::kType, {}});
    describe<Message>(types_.size() - 1);
    return Message::kType;
  }

  std::vector<std::pair<std::string, std::string>> types_;  ///< name, lines
  std::size_t current_ = 0;
};

/// "sensor_msgs/Image" as MCAP and ROS 2 name the schema: "sensor_msgs/msg/Image".
[[nodiscard]] inline std::string schema_name(const std::string& type) {
  const std::size_t slash = type.find('/');
  return type.substr(0, slash) + "/msg" + type.substr(slash);
}

}  // namespace striate::viewer
