#include "striate/app/interrupt.hpp"

#include <csignal>

namespace striate::app {
namespace {

volatile std::sig_atomic_t g_requested = 0;

extern "C" void note_request(int signal) {
  g_requested = 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

Interrupt::Interrupt() {
  g_requested = 0;
  std::signal(SIGINT, note_request);
  std::signal(SIGTERM, note_request);
}

Interrupt::~Interrupt() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

bool Interrupt::requested() {
  return g_requested != 0;
}

}  // namespace striate::app
