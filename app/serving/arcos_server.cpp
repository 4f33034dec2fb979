#include "app/serving/arcos_server.hpp"

#include <fmt/format.h>

#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/write.hpp>
#include <optional>
#include <stdexcept>
#include <thread>

#include "app/serving/pseudo_terminal.hpp"

namespace striate {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;
using Tcp = asio::ip::tcp;
using pioneer::Bytes;

/// More than so much waiting: the client does not read, and is let go.
constexpr std::size_t kMostWaiting = 1 << 16;
/// Later than this the clock is set anew instead of catching up in a burst.
constexpr auto kMostLate = std::chrono::milliseconds(200);

}  // namespace

struct ArcosServer::Parts {
  Parts(ServedPioneer& robot_in, const ServeSettings& settings_in, Log log_in)
      : robot(robot_in),
        settings(settings_in),
        log(std::move(log_in)),
        acceptor(io),
        client(io),
        terminal(io) {}

  void listen();
  void open_terminal();
  void accept();
  void greet(Tcp::socket socket);
  void let_go(const std::string& why);
  template <class Stream>
  void read_on(Stream& stream);
  template <class Stream>
  void write_on(Stream& stream);
  void write(const Bytes& bytes);
  void one_step();
  void tell();
  [[nodiscard]] double connected_s() const { return to_seconds(robot.now() - connected_at); }

  ServedPioneer& robot;
  ServeSettings settings;
  Log log;
  asio::io_context io{1};
  Tcp::acceptor acceptor;
  Tcp::socket client;
  asio::posix::stream_descriptor terminal;
  std::optional<PseudoTerminal> pty;
  std::string url;

  bool has_client = false;
  std::uint64_t generation = 0;
  TimePoint connected_at;
  bool was_stopped = false;
  std::optional<FaultyWay> to_robot;
  std::optional<FaultyWay> to_client;
  std::array<std::uint8_t, 1024> chunk{};
  Bytes outbox;
  Bytes under_way;
  bool writing = false;

  mutable std::mutex mutex;
  ServedState state;
};

void ArcosServer::Parts::listen() {
  error_code error;
  const auto address = asio::ip::make_address(settings.address, error);
  if (error) throw std::runtime_error(settings.address + ": is no address");
  const Tcp::endpoint place(address, static_cast<std::uint16_t>(settings.port));
  acceptor.open(place.protocol());
  acceptor.set_option(Tcp::acceptor::reuse_address(true));
  acceptor.bind(place, error);
  if (!error) acceptor.listen(4, error);
  if (error) {
    throw std::runtime_error(
        fmt::format("{}:{}: {}", settings.address, settings.port, error.message()));
  }
  url = fmt::format("tcp://{}:{}", settings.address, acceptor.local_endpoint().port());
  accept();
}

void ArcosServer::Parts::open_terminal() {
  pty.emplace();
  terminal.assign(pty->master());
  url = "pty:" + pty->name();
  has_client = true;
  to_robot.emplace(settings.faults, 2 * settings.seed);
  to_client.emplace(settings.faults, 2 * settings.seed + 1);
  read_on(terminal);
}

void ArcosServer::Parts::accept() {
  acceptor.async_accept([this](const error_code& error, Tcp::socket socket) {
    const bool gone = error == boost::asio::error::connection_aborted;
    if (error && !gone) {
      if (error != boost::asio::error::operation_aborted)
        log("no more clients are taken: " + error.message());
      return;
    }
    if (gone) {
      log("a client went before it was taken");
    } else if (has_client) {
      log("a second client was turned away");
    } else {
      greet(std::move(socket));
    }
    accept();
  });
}

void ArcosServer::Parts::greet(Tcp::socket socket) {
  client = std::move(socket);
  error_code ignored;
  client.set_option(Tcp::no_delay(true), ignored);
  // Like a robot that was switched off and on: the newcomer meets no older session.
  robot.firmware().reboot();
  has_client = true;
  connected_at = robot.now();
  outbox.clear();
  writing = false;
  to_robot.emplace(settings.faults, 2 * settings.seed);
  to_client.emplace(settings.faults, 2 * settings.seed + 1);
  log("a client has connected");
  read_on(client);
}

void ArcosServer::Parts::let_go(const std::string& why) {
  if (!has_client || pty) return;
  has_client = false;
  ++generation;
  error_code ignored;
  client.close(ignored);
  log("the client is gone: " + why);
}

template <class Stream>
void ArcosServer::Parts::read_on(Stream& stream) {
  stream.async_read_some(asio::buffer(chunk), [this, &stream, now = generation](
                                                  const error_code& error, std::size_t size) {
    if (now != generation) return;
    if (error) return let_go(error.message());
    to_robot->put(pioneer::ByteView(chunk).first(size), connected_s());
    read_on(stream);
  });
}

template <class Stream>
void ArcosServer::Parts::write_on(Stream& stream) {
  writing = true;
  under_way.swap(outbox);
  outbox.clear();
  asio::async_write(stream, asio::buffer(under_way),
                    [this, &stream, now = generation](const error_code& error, std::size_t) {
                      if (now != generation) return;
                      writing = false;
                      if (error) return let_go(error.message());
                      if (!outbox.empty()) write_on(stream);
                    });
}

void ArcosServer::Parts::write(const Bytes& bytes) {
  if (bytes.empty() || !has_client) return;
  pioneer::append(outbox, bytes);
  if (outbox.size() > kMostWaiting) {
    outbox.clear();
    return let_go("it does not read");
  }
  if (writing) return;
  if (pty) {
    write_on(terminal);
  } else {
    write_on(client);
  }
}

void ArcosServer::Parts::one_step() {
  pioneer::ArcosFirmware& firmware = robot.firmware();
  const LineFaults& faults = settings.faults;
  if (has_client && faults.break_at_s > 0.0 && connected_s() >= faults.break_at_s) {
    let_go("the link was broken on request");
  }
  if (to_robot) {
    const Bytes bytes = to_robot->take(connected_s());
    if (!bytes.empty()) firmware.receive(bytes, robot.now());
  }
  robot.step();
  const Bytes bytes = firmware.take_output();
  if (to_client) {
    to_client->put(bytes, connected_s());
    write(to_client->take(connected_s()));
  }
  if (firmware.watchdog_has_stopped() && !was_stopped) log("silence: the watchdog stops the robot");
  was_stopped = firmware.watchdog_has_stopped();
  tell();
}

void ArcosServer::Parts::tell() {
  const std::lock_guard lock(mutex);
  state.time_s = to_seconds(robot.now());
  state.true_pose = robot.true_pose();
  state.true_forward_m_s = robot.true_forward_m_s();
  state.connected = robot.firmware().connected();
  state.commanded_to_stand = robot.firmware().commanded_to_stand();
  state.motors_on = robot.firmware().motors_on();
}

ArcosServer::ArcosServer(ServedPioneer& robot, const ServeSettings& settings, Log log)
    : parts_(std::make_unique<Parts>(robot, settings, std::move(log))) {
  if (settings.pty) {
    parts_->open_terminal();
  } else {
    parts_->listen();
  }
}

ArcosServer::~ArcosServer() = default;

const std::string& ArcosServer::url() const {
  return parts_->url;
}

ServedState ArcosServer::state() const {
  const std::lock_guard lock(parts_->mutex);
  return parts_->state;
}

void ArcosServer::run(const std::function<bool()>& goes_on) {
  using Steady = std::chrono::steady_clock;
  Steady::time_point due = Steady::now();
  while (goes_on()) {
    due += ServedPioneer::kStep;
    if (Steady::now() > due + kMostLate) due = Steady::now();
    parts_->io.restart();
    parts_->io.run_until(due);
    std::this_thread::sleep_until(due);  // nothing may be left to wait for
    parts_->one_step();
  }
}

}  // namespace striate
