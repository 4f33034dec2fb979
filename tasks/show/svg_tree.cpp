#include <fmt/format.h>

#include <algorithm>

#include "striate/base/plain_text.hpp"
#include "striate/tasks/show/outline.hpp"

namespace striate::tasks {
namespace {

// By hand, px of the drawing: a row of 12 px letters with room above and below, its box, the step
// of a depth, the edge; and the width of a monospaced letter of 12 px.
constexpr int kRow_px = 34;
constexpr int kBox_px = 26;
constexpr int kIndent_px = 30;
constexpr int kMargin_px = 12;
constexpr double kLetter_px = 7.3;  // of the monospaced 12 px letters: 0.6 em and a little

const char* colour_of(Outline::Kind kind) {
  switch (kind) {
    case Outline::Kind::action:
      return "#dcecf8";
    case Outline::Kind::always:
    case Outline::Kind::guard:
      return "#fbe3c4";
    case Outline::Kind::finally:
      return "#e3e3e3";
    case Outline::Kind::recovery:
      return "#f8dcdc";
    case Outline::Kind::use:
    case Outline::Kind::task:
      return "#e6def4";
    default:
      break;
  }
  return "#def0dc";
}

/// One row a node, indented by its depth, joined to its parent by an elbow.
class Drawing {
 public:
  void draw(const Outline& node, int depth, int parent_row) {
    const int row = rows_++;
    const int x = kMargin_px + depth * kIndent_px;
    const int y = kMargin_px + row * kRow_px;
    const std::string title = title_of(node);
    const std::string limits = limits_of(node);
    const int box_px = 20 + static_cast<int>(kLetter_px * static_cast<double>(title.size()));
    if (parent_row >= 0) elbow(x, y, parent_row);
    body_ += fmt::format(
        "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" rx=\"5\" fill=\"{}\" "
        "stroke=\"#555\"/>\n",
        x, y, box_px, kBox_px, colour_of(node.kind));
    text(x + 10, y, title, "#000");
    if (!limits.empty()) text(x + box_px + 10, y, limits, "#666");
    const double end = x + box_px + 20 + kLetter_px * static_cast<double>(limits.size());
    width_ = std::max(width_, static_cast<int>(end) + kMargin_px);
    for (const Outline& child : node.children) draw(child, depth + 1, row);
  }

  [[nodiscard]] std::string file() const {
    const int height = 2 * kMargin_px + rows_ * kRow_px;
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
        "viewBox=\"0 0 {0} {1}\" font-family=\"monospace\" font-size=\"12\">\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n{2}</svg>\n",
        width_, height, body_);
  }

 private:
  void elbow(int x, int y, int parent_row) {
    const int down_x = x - kIndent_px + 12;
    const int from_y = kMargin_px + parent_row * kRow_px + kBox_px;
    body_ += fmt::format("<path d=\"M{} {} V{} H{}\" fill=\"none\" stroke=\"#999\"/>\n", down_x,
                         from_y, y + kBox_px / 2, x);
  }
  void text(int x, int y, const std::string& words, const char* colour) {
    body_ += fmt::format("<text x=\"{}\" y=\"{}\" fill=\"{}\">{}</text>\n", x, y + 17, colour,
                         xml_text(words));
  }

  std::string body_;
  int rows_ = 0;
  int width_ = 0;
};

}  // namespace

std::string svg_tree(const Outline& task) {
  Drawing drawing;
  drawing.draw(task, 0, -1);
  return drawing.file();
}

}  // namespace striate::tasks
