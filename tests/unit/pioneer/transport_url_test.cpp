#include "striate/platform/pioneer/transport_url.hpp"

#include <gtest/gtest.h>

#include "striate/base/user_error.hpp"

namespace striate::pioneer {
namespace {

TEST(TransportUrl, TellsTcpFromSerial) {
  const TransportUrl tcp = parse_transport_url("tcp://robot.local:8102");
  EXPECT_EQ(tcp.kind, TransportUrl::Kind::tcp);
  EXPECT_EQ(tcp.host, "robot.local");
  EXPECT_EQ(tcp.port, 8102);
  EXPECT_EQ(parse_transport_url("tcp://localhost").port, 8101);
  const TransportUrl serial = parse_transport_url("serial:/dev/ttyUSB0?baud=38400");
  EXPECT_EQ(serial.kind, TransportUrl::Kind::serial);
  EXPECT_EQ(serial.device, "/dev/ttyUSB0");
  EXPECT_EQ(serial.baud, 38400);
  EXPECT_EQ(parse_transport_url("pty:/dev/pts/3").kind, TransportUrl::Kind::serial);
}

TEST(TransportUrl, RefusesEverythingElse) {
  for (const char* text :
       {"", "tcp://", "tcp://:8101", "tcp://h:0", "tcp://h:70000", "tcp://h:x", "serial:ttyUSB0",
        "serial:/dev/ttyS0?baud=1200", "serial:/dev/a?x=1", "http://h", "/dev/ttyS0"}) {
    EXPECT_THROW((void)parse_transport_url(text), UserError) << text;
  }
}

}  // namespace
}  // namespace striate::pioneer
