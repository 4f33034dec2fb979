#pragma once

#include <string_view>

namespace striate::viewer::dashboard {

/// A file of the page, as it stands in `page/`; compiled into the program (cmake/assets.cmake).
struct Asset {
  std::string_view path;  ///< "/live.js"
  std::string_view type;  ///< "text/javascript; charset=utf-8"
  std::string_view bytes;
};

/// @return nullptr where there is none
[[nodiscard]] const Asset* find_asset(std::string_view path);

}  // namespace striate::viewer::dashboard
