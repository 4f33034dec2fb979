#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "striate/platform/pioneer/questions.hpp"

namespace striate::pioneer {

/// How late the line to the base is, there and back, by small questions that its controller
/// answers. PULSE has no echo, and packets that keep coming say nothing of how long they took.
/// Pure; the session sends what it asks.
class RoundTrip {
 public:
  /// In the order in which they are asked: one when those before it stay unanswered. ENCODER
  /// takes 9 bytes there and 14 back, every fifth of a second 7 % of a line of 9600 baud.
  enum class Question : std::uint8_t { encoders, joystick, io, config };

  /// A new connection: nothing is known of the line.
  void begin(TimePoint now);
  /// What to ask now, if anything. It counts as asked.
  [[nodiscard]] std::optional<Question> asks(TimePoint now);
  /// Somebody else has asked, as the session does while it sets up.
  void asked(Question question, TimePoint now) { questions_.ask(question, now); }
  void answered(Question question, TimePoint now);

  /// How long a command may be under way, and a packet back, together at most: by the newest
  /// answer, and by the question that still waits for its own. Nothing: none was answered yet.
  [[nodiscard]] std::optional<Duration> delay(TimePoint now) const;
  /// Of the newest answer.
  [[nodiscard]] std::optional<Duration> measured() const { return measured_; }

 private:
  static constexpr std::array kAll{Question::encoders, Question::joystick, Question::io,
                                   Question::config};
  Questions<Question> questions_;
  std::optional<Duration> measured_;
  TimePoint asked_at_;
  bool asked_ = false;
};

}  // namespace striate::pioneer
