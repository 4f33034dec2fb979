#pragma once

#include <sys/types.h>

#include <functional>

namespace striate::pioneer {

/// A line to a robot's base that a process of its own holds, the keeper, so that the wheels are
/// told to stand when this program dies of anything, or is stopped: LineKeeper is what it does. It
/// is a forked child which allocates nothing and calls only what is safe after a fork, so it may be
/// made beside running threads. Signals of the terminal and of process groups do not reach it. Only
/// if it is killed, too, the robot's own watchdog (2 s) is what is left.
class KeptLine {
 public:
  /// @param robot descriptor of the open line, which does not block; the keeper's from now on.
  /// @throws std::system_error where there can be no keeper.
  explicit KeptLine(int robot);
  /// Like the death of the program, unless let_go() was called: the keeper brakes.
  ~KeptLine();
  KeptLine(const KeptLine&) = delete;
  KeptLine& operator=(const KeptLine&) = delete;

  /// The mind's end of the line, a stream socket; the caller has to close it.
  [[nodiscard]] int release_end();
  /// Nothing more will come, on purpose, and the line is to be free: waits until the keeper has
  /// sent what it was given and is gone, 0.5 s at most. @param close_end closes the mind's end
  void let_go(const std::function<void()>& close_end);
  [[nodiscard]] pid_t keeper() const { return keeper_; }

 private:
  int end_ = -1;
  int word_ = -1;  ///< a byte in it says that the end was closed on purpose
  pid_t keeper_ = -1;
};

}  // namespace striate::pioneer
