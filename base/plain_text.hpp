#pragma once

#include <string>
#include <string_view>

namespace striate {

/// Text that a terminal, a table and an XML file show as it is: UTF-8 without control characters
/// (those of C1 too), line and paragraph separators, and marks that turn the direction of writing.
[[nodiscard]] bool is_plain_text(std::string_view text);

/// The same text where it is plain; else what is not plain in it is written out: a byte that is no
/// UTF-8 as `\xFF`, a control character as `\u202E`. Different texts stay different but for those
/// that contain such a sequence already.
[[nodiscard]] std::string plain_text(std::string_view text);

/// The same, where line breaks and tabs may stay.
[[nodiscard]] std::string plain_lines(std::string_view text);

/// Plain text as XML and SVG want it.
[[nodiscard]] std::string xml_text(std::string_view text);

/// A cell of a CSV file (RFC 4180): plain text, in quotes where it holds a comma or a quote.
[[nodiscard]] std::string csv_cell(std::string_view text);

}  // namespace striate
