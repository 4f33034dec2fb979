#include "striate/platform/simulator/render/paint.hpp"
#include "striate/platform/simulator/render/paint_brush.hpp"

namespace striate::simulator::render {
namespace {

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
cv::Mat3b book_orange() {
  return cover(Scalar(30, 110, 220), Scalar(225, 235, 240), "CORNER", 14);
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
cv::Mat3b box_cocoa() {
  return packet(Scalar(50, 70, 120), "COCOA 5", 24);
}

cv::Mat3b dots(const Scalar& ground, std::uint32_t seed) {
  cv::Mat3b p = sheet(512, 192, ground);
  Brush brush(p, seed);
  for (int i = 0; i < 46; ++i)
    cv::circle(p, brush.place(), brush.draw(7, 20), brush.colour(), cv::FILLED, cv::LINE_AA);
  return p;
}
cv::Mat3b cup_dots() {
  return dots(Scalar(225, 228, 230), 31);
}
cv::Mat3b cup_spots() {
  return dots(Scalar(150, 215, 230), 32);
}
cv::Mat3b cup_stripes() {
  cv::Mat3b p = sheet(512, 192, Scalar(60, 70, 190));
  for (int x = 0; x < 512; x += 48)
    cv::line(p, {x, 0}, {x + 40, 192}, Scalar(225, 225, 225), 10, cv::LINE_AA);
  cv::putText(p, "COFFEE", {110, 120}, cv::FONT_HERSHEY_DUPLEX, 2.4, Scalar(30, 20, 20), 6,
              cv::LINE_AA);
  return p;
}

cv::Mat3b cardboard() {
  cv::Mat3b p = sheet(512, 512, Scalar(84, 124, 158));
  const FractalNoise stains({6, 4, 0.6F}, 81);
  const FractalNoise fibres({128, 2, 0.6F}, 82);
  for (int y = 0; y < 512; ++y) {
    for (int x = 0; x < 512; ++x) {
      const float fx = static_cast<float>(x) / 512.0F;
      const float fy = static_cast<float>(y) / 512.0F;
      const float n = 8.0F * stains(fx, fy) + 4.0F * fibres(fx * 0.2F, fy);
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
  static const std::vector<Picture> all = [] {
    std::vector<Picture> both = posters();
    const std::vector<Picture> things{
        {"book_red", book_red},       {"book_blue", book_blue},       {"book_green", book_green},
        {"box_tea", box_tea},         {"box_biscuits", box_biscuits}, {"box_soap", box_soap},
        {"cup_dots", cup_dots},       {"cup_stripes", cup_stripes},   {"cardboard", cardboard},
        {"book_orange", book_orange}, {"box_cocoa", box_cocoa},       {"cup_spots", cup_spots},
    };
    both.insert(both.end(), things.begin(), things.end());
    return both;
  }();
  return all;
}

}  // namespace striate::simulator::render
