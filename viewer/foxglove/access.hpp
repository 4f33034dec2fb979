#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// Who may look at a running robot.
namespace striate::viewer::foxglove {

/// By what a handshake is judged.
struct AccessRules {
  std::string listen = "127.0.0.1";       ///< the address that is listened on
  std::string token;                      ///< "": none is needed, as on loopback
  std::vector<std::string> more_origins;  ///< "https://app.foxglove.dev"
  /// Viewers of others are welcome; else a page must be our own.
  bool others = true;
  std::uint16_t port = 0;  ///< that is listened on; names the cookie
};

/// What a client says of itself before anything is said to it; "" where it says nothing.
struct Handshake {
  std::string_view target;  ///< "/?token=..."
  std::string_view host;
  std::string_view origin;      ///< only browsers send one
  std::string_view cookie;      ///< "striate_8780=..."
  std::string_view fetch_site;  ///< Sec-Fetch-Site: from where a browser asks, "same-origin"
};

/// Why it is refused; "": it may come in. A browser's page may come from this machine or the
/// address that is listened on, from a file (the desktop programs of Foxglove and Lichtblick), or
/// from an origin that the user has named. "null" is any page's, in a frame of its making.
[[nodiscard]] std::string why_refused(const AccessRules& rules, const Handshake& handshake);

/// The same for what a browser asks over HTTP. Only our own page may ask, and the address bar;
/// pages of all others may link to "/", which tells nothing before it is opened.
[[nodiscard]] std::string why_page_refused(const AccessRules& rules, const Handshake& handshake);

/// "striate_8780=...; ..." for the browser that has come with the right token in the address, so
/// that what the page asks for needs none there; "": no cookie.
[[nodiscard]] std::string cookie_for(const AccessRules& rules, const Handshake& handshake);

/// 127.0.0.0/8, ::1 or localhost
[[nodiscard]] bool is_loopback(std::string_view host);

/// 128 bits of the kernel's randomness, in hexadecimal. @throws std::runtime_error without
[[nodiscard]] std::string new_token();

}  // namespace striate::viewer::foxglove
