#pragma once

#include <optional>
#include <string>
#include <vector>

#include "striate/config/diagnostics.hpp"
#include "striate/config/node.hpp"

namespace striate::datasets {

/// What another program wrote, as a tree with places: YAML, the JSON that is YAML, OpenCV's
/// FileStorage (its directive, its tags) and XML, told apart by the text. A mark of byte order and
/// line ends of Windows change nothing; of several documents the first counts. In XML an element
/// with elements inside is a map, whose keys may repeat; any other is a scalar. Adds a mistake
/// where the text is none of them.
[[nodiscard]] config::Node read_tree(const std::string& text, config::Diagnostics& diagnostics);

/// The text without a mark of byte order, with \n alone at the ends of lines.
[[nodiscard]] std::string plain_line_ends(const std::string& text);

/// A number as programs write it: 1., -.5, 1e-3, +2; nothing for any other text, for infinity and
/// for what is no number.
[[nodiscard]] std::optional<double> number_of(std::string_view text);

/// All numbers of a value, row by row: of a list, of lists of lists, of a text of numbers between
/// blanks or commas, of an OpenCV or ROS matrix (its `data`), of an XML element's elements. Adds a
/// mistake at the first that is none. @param what it is, for the message
[[nodiscard]] std::vector<double> numbers_of(const config::Node& node, const std::string& what,
                                             config::Diagnostics& diagnostics);

/// The value of the first of these keys that is there; nullptr: none.
[[nodiscard]] const config::Node* first_of(const config::Node& map,
                                           const std::vector<std::string>& keys);

/// The keys of a map in their order, at most `most`, for a message.
[[nodiscard]] std::string keys_of(const config::Node& map, std::size_t most = 8);

}  // namespace striate::datasets
