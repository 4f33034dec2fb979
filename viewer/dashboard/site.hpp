#pragma once

#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

/// What browsers are shown: the dashboard's page, and what it asks for.
namespace striate::viewer::dashboard {

/// What a browser asks for, once it has been let in.
struct HttpRequest {
  std::string method;        ///< "GET"
  std::string path;          ///< "/api/memory", without what stands behind '?'
  std::string query;         ///< "name=red%20book", without the '?'
  std::string content_type;  ///< of the body
  std::string body;
};

struct HttpAnswer {
  unsigned status = 200;
  std::string type = "application/json";
  std::string body;
};

/// "a=1&b=red%20book", "b" -> "red book"; "" where it is not there or is no text of that kind.
[[nodiscard]] std::string query_value(std::string_view query, std::string_view name);

/// One line of JSON; what is not UTF-8 in it is replaced.
[[nodiscard]] HttpAnswer json_answer(const nlohmann::ordered_json& json, unsigned status = 200);
/// {"error": ...}: for the page to show.
[[nodiscard]] HttpAnswer error_answer(unsigned status, const std::string& what);

/// The page's files, and functions for what it asks for. Filled before the server begins; used by
/// the server's thread alone.
class Site {
 public:
  using Handler = std::function<HttpAnswer(const HttpRequest&)>;

  /// Answers GET of that path.
  void on_get(const std::string& path, Handler handler);
  /// Answers POST of that path: what changes something. Its body is JSON.
  void on_post(const std::string& path, Handler handler);
  /// What a handler throws is told: a UserError with status 409, everything else with 500.
  [[nodiscard]] HttpAnswer answer(const HttpRequest& request) const;

 private:
  std::map<std::string, Handler> gets_;
  std::map<std::string, Handler> posts_;
};

}  // namespace striate::viewer::dashboard
