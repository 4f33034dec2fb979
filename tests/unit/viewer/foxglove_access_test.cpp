#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "striate/viewer/foxglove/access.hpp"

/// Who is let in to look at the robot.
namespace striate::viewer::foxglove {
namespace {

using testing::HasSubstr;

bool may(const Handshake& handshake, const AccessRules& rules = {}) {
  return why_refused(rules, handshake).empty();
}

TEST(FoxgloveAccess, ProgramsOfThisMachineMayLook) {
  for (const char* host : {"localhost", "localhost:8765", "LOCALHOST:1", "127.0.0.1:8765",
                           "127.9.9.9", "[::1]:8765", "[::1]"}) {
    EXPECT_TRUE(may({"/", host, "", "", ""})) << host;
  }
}

TEST(FoxgloveAccess, ANameThatWasMadeToPointHereIsRefused) {
  for (const char* host : {"evil.example:8765", "localhost.evil.example", "127.0.0.1.evil.example",
                           "", "[::1", "localhost:8765@evil.example", "192.168.1.7", "[::2]:1"}) {
    EXPECT_FALSE(may({"/", host, "", "", ""})) << host;
  }
}

TEST(FoxgloveAccess, PagesOfThisMachineAndDesktopProgramsMayLookAndOthersNot) {
  for (const char* origin : {"http://localhost:8080", "https://127.0.0.1", "file://"}) {
    EXPECT_TRUE(may({"/", "localhost:8765", origin, "", ""})) << origin;
  }
  for (const char* origin :
       {"https://evil.example", "http://localhost.evil.example", "null", "https://",
        "https://app.foxglove.dev", "file:///etc", "http://localhost:80@evil.example", "x"}) {
    EXPECT_FALSE(may({"/", "localhost:8765", origin, "", ""})) << origin;
  }
  AccessRules rules;
  rules.more_origins = {"https://app.foxglove.dev"};
  EXPECT_TRUE(may({"/", "localhost", "https://app.foxglove.dev", "", ""}, rules));
  EXPECT_FALSE(may({"/", "localhost", "https://app.foxglove.dev.evil.example", "", ""}, rules));
}

TEST(FoxgloveAccess, BeyondLoopbackATokenIsNeeded) {
  AccessRules rules;
  rules.listen = "0.0.0.0";
  rules.token = "0123abcd";
  EXPECT_TRUE(may({"/?token=0123abcd", "192.168.1.7:8765", "", "", ""}, rules));
  EXPECT_TRUE(may({"/?a=b&token=0123abcd&c", "[fe80::1]:8765", "", "", ""}, rules));
  for (const char* target : {"/", "/?token=", "/?token=0123abc", "/?token=0123abcde",
                             "/?xtoken=0123abcd", "/0123abcd", "/?token=0123ABCD"}) {
    EXPECT_FALSE(may({target, "192.168.1.7:8765", "", "", ""}, rules)) << target;
  }
  EXPECT_FALSE(may({"/?token=0123abcd", "evil.example", "", "", ""}, rules));
  EXPECT_NE(new_token(), new_token());
  EXPECT_EQ(new_token().size(), 32U);
}

}  // namespace
}  // namespace striate::viewer::foxglove
