#include "striate/platform/pioneer/who_answers.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <string_view>
#include <vector>

#include "striate/platform/pioneer/arcos/command.hpp"
#include "striate/platform/pioneer/arcos/other_packets.hpp"
#include "striate/platform/pioneer/arcos/packet_stream.hpp"
#include "striate/platform/pioneer/arcos/sip.hpp"
#include "striate/platform/pioneer/camera/image_stream.hpp"
#include "striate/platform/pioneer/laser/lms200.hpp"
#include "striate/platform/pioneer/laser/scip.hpp"
#include "striate/platform/pioneer/turret/dynamixel.hpp"

namespace striate::pioneer {
namespace {

using AnswerClock = std::chrono::steady_clock;

/// Two SIP cycles and a half: a base with an open session, or a laser that scans, has spoken by
/// then
constexpr Duration kListenFirst = std::chrono::milliseconds(250);
constexpr Duration kBetweenReads = std::chrono::milliseconds(5);  // not felt by who waits
constexpr std::uint8_t kAskedRegisters = 3;  // model and firmware; an echo has two parameters

/// Hears what came since the last question as each kind would say it.
struct Ears {
  arcos::PacketStream base;
  dynamixel::PacketStream turret;
  scip::ReplyStream hokuyo;
  lms200::TelegramStream lms;
  image_stream::Reader camera;
  int sync = 0;                ///< the step of the base's handshake that has been said
  std::optional<int> servo{};  ///< id that was asked; else an image's bytes may pass for a reply

  [[nodiscard]] std::optional<Answerer> hear(ByteView bytes, Transport& line);

 private:
  [[nodiscard]] bool is_base(Transport& line);
  [[nodiscard]] bool is_turret();
  [[nodiscard]] bool is_hokuyo();
  [[nodiscard]] bool is_lms();
  [[nodiscard]] bool is_camera();
};

/// Its names end the handshake; a line that only echoes never tells them.
bool Ears::is_base(Transport& line) {
  while (const auto packet = base.next()) {
    if (arcos::is_sip(*packet) || arcos::read_names(*packet)) return true;
    if (packet->id != sync || sync >= 2) continue;
    ++sync;
    line.write(arcos::command(static_cast<arcos::Command>(sync)));
  }
  return false;
}

bool Ears::is_turret() {
  while (const auto packet = turret.next()) {
    if (servo == packet->id && packet->parameters.size() == kAskedRegisters) return true;
  }
  return false;
}

bool Ears::is_hokuyo() {
  while (const auto reply = hokuyo.next()) {
    const bool named = reply->echo == "VV" && reply->status == "00" && !reply->lines.empty();
    if (named || (reply->status == "99" && !reply->lines.empty())) return true;
  }
  return false;
}

bool Ears::is_lms() {
  while (const auto telegram = lms.next()) {
    if (telegram->data[0] == 0xba || telegram->data[0] == 0xb0) return true;  // type, or a scan
  }
  return false;
}

bool Ears::is_camera() {
  if (camera.next()) return true;
  return !camera.take_answers().empty();
}

std::optional<Answerer> Ears::hear(ByteView bytes, Transport& line) {
  base.push(bytes);
  turret.push(bytes);
  hokuyo.push(bytes);
  lms.push(bytes);
  camera.push(bytes);
  if (is_base(line)) return Answerer::base;
  if (is_turret()) return Answerer::turret;
  if (is_hokuyo()) return Answerer::hokuyo;
  if (is_lms()) return Answerer::lms200;
  if (is_camera()) return Answerer::camera;
  return std::nullopt;
}

Bytes question_for(Answerer kind, std::optional<int> servo) {
  switch (kind) {
    case Answerer::base:
      return arcos::command(arcos::Command::sync0);
    case Answerer::turret:
      return dynamixel::read(static_cast<std::uint8_t>(servo.value_or(1)),
                             dynamixel::Register::model, kAskedRegisters);
    case Answerer::hokuyo: {
      // A line's end first: what was asked before is no part of this.
      constexpr std::string_view kAsk = "\nSCIP2.0\nVV\n";
      return {kAsk.begin(), kAsk.end()};
    }
    case Answerer::lms200:
      return lms200::encode({lms200::kToLaser, {0x3a}});
    case Answerer::camera:
      return image_stream::ask(1);
    case Answerer::nobody:
      break;
  }
  return {};
}

/// With fresh ears: half a word of before would hide what comes.
std::optional<Answerer> ask_one(Answerer kind, Transport& line, Duration patience,
                                std::optional<int> servo = {}) {
  Ears ears;
  ears.servo = servo;
  const Bytes question = question_for(kind, servo);
  if (!question.empty()) line.write(question);
  const auto end = AnswerClock::now() + patience;
  while (AnswerClock::now() < end && line.is_open()) {
    line.wait(kBetweenReads);
    if (const auto heard = ears.hear(line.read(), line)) return heard;
  }
  return std::nullopt;
}

/// Servos share one wire: the second is asked when the first has had its time.
std::optional<Answerer> ask_as(Answerer kind, Transport& line, const ServoIds& servos,
                               Duration patience) {
  if (kind != Answerer::turret) return ask_one(kind, line, patience);
  const auto heard = ask_one(kind, line, patience / 2, servos.pan);
  return heard ? heard : ask_one(kind, line, patience / 2, servos.tilt);
}

}  // namespace

std::string name_of(Answerer kind) {
  switch (kind) {
    case Answerer::base:
      return "a base";
    case Answerer::turret:
      return "a turret of AX-12A servos";
    case Answerer::hokuyo:
      return "a Hokuyo laser";
    case Answerer::lms200:
      return "an LMS-200 laser";
    case Answerer::camera:
      return "a camera's image stream";
    case Answerer::nobody:
      break;
  }
  return "nothing";
}

Answerer who_answers(Transport& line, Answerer expected, const ServoIds& servos,
                     Duration patience) {
  if (const auto heard = ask_one(Answerer::nobody, line, std::min(kListenFirst, patience)))
    return *heard;
  if (const auto heard = ask_as(expected, line, servos, patience)) return *heard;
  for (const Answerer other :
       {Answerer::base, Answerer::hokuyo, Answerer::lms200, Answerer::turret, Answerer::camera}) {
    if (other == expected) continue;
    if (const auto heard = ask_as(other, line, servos, patience)) return *heard;
  }
  return Answerer::nobody;
}

}  // namespace striate::pioneer
