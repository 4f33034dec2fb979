#include "striate/platform/served/pseudo_terminal.hpp"

#include <fcntl.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <stdexcept>

namespace striate::served {

PseudoTerminal::Descriptor::~Descriptor() {
  if (number_ >= 0) ::close(number_);
}

PseudoTerminal::PseudoTerminal() : master_(posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK)) {
  std::array<char, 64> name{};
  if (master_.get() < 0 || grantpt(master_.get()) != 0 || unlockpt(master_.get()) != 0 ||
      ptsname_r(master_.get(), name.data(), name.size()) != 0) {
    throw std::runtime_error("no pseudo-terminal is to be had");
  }
  name_ = name.data();
  // Held open, so that a client that leaves does not end the line.
  slave_ = Descriptor(::open(name_.c_str(), O_RDWR | O_NOCTTY));
  termios raw{};
  if (slave_.get() < 0 || tcgetattr(slave_.get(), &raw) != 0) {
    throw std::runtime_error(name_ + ": no access");
  }
  cfmakeraw(&raw);
  tcsetattr(slave_.get(), TCSANOW, &raw);
}

}  // namespace striate::served
