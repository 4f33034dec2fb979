#include "striate/platform/served/line_faults.hpp"

namespace striate::served {

void FaultyWay::spoil(Bytes& bytes) {
  if (faults_.corruption <= 0.0) return;
  for (std::uint8_t& byte : bytes) {
    if (random_.uniform(drawn_++) >= faults_.corruption) continue;
    byte ^= static_cast<std::uint8_t>(1U << (random_.bits(drawn_++) % 8));
  }
}

void FaultyWay::put(ByteView bytes, double connected_s) {
  if (bytes.empty()) return;
  const bool silent = faults_.silent_at_s > 0.0 && connected_s >= faults_.silent_at_s &&
                      connected_s < faults_.silent_at_s + faults_.silent_for_s;
  if (silent || random_.uniform(drawn_++) < faults_.loss) return;
  Chunk chunk{connected_s + faults_.delay_s, Bytes(bytes.begin(), bytes.end())};
  spoil(chunk.bytes);
  under_way_.push_back(std::move(chunk));
}

Bytes FaultyWay::take(double connected_s) {
  Bytes bytes;
  while (!under_way_.empty() && under_way_.front().due_s <= connected_s + 1e-9) {
    append(bytes, under_way_.front().bytes);
    under_way_.pop_front();
  }
  return bytes;
}

}  // namespace striate::served
