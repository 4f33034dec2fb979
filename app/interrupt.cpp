#include "striate/app/interrupt.hpp"

#include <unistd.h>

#include <atomic>
#include <cstdint>
#include <ctime>

namespace striate::app {
namespace {

/// Those by which somebody asks, once, twice and in earnest.
constexpr std::array kAskingSignals{SIGINT, SIGTERM, SIGQUIT};
/// What else ends a program that does not catch it, and is no crash.
constexpr std::array kEndingSignals{SIGUSR1, SIGUSR2, SIGALRM, SIGVTALRM, SIGPROF,
                                    SIGIO,   SIGPWR,  SIGXCPU, SIGSTKFLT};
/// Signals that follow one another faster are one request: `timeout` and shells send to the program
/// and to its group. Two presses of a key are further apart (by hand)
constexpr std::int64_t kOneRequest_ms = 200;

std::atomic<bool> g_requested{false};
std::atomic<int> g_times_asked{0};
std::atomic<std::int64_t> g_asked_at_ms{0};
static_assert(std::atomic<std::int64_t>::is_always_lock_free, "handlers of signals must not lock");

std::int64_t signal_time_ms() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{1000} * now.tv_sec + now.tv_nsec / 1000000;
}

bool is_an_asking_one(int signal) {
  for (const int asking : kAskingSignals) {
    if (signal == asking) return true;
  }
  return false;
}

extern "C" void note_request(int signal, siginfo_t* info, void* /*context*/) {
  // The kernel sends these two to whoever writes: the write fails, too, and that is told there.
  const bool of_our_own_write =
      (signal == SIGPIPE || signal == SIGXFSZ) && info->si_pid == getpid();
  if (of_our_own_write) return;
  g_requested = true;
  if (!is_an_asking_one(signal)) return;
  const std::int64_t now_ms = signal_time_ms();
  if (g_times_asked > 0 && now_ms - g_asked_at_ms < kOneRequest_ms) return;
  g_asked_at_ms = now_ms;
  if (++g_times_asked < 2) return;
  struct sigaction kills {};
  kills.sa_handler = SIG_DFL;
  for (const int asking : kAskingSignals) sigaction(asking, &kills, nullptr);
}

}  // namespace

Interrupt::Interrupt(BrokenOutput broken) {
  g_requested = false;
  g_times_asked = 0;
  for (const int signal : kAskingSignals) catch_signal(signal, true);
  for (const int signal : kEndingSignals) catch_signal(signal, true);
  catch_signal(SIGHUP, false);  // `nohup` ignores it, and means it
  if (broken == BrokenOutput::ends) return;
  catch_signal(SIGPIPE, true);
  catch_signal(SIGXFSZ, true);
}

Interrupt::~Interrupt() {
  for (std::size_t i = 0; i < caught_; ++i) {
    Before& before = before_.at(i);
    // What was printed in vain is tried once more when the program ends, and told by its exit code.
    if (before.signal == SIGPIPE || before.signal == SIGXFSZ) before.action.sa_handler = SIG_IGN;
    sigaction(before.signal, &before.action, nullptr);
  }
}

void Interrupt::catch_signal(int signal, bool even_if_ignored) {
  Before& before = before_.at(caught_);
  before.signal = signal;
  if (sigaction(signal, nullptr, &before.action) != 0) return;
  if (!even_if_ignored && before.action.sa_handler == SIG_IGN) return;
  struct sigaction asks {};
  asks.sa_sigaction = note_request;
  asks.sa_flags = SA_SIGINFO | SA_RESTART;
  if (sigaction(signal, &asks, nullptr) == 0) ++caught_;
}

bool Interrupt::requested() {
  return g_requested;
}

bool Interrupt::insisted() {
  return g_times_asked >= 2;
}

}  // namespace striate::app
