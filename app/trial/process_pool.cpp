#include "striate/app/trial/process_pool.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <map>
#include <stdexcept>
#include <thread>

namespace striate::app {
namespace {

struct Child {
  std::size_t job = 0;
  int error_fd = -1;
  std::string output;
};

/// Reads what has come without waiting for more.
void drain(Child& child) {
  std::array<char, 4096> buffer{};
  while (true) {
    const ssize_t count = read(child.error_fd, buffer.data(), buffer.size());
    if (count <= 0) return;
    if (child.output.size() < 64 * 1024) {
      child.output.append(buffer.data(), static_cast<std::size_t>(count));
    }
  }
}

/// The new process. It asks to be ended with this one, whatever ends that.
[[noreturn]] void become(const std::vector<char*>& arguments, int error_fd, pid_t parent) {
  // A process group of its own: Ctrl-C reaches the trial, which tells its runs.
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(1);  // it had ended before
  const int nothing = open("/dev/null", O_RDWR);
  dup2(nothing, STDIN_FILENO);
  dup2(nothing, STDOUT_FILENO);
  dup2(error_fd, STDERR_FILENO);
  if (nothing > STDERR_FILENO) close(nothing);
  execv(arguments[0], arguments.data());
  dprintf(STDERR_FILENO, "%s cannot be started: %s\n", arguments[0], std::strerror(errno));
  _exit(127);
}

pid_t start(const std::vector<std::string>& command, int& error_fd) {
  std::array<int, 2> pipe_fds{};
  if (pipe2(pipe_fds.data(), O_CLOEXEC | O_NONBLOCK) != 0) {
    throw std::runtime_error(fmt::format("no pipe for a run: {}", std::strerror(errno)));
  }
  std::vector<char*> arguments;
  arguments.reserve(command.size() + 1);
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const pid_t parent = getpid();
  const pid_t pid = fork();
  if (pid == 0) become(arguments, pipe_fds[1], parent);
  close(pipe_fds[1]);
  if (pid < 0) {
    close(pipe_fds[0]);
    throw std::runtime_error(fmt::format("no process for a run: {}", std::strerror(errno)));
  }
  error_fd = pipe_fds[0];
  return pid;
}

}  // namespace

void run_processes(const std::vector<std::vector<std::string>>& commands, int jobs,
                   const std::function<void(const ProcessEnd&)>& on_end,
                   const std::function<bool()>& cancelled) {
  std::map<pid_t, Child> running;
  std::size_t next = 0;
  bool told_to_end = false;
  while (true) {
    const bool cancel = cancelled();
    while (!cancel && next < commands.size() && static_cast<int>(running.size()) < jobs) {
      Child child;
      child.job = next;
      const pid_t pid = start(commands[next], child.error_fd);
      running.emplace(pid, std::move(child));
      ++next;
    }
    if (running.empty()) return;
    if (cancel && !told_to_end) {
      for (const auto& [pid, child] : running) kill(pid, SIGTERM);
      told_to_end = true;
    }
    for (auto& [pid, child] : running) drain(child);
    int status = 0;
    const pid_t ended = waitpid(-1, &status, WNOHANG);
    const auto found = running.find(ended);
    if (found == running.end()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      continue;
    }
    drain(found->second);
    close(found->second.error_fd);
    const int exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    const ProcessEnd end{found->second.job, exit_code, std::move(found->second.output)};
    running.erase(found);
    on_end(end);
  }
}

}  // namespace striate::app
