#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>

#include "striate/base/user_error.hpp"
#include "striate/viewer/dashboard/assets.hpp"
#include "striate/viewer/dashboard/run_store.hpp"
#include "striate/viewer/dashboard/site.hpp"
#include "striate/viewer/foxglove/access.hpp"
#include "striate/viewer/foxglove/foxglove_server.hpp"

/// What browsers are shown, without a browser; with one it is shown by tests/browser.
namespace striate::viewer::dashboard {
namespace {

using boost::asio::ip::tcp;
using foxglove::AccessRules;
using foxglove::Handshake;
using foxglove::why_page_refused;
using foxglove::why_refused;
using testing::HasSubstr;
using testing::Not;

AccessRules rules_of_a_page() {
  AccessRules rules;
  rules.others = false;
  rules.port = 8780;
  return rules;
}

TEST(DashboardAccess, OnlyThePageOfThisVeryAddressIsLetIn) {
  const AccessRules rules = rules_of_a_page();
  const char* host = "127.0.0.1:8780";
  EXPECT_EQ(why_refused(rules, {"/", host, "http://127.0.0.1:8780", "", ""}), "");
  EXPECT_EQ(why_refused(rules, {"/", host, "", "", ""}), "");  // no browser
  for (const char* origin : {"http://127.0.0.1:8781", "http://localhost:8780", "http://127.0.0.1",
                             "file://", "null", "http://evil.example"}) {
    EXPECT_NE(why_refused(rules, {"/", host, origin, "", ""}), "") << origin;
    EXPECT_NE(why_page_refused(rules, {"/api/what", host, origin, "", ""}), "") << origin;
  }
  // A forwarded port is the same one in both.
  EXPECT_EQ(why_refused(rules, {"/", "localhost:9000", "http://localhost:9000", "", ""}), "");
  EXPECT_NE(why_page_refused(rules, {"/", "evil.example", "", "", ""}), "");
}

TEST(DashboardAccess, OtherPagesMayLinkToItAndNothingElse) {
  const AccessRules rules = rules_of_a_page();
  const auto from = [&](const char* target, const char* site) {
    return why_page_refused(rules, {target, "localhost:8780", "", "", site});
  };
  for (const char* site : {"cross-site", "same-site"}) {
    EXPECT_EQ(from("/", site), "");
    EXPECT_NE(from("/api/what", site), "");
    EXPECT_NE(from("/app.js", site), "");
  }
  for (const char* site : {"same-origin", "none", ""}) EXPECT_EQ(from("/api/what", site), "");
}

TEST(DashboardAccess, ATokenIsGivenOnceAndThenComesInACookie) {
  AccessRules rules = rules_of_a_page();
  rules.listen = "0.0.0.0";
  rules.token = "0123abcd";
  const Handshake first{"/?token=0123abcd", "192.168.1.7:8780", "", "", ""};
  EXPECT_EQ(why_page_refused(rules, first), "");
  EXPECT_EQ(cookie_for(rules, first), "striate_8780=0123abcd; Path=/; HttpOnly; SameSite=Strict");
  EXPECT_EQ(cookie_for(rules, {"/", "192.168.1.7:8780", "", "striate_8780=0123abcd", ""}), "");
  const auto with = [&](const char* cookie, const char* origin = "") {
    return why_page_refused(rules, {"/api/what", "192.168.1.7:8780", origin, cookie, ""});
  };
  EXPECT_EQ(with("a=b; striate_8780=0123abcd"), "");
  for (const char* cookie : {"", "striate_8780=", "striate_8780=0123abc", "striate_8781=0123abcd",
                             "xstriate_8780=0123abcd", "striate_8780=0123abcde"}) {
    EXPECT_NE(with(cookie), "") << cookie;
  }
  // The browser sends it along for pages of others, too.
  rules.others = true;
  const char* cookie = "striate_8780=0123abcd";
  EXPECT_NE(why_refused(rules, {"/", "192.168.1.7:8780", "http://192.168.1.7:80", cookie, ""}), "");
  EXPECT_EQ(why_refused(rules, {"/", "192.168.1.7:8780", "http://192.168.1.7:8780", cookie, ""}),
            "");
}

TEST(DashboardSite, HasThePageInTheProgram) {
  const Site site;
  const HttpAnswer page = site.answer({"GET", "/", "", "", ""});
  EXPECT_EQ(page.status, 200U);
  EXPECT_EQ(page.type, "text/html; charset=utf-8");
  EXPECT_THAT(page.body, HasSubstr("app.js"));
  ASSERT_NE(find_asset("/style.css"), nullptr);
  EXPECT_EQ(site.answer({"GET", "/style.css", "", "", ""}).body, find_asset("/style.css")->bytes);
  for (const char* path : {"/../CMakeLists.txt", "/nothing.js", "//", ""}) {
    EXPECT_EQ(site.answer({"GET", path, "", "", ""}).status, 404U) << path;
  }
}

/// What a name makes in a page is decided in one place, which makes text of it.
TEST(DashboardSite, NoFileOfThePageMakesHtmlOfText) {
  for (const char* path : {"/app.js", "/camera.js", "/cdr.js", "/charts.js", "/dom.js", "/floor.js",
                           "/live.js", "/memory.js", "/recording.js", "/store.js", "/stream.js",
                           "/task.js", "/tree.js", "/trials.js"}) {
    const Asset* asset = find_asset(path);
    ASSERT_NE(asset, nullptr) << path;
    for (const char* word : {"innerHTML", "outerHTML", "insertAdjacentHTML", "document.write",
                             "eval(", "new Function", "createContextualFragment"}) {
      EXPECT_THAT(std::string(asset->bytes), Not(HasSubstr(word))) << path;
    }
  }
}

TEST(DashboardSite, TellsWhatHandlersThrowAndTakesChangesAsJsonOnly) {
  Site site;
  site.on_get("/api/bad",
              [](const HttpRequest&) -> HttpAnswer { throw UserError("no such file"); });
  site.on_get("/api/worse",
              [](const HttpRequest&) -> HttpAnswer { throw std::runtime_error("the disk"); });
  site.on_post("/api/change", [](const HttpRequest& request) {
    return json_answer({{"heard", request.body}});
  });
  EXPECT_EQ(site.answer({"GET", "/api/bad", "", "", ""}).status, 409U);
  EXPECT_EQ(site.answer({"GET", "/api/bad", "", "", ""}).body, R"({"error":"no such file"})");
  EXPECT_EQ(site.answer({"GET", "/api/worse", "", "", ""}).status, 500U);
  EXPECT_EQ(site.answer({"POST", "/api/change", "", "application/json", "{}"}).status, 200U);
  // What a form of any page could send.
  for (const char* type : {"", "text/plain", "application/x-www-form-urlencoded"}) {
    EXPECT_EQ(site.answer({"POST", "/api/change", "", type, "{}"}).status, 415U) << type;
  }
  EXPECT_EQ(site.answer({"GET", "/api/change", "", "", ""}).status, 405U);
  EXPECT_EQ(site.answer({"POST", "/api/bad", "", "application/json", ""}).status, 404U);
  EXPECT_EQ(site.answer({"OPTIONS", "/api/bad", "", "", ""}).status, 405U);
  EXPECT_EQ(json_answer({{"name", "a\xff"}}).body, "{\"name\":\"a\xef\xbf\xbd\"}");
}

TEST(DashboardSite, ReadsWhatStandsBehindTheQuestionMark) {
  EXPECT_EQ(query_value("a=1&name=red%20book&b=", "name"), "red book");
  EXPECT_EQ(query_value("name=red+book", "name"), "red book");
  EXPECT_EQ(query_value("name=%F0%9F%93%95", "name"), "\xf0\x9f\x93\x95");
  for (const char* query : {"", "name", "names=x", "xname=x", "&&", "a=name=x"}) {
    EXPECT_EQ(query_value(query, "name"), "") << query;
  }
  EXPECT_EQ(query_value("name=%", "name"), "%");
  EXPECT_EQ(query_value("name=%2", "name"), "%2");
  EXPECT_EQ(query_value("name=%zz", "name"), "%zz");
}

/// Behind real sockets.
TEST(DashboardServer, ServesThePageWithItsGuardsAndStillTheRobot) {
  foxglove::ServerOptions options;
  options.port = 0;
  options.others = false;
  options.site = std::make_shared<Site>();
  options.site->on_post("/api/echo", [](const HttpRequest& request) {
    return json_answer({{"query", request.query}, {"body", request.body}});
  });
  foxglove::FoxgloveServer server(options, {}, Channels(RobotDescription{}, tasks::Task{}));
  const std::string url = server.page_url();
  EXPECT_THAT(url, HasSubstr("http://127.0.0.1:"));
  const auto port = static_cast<std::uint16_t>(std::stoi(url.substr(url.rfind(':') + 1)));
  const auto ask = [&](const std::string& request) {
    boost::asio::io_context io;
    tcp::socket socket(io);
    socket.connect({boost::asio::ip::make_address("127.0.0.1"), port});
    boost::asio::write(socket, boost::asio::buffer(request));
    std::string answer;
    boost::system::error_code end;
    boost::asio::read(socket, boost::asio::dynamic_buffer(answer), end);
    return answer;
  };
  const std::string page = ask("GET / HTTP/1.1\r\nHost: localhost\r\n\r\n");
  EXPECT_THAT(page, HasSubstr("HTTP/1.1 200"));
  EXPECT_THAT(page, HasSubstr("Content-Security-Policy: default-src 'none'; script-src 'self'"));
  EXPECT_THAT(page, HasSubstr("X-Content-Type-Options: nosniff"));
  EXPECT_THAT(page, HasSubstr("Cross-Origin-Resource-Policy: same-origin"));
  EXPECT_THAT(page, HasSubstr("</html>"));
  EXPECT_THAT(page, Not(HasSubstr("Access-Control-Allow")));
  const std::string head = ask("HEAD / HTTP/1.1\r\nHost: localhost\r\n\r\n");
  EXPECT_THAT(head, HasSubstr("HTTP/1.1 200"));
  EXPECT_THAT(head, Not(HasSubstr("</html>")));
  EXPECT_THAT(ask("POST /api/echo?a=b HTTP/1.1\r\nHost: localhost\r\nContent-Type: "
                  "application/json\r\nContent-Length: 2\r\n\r\n{}"),
              HasSubstr(R"({"query":"a=b","body":"{}"})"));
  EXPECT_THAT(ask("GET / HTTP/1.1\r\nHost: evil.example\r\n\r\n"), HasSubstr("HTTP/1.1 403"));
  // A body that is larger than any change ends its connection without an answer.
  EXPECT_THAT(ask("POST /api/echo HTTP/1.1\r\nHost: localhost\r\nContent-Type: "
                  "application/json\r\nContent-Length: 100000\r\n\r\n"),
              Not(HasSubstr("HTTP/1.1 200")));
}

Bytes bytes_from(const std::string& text) {
  return {text.begin(), text.end()};
}

TopicSet only(Topic topic) {
  return TopicSet().set(static_cast<std::size_t>(topic));
}

TEST(DashboardRunStore, TellsTheNewestAsItWasAtAnyCycle) {
  RunStore store;
  const std::string image(20'000, 'x');  // lies in the file
  store.put(Topic::task, 1, bytes_from("begins"));
  store.put(Topic::left_image, 1, bytes_from(image));
  store.put(Topic::cycle, 1, bytes_from("1"));
  store.end_cycle();
  store.put(Topic::cycle, 2, bytes_from("2"));
  store.end_cycle();
  store.put(Topic::task, 3, bytes_from("ends"));
  store.put(Topic::left_image, 3, bytes_from(std::string(20'000, 'y')));
  store.put(Topic::cycle, 3, bytes_from("3"));
  store.end_cycle();
  EXPECT_EQ(store.cycles(), 3U);
  EXPECT_THAT(store.newest(1, only(Topic::task)), testing::EndsWith("begins"));
  EXPECT_THAT(store.newest(2, only(Topic::task)), testing::EndsWith("ends"));
  EXPECT_EQ(store.newest(1, only(Topic::left_image)).substr(16), image);
  EXPECT_EQ(store.newest(0, only(Topic::odom)), "");
  EXPECT_EQ(store.newest(3, only(Topic::task)), "");
  EXPECT_EQ(store.span(1, 2, only(Topic::cycle)).size(), 2U * 17U);
  EXPECT_EQ(store.span(0, 99, only(Topic::cycle)).size(), 3U * 17U);
  EXPECT_EQ(store.span(2, 1, only(Topic::cycle)), "");
}

TEST(DashboardRunStore, TellsTheFirstCycleInWhichTwoDiffer) {
  RunStore one;
  RunStore other;
  for (const char* said : {"a", "b", "c"}) {
    one.put(Topic::wish, 1, bytes_from(said));
    one.end_cycle();
    other.put(Topic::wish, 1, bytes_from(*said == 'c' ? "x" : said));
    other.end_cycle();
  }
  other.end_cycle();
  EXPECT_EQ(RunStore::first_difference(one, other, Topic::wish), 2U);
  EXPECT_EQ(RunStore::first_difference(one, other, Topic::odom), 3U);  // none in what both have
}

}  // namespace
}  // namespace striate::viewer::dashboard
