#include "striate/platform/pioneer/base_driver.hpp"

namespace striate::pioneer {

void BaseDriver::care_for_the_line(TimePoint now) {
  if (!session_.wants_line(now)) {
    if (line_.is_open() || line_.is_opening()) line_.close();
    asked_to_open_ = false;
    return;
  }
  if (line_.is_open()) {
    session_.line_up(now);
  } else if (!line_.is_opening()) {
    if (asked_to_open_) {
      session_.line_down(now);
      asked_to_open_ = false;
    } else {
      line_.open();
      asked_to_open_ = true;
    }
  }
}

void BaseDriver::step(TimePoint now) {
  if (line_.is_open()) session_.receive(line_.read(), now);
  gate_.tick(now);
  session_.tick(now);
  // What is to be said goes out before the line may be closed.
  const Bytes bytes = session_.take_output();
  if (!bytes.empty() && line_.is_open()) line_.write(bytes);
  care_for_the_line(now);
}

}  // namespace striate::pioneer
