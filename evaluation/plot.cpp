#include "striate/evaluation/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace striate::evaluation {
namespace {

constexpr double kWidth = 860.0, kHeight = 520.0;  // px of a plot: it fits into a README
/// px around the plot: numbers, legend, title, axis
constexpr double kLeft = 70.0, kRight = 230.0, kTop = 48.0, kBottom = 60.0;
/// Told apart by most who see colours badly, too (ours)
constexpr const char* kColours[] = {"#0b62a4", "#d1495b", "#2e8b57", "#e08e0b",
                                    "#7b4ea3", "#4d4d4d", "#17a2b8", "#a0522d"};

const char* colour(std::size_t index) {
  return kColours[index % std::size(kColours)];
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    result += c == '<' ? std::string("&lt;") : c == '&' ? std::string("&amp;") : std::string(1, c);
  }
  return result;
}

/// A scale of round numbers that covers what is shown.
struct Axis {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  double step = 1.0;

  void cover(double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  void round() {
    if (!(low <= high)) low = 0.0, high = 1.0;
    if (high - low < 1e-12) high = low + 1.0;
    const double raw = (high - low) / 6.0;
    const double power = std::pow(10.0, std::floor(std::log10(raw)));
    const double ratio = raw / power;
    step = power * (ratio <= 1.0 ? 1.0 : ratio <= 2.0 ? 2.0 : ratio <= 5.0 ? 5.0 : 10.0);
    low = std::floor(low / step + 1e-9) * step;
    high = std::ceil(high / step - 1e-9) * step;
  }
  [[nodiscard]] int ticks() const { return static_cast<int>(std::lround((high - low) / step)); }
  [[nodiscard]] double share(double value) const { return (value - low) / (high - low); }
};

double at_x(double share) {
  return kLeft + share * (kWidth - kLeft - kRight);
}
double at_y(double share) {
  return kHeight - kBottom - share * (kHeight - kTop - kBottom);
}

std::string text_at(double x, double y, const std::string& anchor, const std::string& text) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor,
                     escaped(text));
}

std::string begin(const std::string& title, const std::string& y_label) {
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
      "font-family=\"sans-serif\" font-size=\"13\">\n"
      "<rect width=\"{0:.0f}\" height=\"{1:.0f}\" fill=\"white\"/>\n",
      kWidth, kHeight);
  svg +=
      fmt::format("<text x=\"{:.1f}\" y=\"26\" font-size=\"16\" font-weight=\"bold\">{}</text>\n",
                  kLeft, escaped(title));
  svg += fmt::format(
      "<text transform=\"translate(18 {:.1f}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
      at_y(0.5), escaped(y_label));
  return svg;
}

std::string horizontal_grid(const Axis& y) {
  std::string svg;
  for (int k = 0; k <= y.ticks(); ++k) {
    const double value = y.low + k * y.step;
    const double at = at_y(y.share(value));
    svg += fmt::format("<path d=\"M{:.1f} {:.1f}H{:.1f}\" stroke=\"#dddddd\"/>\n", kLeft, at,
                       kWidth - kRight);
    svg += text_at(kLeft - 6, at + 4, "end", fmt::format("{:.6g}", value));
  }
  return svg;
}

std::string legend(std::size_t index, const std::string& name) {
  const double y = kTop + 12 + 20.0 * static_cast<double>(index);
  return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"14\" height=\"10\" fill=\"{}\"/>\n",
                     kWidth - kRight + 14, y - 9, colour(index)) +
         text_at(kWidth - kRight + 34, y, "start", name);
}

}  // namespace

std::string Plot::svg() const {
  Axis x_axis, y_axis;
  for (const PlotCurve& curve : curves) {
    for (const double value : curve.x) x_axis.cover(value);
    for (const double value : curve.y) y_axis.cover(value);
  }
  x_axis.round();
  y_axis.round();
  std::string svg = begin(title, y_label) + horizontal_grid(y_axis);
  for (int k = 0; k <= x_axis.ticks(); ++k) {
    const double value = x_axis.low + k * x_axis.step;
    const double at = at_x(x_axis.share(value));
    svg += fmt::format("<path d=\"M{:.1f} {:.1f}V{:.1f}\" stroke=\"#dddddd\"/>\n", at, kTop,
                       kHeight - kBottom);
    svg += text_at(at, kHeight - kBottom + 18, "middle", fmt::format("{:.6g}", value));
  }
  svg += text_at(at_x(0.5), kHeight - 14, "middle", x_label);
  for (std::size_t c = 0; c < curves.size(); ++c) {
    std::string points;
    for (std::size_t k = 0; k < curves[c].x.size(); ++k) {
      points += fmt::format("{:.1f},{:.1f} ", at_x(x_axis.share(curves[c].x[k])),
                            at_y(y_axis.share(curves[c].y[k])));
    }
    svg += fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"/>\n",
                       points, colour(c));
    svg += legend(c, curves[c].name);
  }
  return svg + "</svg>\n";
}

std::string BarPlot::svg() const {
  Axis y_axis;
  y_axis.cover(0.0);
  for (const Series& one : series) {
    for (const double value : one.values) y_axis.cover(value);
  }
  y_axis.round();
  std::string svg = begin(title, y_label) + horizontal_grid(y_axis);
  const double group = 1.0 / static_cast<double>(std::max<std::size_t>(1, labels.size()));
  const double bar = 0.8 * group / static_cast<double>(std::max<std::size_t>(1, series.size()));
  for (std::size_t k = 0; k < labels.size(); ++k) {
    const double from = group * (static_cast<double>(k) + 0.1);
    svg += text_at(at_x(group * (static_cast<double>(k) + 0.5)), kHeight - kBottom + 18, "middle",
                   labels[k]);
    for (std::size_t s = 0; s < series.size(); ++s) {
      const double x = at_x(from + bar * static_cast<double>(s));
      const double y = at_y(y_axis.share(series[s].values[k]));
      svg += fmt::format(
          "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\"/>\n", x,
          y, at_x(bar) - at_x(0.0), at_y(y_axis.share(0.0)) - y, colour(s));
    }
  }
  for (std::size_t s = 0; s < series.size(); ++s) svg += legend(s, series[s].name);
  return svg + "</svg>\n";
}

}  // namespace striate::evaluation
