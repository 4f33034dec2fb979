#pragma once

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <memory>
#include <string>
#include <thread>
#include <vector>

/// Programs that run beside a test, among them a ROS master of its own.
namespace striate::scenarios {

/// A program in the background; killed with the object.
class Program {
 public:
  /// @param log file for what it prints
  Program(const std::vector<std::string>& words, const std::string& log) {
    pid_ = fork();
    if (pid_ != 0) return;
    const int file = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    if (chdir(STRIATE_SOURCE_DIR) != 0 || file < 0) _exit(99);
    dup2(file, STDOUT_FILENO);
    dup2(file, STDERR_FILENO);
    std::vector<char*> argv;
    for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
    argv.push_back(nullptr);
    execvp(argv[0], argv.data());
    _exit(98);
  }
  ~Program() { kill(SIGKILL); }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void kill(int signal) {
    if (pid_ <= 0) return;
    ::kill(pid_, signal);
    if (signal == SIGKILL) (void)wait(std::chrono::seconds(10));
  }
  /// Its exit code; -1: it was killed, or has not ended within `limit`.
  int wait(std::chrono::milliseconds limit) {
    const auto end = std::chrono::steady_clock::now() + limit;
    int status = 0;
    while (pid_ > 0 && waitpid(pid_, &status, WNOHANG) != pid_) {
      if (std::chrono::steady_clock::now() > end) return -1;
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    if (pid_ <= 0) return -1;
    pid_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  pid_t pid_ = -1;
};

inline sockaddr_in loopback(std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return address;
}

inline std::uint16_t free_port() {
  const int one = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address = loopback(0);
  socklen_t size = sizeof(address);
  (void)bind(one, reinterpret_cast<sockaddr*>(&address), size);
  (void)getsockname(one, reinterpret_cast<sockaddr*>(&address), &size);
  close(one);
  return ntohs(address.sin_port);
}

/// `rosmaster` on a free port of the loopback; the environment of this process, and so of all that
/// it starts, points at it.
class RosMaster {
 public:
  static bool installed() { return access(kProgram, X_OK) == 0; }

  explicit RosMaster(const std::string& folder)
      : folder_(folder), port_(point_at_a_free_port(folder)) {
    start();
  }
  /// At the same address again, after kill().
  void start() {
    program_ = std::make_unique<Program>(
        std::vector<std::string>{kProgram, "--core", "-p", std::to_string(port_)},
        folder_ + "/rosmaster.log");
  }
  void kill() { program_.reset(); }

  /// Whether it has come up.
  [[nodiscard]] bool answers() const {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (std::chrono::steady_clock::now() < end) {
      const int one = socket(AF_INET, SOCK_STREAM, 0);
      const sockaddr_in address = loopback(port_);
      const bool there =
          connect(one, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0;
      close(one);
      if (there) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return false;
  }

 private:
  static constexpr const char* kProgram = "/usr/bin/rosmaster";
  static std::uint16_t point_at_a_free_port(const std::string& folder) {
    const std::uint16_t port = free_port();
    setenv("ROS_MASTER_URI", ("http://127.0.0.1:" + std::to_string(port)).c_str(), 1);
    setenv("ROS_IP", "127.0.0.1", 1);
    setenv("ROS_LOG_DIR", folder.c_str(), 1);
    unsetenv("ROS_HOSTNAME");
    unsetenv("ROS_NAMESPACE");
    return port;
  }
  std::string folder_;
  std::uint16_t port_;
  std::unique_ptr<Program> program_;
};

}  // namespace striate::scenarios
