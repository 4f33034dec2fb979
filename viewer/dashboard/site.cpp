#include "striate/viewer/dashboard/site.hpp"

#include <fmt/format.h>

#include <charconv>
#include <exception>

#include "striate/base/user_error.hpp"
#include "striate/viewer/dashboard/assets.hpp"

namespace striate::viewer::dashboard {
namespace {

/// "red%20book" -> "red book"
std::string without_escapes(std::string_view text) {
  std::string plain;
  for (std::size_t k = 0; k < text.size(); ++k) {
    unsigned value = 0;
    const char* digits = text.data() + k + 1;
    if (text[k] == '%' && k + 2 < text.size() &&
        std::from_chars(digits, digits + 2, value, 16).ptr == digits + 2) {
      plain += static_cast<char>(value);
      k += 2;
    } else {
      plain += text[k] == '+' ? ' ' : text[k];
    }
  }
  return plain;
}

HttpAnswer asset_answer(const HttpRequest& request) {
  const Asset* asset = find_asset(request.path == "/" ? "/index.html" : request.path);
  if (asset == nullptr) {
    return error_answer(404, fmt::format("there is no '{}' here", request.path));
  }
  return {200, std::string(asset->type), std::string(asset->bytes)};
}

}  // namespace

std::string query_value(std::string_view query, std::string_view name) {
  while (!query.empty()) {
    const std::size_t end = std::min(query.find('&'), query.size());
    const std::string_view pair = query.substr(0, end);
    if (pair.substr(0, name.size()) == name && pair.size() > name.size() &&
        pair[name.size()] == '=') {
      return without_escapes(pair.substr(name.size() + 1));
    }
    query.remove_prefix(std::min(end + 1, query.size()));
  }
  return {};
}

HttpAnswer json_answer(const nlohmann::ordered_json& json, unsigned status) {
  using Json = nlohmann::ordered_json;
  return {status, "application/json", json.dump(-1, ' ', false, Json::error_handler_t::replace)};
}

HttpAnswer error_answer(unsigned status, const std::string& what) {
  return json_answer({{"error", what}}, status);
}

void Site::on_get(const std::string& path, Handler handler) {
  gets_[path] = std::move(handler);
}

void Site::on_post(const std::string& path, Handler handler) {
  posts_[path] = std::move(handler);
}

HttpAnswer Site::answer(const HttpRequest& request) const {
  const bool changes = request.method == "POST";
  if (!changes && request.method != "GET" && request.method != "HEAD") {
    return error_answer(405, "GET and POST are understood");
  }
  const auto& handlers = changes ? posts_ : gets_;
  const auto found = handlers.find(request.path);
  try {
    if (found != handlers.end()) {
      // Any page may send a form; only pages of this address may send this.
      if (changes && request.content_type.substr(0, 16) != "application/json") {
        return error_answer(415, "changes come as application/json");
      }
      return found->second(request);
    }
    if (changes || gets_.count(request.path) + posts_.count(request.path) > 0) {
      return error_answer(changes ? 404 : 405, "that cannot be asked here");
    }
    return asset_answer(request);
  } catch (const UserError& error) {
    return error_answer(409, error.what());
  } catch (const std::exception& error) {
    return error_answer(500, error.what());
  }
}

}  // namespace striate::viewer::dashboard
