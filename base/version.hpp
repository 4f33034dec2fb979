#pragma once

namespace striate {

/// Of the headers that a file was compiled with. The same as in the root CMakeLists.txt, which a
/// test sees to.
inline constexpr const char* kVersion = "0.1.0";

}  // namespace striate
