#pragma once

namespace striate::config {

/// What is wrong with a file, as a number that messages of task scripts show: error[T014]. Numbers
/// below 20 are of every file; the layer that reads a kind of file has its own above
/// (tasks/fault.hpp). A number never changes its meaning.
struct Fault {
  int number = 0;
};

namespace fault {
inline constexpr Fault other{0};
inline constexpr Fault unreadable{1};     ///< no such file, no text, not YAML, too large
inline constexpr Fault not_allowed{2};    ///< anchors, aliases, tags, several documents, too deep
inline constexpr Fault duplicate_key{3};  ///< the YAML library would keep the last in silence
inline constexpr Fault unknown_key{10};
inline constexpr Fault missing_key{11};
inline constexpr Fault wrong_kind{12};  ///< a list where a map is wanted, and so on
inline constexpr Fault no_number{13};   ///< text, 010, 0x10, NaN
inline constexpr Fault no_unit{14};
inline constexpr Fault wrong_unit{15};
inline constexpr Fault out_of_range{16};
inline constexpr Fault unknown_choice{17};  ///< none of the words that are allowed
}  // namespace fault

}  // namespace striate::config
