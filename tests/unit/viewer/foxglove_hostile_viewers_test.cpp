#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <deque>

#include "striate/base/user_error.hpp"
#include "tests/unit/viewer/foxglove_viewer.hpp"

/// Viewers that never read, flood, lie, and come in crowds.
namespace striate::viewer::foxglove {
namespace {

TEST_F(FoxgloveServerTest, OneThatNeverReadsHoldsUpNobody) {
  std::vector<std::unique_ptr<Viewer>> deaf;
  for (int k = 0; k < 3; ++k) {
    deaf.push_back(std::make_unique<Viewer>(connect()));
    deaf.back()->subscribe(Topic::left_image, 1);
    deaf.back()->subscribe(Topic::cycle, 2);
  }
  Viewer viewer(connect());
  viewer.subscribe(Topic::cycle, 2);
  viewer.say(json{{"op", "getParameters"}, {"parameterNames", json::array()}, {"id", "now"}});
  while (viewer.hear_json()["op"] != "parameterValues") {
  }
  for (std::uint64_t number = 1; number <= 60; ++number) {  // 0.75 MB each: more than any buffer
    ASSERT_TRUE(comes_true([&] { return cycle(number, 500); }));
    EXPECT_EQ(json::parse(viewer.hear_from(2))["number"], number);
  }
  EXPECT_EQ(server_.clients(), 4U);
  // Who reads again gets the newest.
  while (json::parse(deaf[0]->hear_from(2))["number"] != 60) {
  }
}

TEST_F(FoxgloveServerTest, AFloodEndsItsOwnConnectionOnly) {
  Viewer viewer(connect());
  Viewer flood(connect());
  EXPECT_THROW(
      {
        for (int k = 0; k < 1'000'000; ++k) flood.say(json{{"op", "nonsense"}});
      },
      boost::system::system_error);
  // Another one reads what it is answered.
  Viewer reader(connect());
  EXPECT_THROW(
      {
        for (int k = 0; k < 10'000; ++k) {
          reader.say(json{{"op", "nonsense"}});
          reader.hear();
        }
      },
      boost::system::system_error);
  viewer.say(json{{"op", "getParameters"}, {"parameterNames", json::array()}, {"id", "now"}});
  while (viewer.hear_json()["op"] != "parameterValues") {
  }
  ASSERT_TRUE(comes_true([&] { return cycle(1), server_.clients() == 1; }));
}

TEST_F(FoxgloveServerTest, FloodsOfPingsAndEmptyFramesWaitInTheirOwnLine) {
  // Pings, and a binary message that goes on in empty pieces and never ends.
  for (const Bytes& frame : {Bytes{0x89, 0x80, 1, 2, 3, 4}, Bytes{0x00, 0x80, 1, 2, 3, 4}}) {
    Viewer flood(connect());
    if (frame[0] == 0)
      asio::write(flood.stream.next_layer(), asio::buffer(Bytes{0x02, 0x80, 1, 2, 3, 4}));
    Bytes many;
    for (int k = 0; k < 10'000; ++k) append(many, frame);
    flood.stream.next_layer().non_blocking(true);
    // First what the line itself holds; then what is read of it in a second.
    std::size_t sent = 0;
    for (const auto lasts : {500ms, 1000ms}) {
      sent = 0;
      const auto until = std::chrono::steady_clock::now() + lasts;
      while (std::chrono::steady_clock::now() < until) {
        boost::system::error_code full;
        sent += flood.stream.next_layer().write_some(asio::buffer(many), full);
        if (full) std::this_thread::sleep_for(1ms);
        Bytes answers(100'000);
        flood.stream.next_layer().read_some(asio::buffer(answers), full);
      }
    }
    EXPECT_LT(sent, std::size_t{1} << 20U) << "in a second";
    Viewer viewer(connect());
    EXPECT_EQ(viewer.hear_json()["op"], "serverInfo");
  }
}

TEST_F(FoxgloveServerTest, AGiantMessageEndsItsOwnConnectionOnly) {
  Viewer giant(connect());
  try {
    giant.say(Bytes(std::size_t{4} << 20U));
    while (true) giant.hear();
  } catch (const boost::system::system_error&) {
  }
  // And one that only claims to be giant: FIN, binary, masked, 2^62 bytes.
  Viewer liar(connect());
  const Bytes head{0x82, 0xff, 0x40, 0, 0, 0, 0, 0, 0, 0, 1, 2, 3, 4};
  asio::write(liar.stream.next_layer(), asio::buffer(head));
  try {
    while (true) liar.hear();
  } catch (const boost::system::system_error&) {
  }
  Viewer viewer(connect());
  EXPECT_EQ(viewer.hear_json()["op"], "serverInfo");
}

TEST_F(FoxgloveServerTest, GarbageAndHalfOpenConnectionsKeepNobodyOut) {
  std::deque<tcp::socket> half_open;
  for (int k = 0; k < 100; ++k) {
    half_open.push_back(connect());
    if (k % 2 == 0) asio::write(half_open.back(), asio::buffer("GET / HTTP/1.1\r\nX: ", 20));
  }
  for (const std::string& garbage :
       {std::string(100'000, '\xff'), std::string("\x16\x03\x01\x02", 4),
        "GET / HTTP/1.1\r\n" + std::string(20'000, 'a') + ": b\r\n\r\n"}) {
    tcp::socket socket = connect();
    boost::system::error_code ignored;
    asio::write(socket, asio::buffer(garbage), ignored);
  }
  Viewer viewer(connect());
  EXPECT_EQ(viewer.hear_json()["op"], "serverInfo");
}

TEST_F(FoxgloveServerTest, MoreViewersThanMayAreToldSo) {
  std::vector<std::unique_ptr<Viewer>> viewers;
  for (std::size_t k = 0; k < FoxgloveServer::kMostClients; ++k) {
    viewers.push_back(std::make_unique<Viewer>(connect()));
    viewers.back()->hear_json();
  }
  EXPECT_THROW(Viewer{connect()}, boost::system::system_error);
  viewers.pop_back();
  EXPECT_TRUE(comes_true([&] {
    try {
      Viewer viewer(connect());
      return true;
    } catch (const boost::system::system_error&) {
      return false;
    }
  }));
}

}  // namespace
}  // namespace striate::viewer::foxglove
