#include <opencv2/imgproc.hpp>

#include "platform/simulator/render/noise.hpp"
#include "platform/simulator/render/paint.hpp"

namespace striate::simulator::render {
namespace {

using cv::Point;
using cv::Scalar;

/// Draws random shapes whose kind, place and colour come from a counter.
class Brush {
 public:
  Brush(cv::Mat3b& picture, std::uint32_t seed) : picture_(picture), seed_(seed) {}
  float draw() { return uniform(mix(seed_, counter_++)); }
  int draw(int low, int high) {
    return low + static_cast<int>(draw() * static_cast<float>(high - low));
  }
  Point place() { return {draw(0, picture_.cols), draw(0, picture_.rows)}; }
  Scalar colour() { return Scalar(draw(20, 240), draw(20, 240), draw(20, 240)); }

  void write(const std::string& text, Point at, double size, const Scalar& ink, int thick = 2) {
    cv::putText(picture_, text, at, cv::FONT_HERSHEY_DUPLEX, size, ink, thick, cv::LINE_AA);
  }
  void lines_of_text(cv::Rect where, int step, const Scalar& ink) {
    for (int y = where.y; y < where.y + where.height; y += step) {
      int x = where.x;
      while (x < where.x + where.width - step) {
        const int word = draw(step / 2, step * 3);
        const int end = std::min(x + word, where.x + where.width);
        cv::line(picture_, {x, y}, {end, y}, ink, std::max(1, step / 3));
        x += word + step / 2;
      }
    }
  }
  void barcode(cv::Rect where) {
    cv::rectangle(picture_, where, Scalar(235, 235, 235), cv::FILLED);
    for (int x = where.x + 4; x < where.x + where.width - 6;) {
      const int wide = draw(1, 5);
      cv::rectangle(picture_, {x, where.y + 4, wide, where.height - 8}, Scalar(25, 25, 25),
                    cv::FILLED);
      x += wide + draw(2, 6);
    }
  }

 private:
  cv::Mat3b& picture_;
  std::uint32_t seed_;
  std::uint32_t counter_ = 0;
};

cv::Mat3b sheet(int width, int height, const Scalar& ground) {
  return cv::Mat3b(height, width,
                   cv::Vec3b(cv::saturate_cast<std::uint8_t>(ground[0]),
                             cv::saturate_cast<std::uint8_t>(ground[1]),
                             cv::saturate_cast<std::uint8_t>(ground[2])));
}

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
  for (int y = 0; y < p.rows; ++y) {
    for (int x = 0; x < p.cols; ++x) {
      const float h = fractal_noise(static_cast<float>(x) / 768.0F, static_cast<float>(y) / 768.0F,
                                    {4, 5, 0.55F}, 5);
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
  for (int x = 0; x < p.cols; ++x) {
    const float u = static_cast<float>(x) / 768.0F;
    for (int y = 0; y < p.rows; ++y) {
      const float v = static_cast<float>(y) / 512.0F;
      cv::Vec3f c(235 - 90 * v, 190 + 10 * v, 130 + 100 * v);
      for (int k = 0; k < 4; ++k) {
        const float ridge =
            0.3F + 0.15F * static_cast<float>(k) +
            0.13F * fractal_noise(u, 0.5F, {3 + 2 * k, 5, 0.5F}, 60U + static_cast<unsigned>(k));
        const float grain = 26.0F * fractal_noise(u, v, {40, 3, 0.7F}, 70U);
        if (v > ridge)
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

cv::Mat3b cover(const Scalar& ground, const Scalar& ink, const char* title, std::uint32_t seed) {
  cv::Mat3b p = sheet(256, 384, ground);
  Brush brush(p, seed);
  for (int i = 0; i < 14; ++i) {
    const Point at{brush.draw(30, 226), brush.draw(150, 310)};
    if (brush.draw() < 0.5F)
      cv::circle(p, at, brush.draw(6, 34), brush.colour(), cv::FILLED, cv::LINE_AA);
    else
      cv::rectangle(p, {at.x, at.y, brush.draw(8, 50), brush.draw(8, 40)}, brush.colour(),
                    cv::FILLED);
  }
  brush.write(title, {18, 66}, 1.35, ink, 3);
  brush.lines_of_text({20, 92, 210, 26}, 12, ink);
  brush.lines_of_text({20, 345, 150, 20}, 12, ink);
  cv::rectangle(p, {0, 0, 14, 384}, ink * 0.6, cv::FILLED);
  return p;
}
cv::Mat3b book_red() {
  return cover(Scalar(40, 36, 178), Scalar(225, 235, 240), "CORTEX", 11);
}
cv::Mat3b book_blue() {
  return cover(Scalar(160, 84, 36), Scalar(90, 220, 240), "ROBOTS", 12);
}
cv::Mat3b book_green() {
  return cover(Scalar(70, 130, 40), Scalar(240, 240, 230), "VISION", 13);
}

cv::Mat3b packet(const Scalar& ground, const char* name, std::uint32_t seed) {
  cv::Mat3b p = sheet(384, 256, ground);
  Brush brush(p, seed);
  for (int i = 0; i < 26; ++i)
    cv::circle(p, brush.place(), brush.draw(4, 30), brush.colour(),
               brush.draw() < 0.6F ? cv::FILLED : 3, cv::LINE_AA);
  cv::rectangle(p, {30, 80, 324, 90}, Scalar(235, 240, 245), cv::FILLED);
  brush.write(name, {44, 148}, 2.0, Scalar(40, 30, 120), 4);
  brush.barcode({280, 190, 90, 54});
  return p;
}
cv::Mat3b box_tea() {
  return packet(Scalar(30, 190, 235), "TEA No7", 21);
}
cv::Mat3b box_biscuits() {
  return packet(Scalar(60, 50, 190), "BISCUIT", 22);
}
cv::Mat3b box_soap() {
  return packet(Scalar(200, 150, 60), "S O A P", 23);
}

cv::Mat3b cup_dots() {
  cv::Mat3b p = sheet(512, 192, Scalar(225, 228, 230));
  Brush brush(p, 31);
  for (int i = 0; i < 46; ++i)
    cv::circle(p, brush.place(), brush.draw(7, 20), brush.colour(), cv::FILLED, cv::LINE_AA);
  return p;
}
cv::Mat3b cup_stripes() {
  cv::Mat3b p = sheet(512, 192, Scalar(60, 70, 190));
  for (int x = 0; x < 512; x += 48)
    cv::line(p, {x, 0}, {x + 40, 192}, Scalar(225, 225, 225), 10, cv::LINE_AA);
  cv::putText(p, "COFFEE", {110, 120}, cv::FONT_HERSHEY_DUPLEX, 2.4, Scalar(30, 20, 20), 6,
              cv::LINE_AA);
  return p;
}

cv::Mat3b poster_plate() {
  cv::Mat3b p = sheet(128, 96, Scalar(228, 230, 230));
  Brush brush(p, 6);
  brush.write("2.14", {14, 44}, 1.2, Scalar(40, 40, 40), 2);
  brush.lines_of_text({14, 62, 100, 24}, 11, Scalar(60, 60, 60));
  return p;
}

cv::Mat3b cardboard() {
  cv::Mat3b p = sheet(512, 512, Scalar(84, 124, 158));
  for (int y = 0; y < 512; ++y) {
    for (int x = 0; x < 512; ++x) {
      const float fx = static_cast<float>(x) / 512.0F;
      const float fy = static_cast<float>(y) / 512.0F;
      const float n = 8.0F * fractal_noise(fx, fy, {6, 4, 0.6F}, 81) +
                      4.0F * fractal_noise(fx * 0.2F, fy, {128, 2, 0.6F}, 82);
      for (int k = 0; k < 3; ++k)
        p(y, x)[k] = cv::saturate_cast<std::uint8_t>(static_cast<float>(p(y, x)[k]) + n);
    }
  }
  Brush brush(p, 41);
  cv::rectangle(p, {0, 226, 512, 46}, Scalar(96, 142, 176), cv::FILLED);
  cv::rectangle(p, {0, 226, 512, 46}, Scalar(70, 106, 136), 2);
  cv::rectangle(p, {300, 60, 160, 110}, Scalar(222, 226, 228), cv::FILLED);
  brush.lines_of_text({312, 76, 130, 80}, 14, Scalar(50, 50, 60));
  brush.barcode({60, 340, 170, 90});
  brush.write("FRAGILE", {270, 420}, 1.6, Scalar(40, 50, 60), 4);
  for (int x : {80, 150}) {
    cv::arrowedLine(p, {x, 190}, {x, 60}, Scalar(40, 50, 60), 10, cv::LINE_AA, 0, 0.4);
  }
  cv::rectangle(p, {0, 0, 512, 512}, Scalar(66, 98, 126), 5);
  return p;
}

}  // namespace

const std::vector<Picture>& pictures() {
  static const std::vector<Picture> all{
      {"poster_fish", poster_fish},
      {"poster_map", poster_map},
      {"poster_notice", poster_notice},
      {"poster_art", poster_art},
      {"poster_timetable", poster_timetable},
      {"poster_landscape", poster_landscape},
      {"poster_plate", poster_plate},
      {"book_red", book_red},
      {"book_blue", book_blue},
      {"book_green", book_green},
      {"box_tea", box_tea},
      {"box_biscuits", box_biscuits},
      {"box_soap", box_soap},
      {"cup_dots", cup_dots},
      {"cup_stripes", cup_stripes},
      {"cardboard", cardboard},
  };
  return all;
}

}  // namespace striate::simulator::render
