#pragma once

#include <string>
#include <vector>

namespace striate::evaluation {

struct PlotCurve {
  std::string name;
  std::vector<double> x, y;  ///< as many of each
};

/// A line plot as SVG text: axes with round ticks, a grid, a legend.
struct Plot {
  std::string title, x_label, y_label;
  std::vector<PlotCurve> curves;

  [[nodiscard]] std::string svg() const;
};

/// Bars side by side: one group a label, one bar a series.
struct BarPlot {
  std::string title, y_label;
  std::vector<std::string> labels;
  struct Series {
    std::string name;
    std::vector<double> values;  ///< one a label
  };
  std::vector<Series> series;

  [[nodiscard]] std::string svg() const;
};

}  // namespace striate::evaluation
