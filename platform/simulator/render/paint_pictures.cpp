#include "striate/platform/simulator/render/paint.hpp"
#include "striate/platform/simulator/render/paint_brush.hpp"

namespace striate::simulator::render {
namespace {

cv::Mat3b poster_fish() {
  cv::Mat3b p = sheet(512, 768, Scalar(170, 110, 30));
  Brush brush(p, 1);
  for (int i = 0; i < 60; ++i)
    cv::circle(p, brush.place(), brush.draw(3, 16), Scalar(210, 170, 90), 2, cv::LINE_AA);
  for (int i = 0; i < 9; ++i) {
    const Point at = brush.place();
    const int size = brush.draw(34, 95);
    const Scalar body = brush.colour();
    const Point tail[3] = {{at.x - size, at.y},
                           {at.x - size - size / 2, at.y - size / 2},
                           {at.x - size - size / 2, at.y + size / 2}};
    cv::fillConvexPoly(p, tail, 3, brush.colour(), cv::LINE_AA);
    cv::ellipse(p, at, {size, size / 2}, 0, 0, 360, body, cv::FILLED, cv::LINE_AA);
    for (int k = -2; k < 2; ++k)
      cv::line(p, {at.x + k * size / 4, at.y - size / 3}, {at.x + k * size / 4, at.y + size / 3},
               brush.colour(), 4, cv::LINE_AA);
    cv::circle(p, {at.x + size * 2 / 3, at.y - size / 8}, size / 9, Scalar(250, 250, 250),
               cv::FILLED, cv::LINE_AA);
    cv::circle(p, {at.x + size * 2 / 3, at.y - size / 8}, size / 18, Scalar(10, 10, 10), cv::FILLED,
               cv::LINE_AA);
  }
  brush.write("THE REEF", {70, 90}, 2.4, Scalar(240, 240, 250), 4);
  return p;
}

cv::Mat3b poster_map() {
  cv::Mat3b p = sheet(512, 768, Scalar(200, 190, 150));
  const FractalNoise height({4, 5, 0.55F}, 5);
  for (int y = 0; y < p.rows; ++y) {
    for (int x = 0; x < p.cols; ++x) {
      const float h = height(static_cast<float>(x) / 768.0F, static_cast<float>(y) / 768.0F);
      if (h > 0.02F) p(y, x) = cv::Vec3b(90, 170, 130);
      if (h > 0.2F) p(y, x) = cv::Vec3b(90, 190, 210);
      if (h > 0.35F) p(y, x) = cv::Vec3b(110, 140, 170);
      if (std::abs(h) < 0.015F) p(y, x) = cv::Vec3b(60, 50, 40);
    }
  }
  Brush brush(p, 2);
  for (int i = 0; i < 14; ++i)
    cv::line(p, brush.place(), brush.place(), Scalar(40, 40, 190), 2, cv::LINE_AA);
  for (int i = 0; i < 20; ++i) {
    const Point at = brush.place();
    cv::circle(p, at, 6, Scalar(20, 20, 20), cv::FILLED, cv::LINE_AA);
    brush.lines_of_text({at.x + 10, at.y, 60, 2}, 8, Scalar(20, 20, 20));
  }
  cv::rectangle(p, {0, 0, 512, 768}, Scalar(40, 60, 80), 14);
  return p;
}

cv::Mat3b poster_notice() {
  cv::Mat3b p = sheet(512, 768, Scalar(40, 190, 230));
  Brush brush(p, 3);
  brush.write("NOTICE", {40, 130}, 3.6, Scalar(20, 20, 30), 8);
  brush.write("room 214", {60, 210}, 2.0, Scalar(30, 30, 150), 4);
  brush.lines_of_text({40, 260, 430, 300}, 22, Scalar(30, 40, 50));
  cv::circle(p, {380, 650}, 80, Scalar(60, 60, 200), cv::FILLED, cv::LINE_AA);
  brush.barcode({40, 620, 200, 90});
  return p;
}

cv::Mat3b poster_art() {
  cv::Mat3b p = sheet(512, 768, Scalar(210, 225, 235));
  Brush brush(p, 4);
  for (int i = 0; i < 70; ++i) {
    const Point at = brush.place();
    const int size = brush.draw(12, 90);
    const float kind = brush.draw();
    if (kind < 0.35F)
      cv::circle(p, at, size, brush.colour(), cv::FILLED, cv::LINE_AA);
    else if (kind < 0.7F)
      cv::rectangle(p, {at.x, at.y, size, brush.draw(10, 120)}, brush.colour(), cv::FILLED);
    else
      cv::line(p, at, brush.place(), brush.colour(), brush.draw(2, 10), cv::LINE_AA);
  }
  return p;
}

cv::Mat3b poster_timetable() {
  cv::Mat3b p = sheet(512, 768, Scalar(235, 235, 235));
  Brush brush(p, 5);
  cv::rectangle(p, {0, 0, 512, 110}, Scalar(130, 60, 30), cv::FILLED);
  brush.write("LECTURES", {60, 78}, 2.0, Scalar(240, 240, 240), 4);
  for (int y = 130; y < 760; y += 52) cv::line(p, {20, y}, {492, y}, Scalar(90, 90, 90), 2);
  for (int x = 20; x < 512; x += 94) cv::line(p, {x, 130}, {x, 750}, Scalar(90, 90, 90), 2);
  for (int y = 140; y < 730; y += 52) {
    for (int x = 26; x < 480; x += 94) {
      if (brush.draw() < 0.5F)
        cv::rectangle(p, {x, y, 80, 36}, brush.colour(), cv::FILLED);
      else
        brush.lines_of_text({x, y + 8, 80, 30}, 12, Scalar(50, 50, 50));
    }
  }
  return p;
}

cv::Mat3b poster_landscape() {
  cv::Mat3b p = sheet(768, 512, Scalar(0, 0, 0));
  std::vector<FractalNoise> ridge_noise;
  for (int k = 0; k < 4; ++k) {
    ridge_noise.push_back({{3 + 2 * k, 5, 0.5F}, 60U + static_cast<unsigned>(k)});
  }
  const FractalNoise grain_noise({40, 3, 0.7F}, 70U);
  for (int x = 0; x < p.cols; ++x) {
    const float u = static_cast<float>(x) / 768.0F;
    std::array<float, 4> ridges{};
    for (std::size_t k = 0; k < ridges.size(); ++k) {
      ridges[k] = 0.3F + 0.15F * static_cast<float>(k) + 0.13F * ridge_noise[k](u, 0.5F);
    }
    for (int y = 0; y < p.rows; ++y) {
      const float v = static_cast<float>(y) / 512.0F;
      cv::Vec3f c(235 - 90 * v, 190 + 10 * v, 130 + 100 * v);
      const float grain = 26.0F * grain_noise(u, v);
      for (int k = 0; k < 4; ++k) {
        if (v > ridges[static_cast<std::size_t>(k)])
          c = cv::Vec3f(120.0F - 28.0F * static_cast<float>(k) + grain,
                        130.0F - 14.0F * static_cast<float>(k) + grain,
                        100.0F - 20.0F * static_cast<float>(k) + grain);
      }
      p(y, x) =
          cv::Vec3b(cv::saturate_cast<std::uint8_t>(c[0]), cv::saturate_cast<std::uint8_t>(c[1]),
                    cv::saturate_cast<std::uint8_t>(c[2]));
    }
  }
  return p;
}

cv::Mat3b poster_plate() {
  cv::Mat3b p = sheet(128, 96, Scalar(228, 230, 230));
  Brush brush(p, 6);
  brush.write("2.14", {14, 44}, 1.2, Scalar(40, 40, 40), 2);
  brush.lines_of_text({14, 62, 100, 24}, 11, Scalar(60, 60, 60));
  return p;
}

}  // namespace

const std::vector<Picture>& posters() {
  static const std::vector<Picture> all{
      {"poster_fish", poster_fish},           {"poster_map", poster_map},
      {"poster_notice", poster_notice},       {"poster_art", poster_art},
      {"poster_timetable", poster_timetable}, {"poster_landscape", poster_landscape},
      {"poster_plate", poster_plate},
  };
  return all;
}

}  // namespace striate::simulator::render
