#include "striate/viewer/foxglove/foxglove_server.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <thread>
#include <utility>

#include "striate/base/steady_clock.hpp"
#include "striate/base/user_error.hpp"
#include "striate/viewer/channels/facts_ring.hpp"
#include "striate/viewer/foxglove/client_session.hpp"

namespace striate::viewer::foxglove {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;

/// Cycles that wait for the thread, by hand: 0.4 s, in 10 MB for images of 640 x 480
constexpr std::size_t kFactsSlots = 4;
/// Connections that have not been let in yet, by hand; the oldest makes room for a new one.
constexpr std::size_t kMostStrangers = 16;
/// After an error such as too many open files, by hand
constexpr auto kAcceptAgainAfter = std::chrono::milliseconds(100);
/// By hand: clients near by have read the last messages long before
constexpr auto kGoodByeTakes = std::chrono::milliseconds(500);
constexpr auto kLookAgainAfter = std::chrono::milliseconds(2);  // by hand, while it ends
/// Of the thread, added to the program's, by hand: where both want the same core, the cycle has it
/// for three quarters of the time.
constexpr int kNicer = 5;

void keep_from_children(int socket) {
  ::fcntl(socket, F_SETFD, FD_CLOEXEC);
}

/// What takes long to make, and may be left out where the thread is behind.
TopicSet costly_topics() {
  TopicSet topics;
  for (const Topic topic :
       {Topic::left_image, Topic::right_image, Topic::disparity, Topic::saliency}) {
    topics.set(static_cast<std::size_t>(topic));
  }
  return topics;
}

std::string url_of(const char* scheme, const tcp::endpoint& at, const std::string& token) {
  const std::string host = at.address().to_string();
  const bool is_v6 = at.address().is_v6();
  std::string url = fmt::format("{}://{}{}{}:{}", scheme, is_v6 ? "[" : "", host, is_v6 ? "]" : "",
                                static_cast<unsigned>(at.port()));
  if (!token.empty()) url += "/?token=" + token;
  return url;
}

}  // namespace

struct FoxgloveServer::Parts {
  Parts(const ServerOptions& options, ServerFacts facts, Channels channels_in);
  void listen(const ServerOptions& options);
  void accept_next();
  void accept(tcp::socket socket);
  void forget_gone();
  void show_facts();
  void show(Topic topic, std::uint64_t time_ns, ByteView message);
  void run();
  void end();
  void leave_when_all_have();

  SteadyClock clock;
  AccessRules rules;
  RemotePilot pilot;
  std::atomic<bool> stop_asked{false};
  std::atomic<std::size_t> joined{0};
  FactsRing ring{kFactsSlots};
  std::string url;
  std::string page_url;
  Host host;

  // The thread's own, once it runs.
  Channels channels;
  std::uint64_t next_id = 1;
  bool ending = false;
  asio::io_context io{1};
  tcp::acceptor acceptor{io};
  asio::steady_timer again{io};
  asio::steady_timer last_word{io};
  std::vector<std::shared_ptr<ClientSession>> sessions;

  std::thread thread;
};

FoxgloveServer::Parts::Parts(const ServerOptions& options, ServerFacts facts, Channels channels_in)
    : pilot(clock, channels_in.robot().resting_tilt_rad), channels(std::move(channels_in)) {
  host.facts = std::move(facts);
  host.facts.drives = options.drives;
  host.facts.session = new_token();
  host.pilot = &pilot;
  host.stop = [this] { stop_asked = true; };
  host.site = options.site;
  rules.listen = options.address;
  rules.others = options.others;
  rules.more_origins = options.more_origins;
  if (options.needs_token || !is_loopback(options.address)) rules.token = new_token();
  listen(options);
}

void FoxgloveServer::Parts::listen(const ServerOptions& options) {
  const std::string numeric = options.address == "localhost" ? "127.0.0.1" : options.address;
  boost::system::error_code error;
  const auto address = asio::ip::make_address(numeric, error);
  if (error) {
    throw UserError(fmt::format(
        "--listen {}: is no address of this machine\n    give one in numbers, as 0.0.0.0 for all",
        options.address));
  }
  try {
    const tcp::endpoint at(address, options.port);
    acceptor.open(at.protocol());
    keep_from_children(acceptor.native_handle());
    acceptor.set_option(tcp::acceptor::reuse_address(true));
    acceptor.bind(at);
    acceptor.listen();
    const tcp::endpoint bound = acceptor.local_endpoint();
    rules.port = bound.port();
    url = url_of("ws", bound, rules.token);
    page_url = url_of("http", bound, rules.token);
    if (rules.token.empty()) page_url += "/";
  } catch (const boost::system::system_error& failure) {
    throw UserError(
        fmt::format("{0}: cannot listen on {1} port {2}: {3}\n    {0} 0 takes any free port",
                    options.site ? "--view" : "--foxglove", options.address,
                    static_cast<unsigned>(options.port), failure.code().message()));
  }
}

void FoxgloveServer::Parts::accept_next() {
  acceptor.async_accept([this](const boost::system::error_code& error, tcp::socket socket) {
    if (error == asio::error::operation_aborted || ending) return;
    if (error) {
      again.expires_after(kAcceptAgainAfter);
      return again.async_wait([this](const auto& stopped) {
        if (!stopped) accept_next();
      });
    }
    try {
      accept(std::move(socket));
    } catch (const std::exception&) {  // no memory for one more: it goes without
    }
    accept_next();
  });
}

void FoxgloveServer::Parts::accept(tcp::socket socket) {
  keep_from_children(socket.native_handle());
  boost::system::error_code ignored;
  socket.set_option(tcp::no_delay(true), ignored);
  forget_gone();
  if (sessions.size() - joined >= kMostStrangers) {
    const auto oldest = std::find_if(sessions.begin(), sessions.end(),
                                     [](const auto& one) { return !one->joined(); });
    if (oldest != sessions.end()) (*oldest)->drop();
    forget_gone();
  }
  const auto may_join = [this] {
    forget_gone();
    return joined < kMostClients;
  };
  sessions.push_back(
      std::make_shared<ClientSession>(std::move(socket), host, rules, clock, may_join));
  sessions.back()->start(next_id++);
}

void FoxgloveServer::Parts::forget_gone() {
  sessions.erase(
      std::remove_if(sessions.begin(), sessions.end(), [](const auto& one) { return one->gone(); }),
      sessions.end());
  joined = static_cast<std::size_t>(std::count_if(sessions.begin(), sessions.end(),
                                                  [](const auto& one) { return one->joined(); }));
}

void FoxgloveServer::Parts::show(Topic topic, std::uint64_t time_ns, ByteView message) {
  const Published published{time_ns, std::make_shared<const Bytes>(message.begin(), message.end())};
  const auto place = static_cast<std::size_t>(topic);
  if (slow_topics()[place]) host.newest[place] = published;
  if (topic == Topic::log) {
    host.log.push_back(published);
    if (host.log.size() > Host::kMostLog) host.log.pop_front();
  }
  for (const auto& session : sessions) session->tell(topic, published);
}

void FoxgloveServer::Parts::show_facts() {
  while (const CycleFacts* facts = ring.front()) {
    forget_gone();
    TopicSet wanted = slow_topics();
    wanted.set(static_cast<std::size_t>(Topic::log));
    for (const auto& session : sessions) wanted |= session->wants();
    // On a busy machine poses and decisions come on, and pictures come when they can.
    if (ring.waiting() > 1) wanted &= ~costly_topics();
    channels.want(wanted);
    const auto now_ns = static_cast<std::uint64_t>(
        std::max<std::int64_t>(0, facts->senses.now.time_since_epoch().count()));
    const auto time = std::make_shared<const Bytes>(time_message(now_ns));
    for (const auto& session : sessions) session->tell_time(time);
    try {
      channels.publish(*facts, [this](Topic topic, std::uint64_t time_ns, ByteView message) {
        show(topic, time_ns, message);
      });
    } catch (const std::exception&) {  // an image that cannot be encoded is not shown
    }
    ring.pop();
  }
}

void FoxgloveServer::Parts::run() {
  ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()),
                ::getpriority(PRIO_PROCESS, 0) + kNicer);
  accept_next();
  while (true) {
    try {
      io.run();
      return;
    } catch (...) {  // of one handler, which is done with
    }
  }
}

void FoxgloveServer::Parts::end() {
  ending = true;
  boost::system::error_code ignored;
  acceptor.close(ignored);
  again.cancel();
  show_facts();
  for (const auto& session : std::vector(sessions)) session->end();
  last_word.expires_after(kGoodByeTakes);
  last_word.async_wait([this](const auto&) { io.stop(); });
  leave_when_all_have();
}

/// Good-byes take a moment, and the other side may take it or not.
void FoxgloveServer::Parts::leave_when_all_have() {
  forget_gone();
  if (sessions.empty()) return io.stop();
  again.expires_after(kLookAgainAfter);
  again.async_wait([this](const auto&) { leave_when_all_have(); });
}

FoxgloveServer::FoxgloveServer(const ServerOptions& options, ServerFacts facts, Channels channels)
    : parts_(std::make_unique<Parts>(options, std::move(facts), std::move(channels))) {
  parts_->thread = std::thread([parts = parts_.get()] { parts->run(); });
}

FoxgloveServer::~FoxgloveServer() {
  finish();
}

const std::string& FoxgloveServer::url() const {
  return parts_->url;
}

const std::string& FoxgloveServer::page_url() const {
  return parts_->page_url;
}

bool FoxgloveServer::put(const std::function<void(CycleFacts&)>& fill) {
  if (!parts_->ring.put(fill)) return false;
  asio::post(parts_->io, [parts = parts_.get()] { parts->show_facts(); });
  return true;
}

RemotePilot& FoxgloveServer::pilot() {
  return parts_->pilot;
}

bool FoxgloveServer::stop_asked() const {
  return parts_->stop_asked;
}

std::size_t FoxgloveServer::clients() const {
  return parts_->joined;
}

void FoxgloveServer::finish() {
  if (!parts_->thread.joinable()) return;
  asio::post(parts_->io, [parts = parts_.get()] { parts->end(); });
  parts_->thread.join();
}

}  // namespace striate::viewer::foxglove
