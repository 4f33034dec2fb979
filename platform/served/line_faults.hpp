#pragma once

#include <cstdint>
#include <deque>

#include "striate/base/bytes.hpp"
#include "striate/base/time.hpp"
#include "striate/platform/simulator/random.hpp"

namespace striate::served {

/// What is wrong with a served line, on request. Times count from the client's connection.
struct LineFaults {
  double loss = 0.0;         ///< share of chunks (about one packet each) that never come
  double corruption = 0.0;   ///< share of bytes of which one bit is turned over
  double delay_s = 0.0;      ///< each way
  double silent_at_s = 0.0;  ///< nothing passes from then on; 0: never
  double silent_for_s = 1.0;
  double break_at_s = 0.0;  ///< the connection is closed then; 0: never
};

/// One direction of a faulty line. Pure; the same seed spoils the same bytes.
class FaultyWay {
 public:
  FaultyWay(const LineFaults& faults, std::uint64_t seed)
      : faults_(faults), random_(seed, simulator::Purpose::line_faults) {}

  void put(ByteView bytes, double connected_s);
  /// What comes out at the other end by now.
  [[nodiscard]] Bytes take(double connected_s);

 private:
  struct Chunk {
    double due_s = 0.0;
    Bytes bytes;
  };
  void spoil(Bytes& bytes);

  LineFaults faults_;
  simulator::Random random_;
  std::uint64_t drawn_ = 0;
  std::deque<Chunk> under_way_;
};

}  // namespace striate::served
