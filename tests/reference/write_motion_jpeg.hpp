#pragma once

#include <cstdint>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <string>
#include <vector>

/// A video of JPEG pictures in an AVI file, written without the library that OpenCV writes videos
/// with: it brings two hundred others, which each process of the tests would load.
namespace striate::reference {

class AviBytes {
 public:
  void number(std::uint32_t value) {
    for (int k = 0; k < 4; ++k) bytes_.push_back(static_cast<char>(value >> (8 * k)));
  }
  void text(const std::string& four) { bytes_ += four; }
  void chunk(const std::string& name, const std::string& body) {
    bytes_ += name;
    number(static_cast<std::uint32_t>(body.size()));
    bytes_ += body;
    if (body.size() % 2 == 1) bytes_ += '\0';
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

inline std::string numbers(const std::vector<std::uint32_t>& values) {
  AviBytes bytes;
  for (const std::uint32_t value : values) bytes.number(value);
  return bytes.bytes();
}

inline void write_motion_jpeg(const std::string& file, const std::vector<cv::Mat>& pictures,
                              std::uint32_t pictures_per_s) {
  const auto count = static_cast<std::uint32_t>(pictures.size());
  const auto width = static_cast<std::uint32_t>(pictures.at(0).cols);
  const auto height = static_cast<std::uint32_t>(pictures.at(0).rows);
  AviBytes movie, index;
  movie.text("movi");
  for (const cv::Mat& picture : pictures) {
    std::vector<std::uint8_t> jpeg;
    cv::imencode(".jpg", picture, jpeg);
    index.text("00dc");
    index.number(0x10);  // a keyframe
    index.number(static_cast<std::uint32_t>(movie.bytes().size()));
    index.number(static_cast<std::uint32_t>(jpeg.size()));
    movie.chunk("00dc", {jpeg.begin(), jpeg.end()});
  }
  AviBytes stream, header, all, riff;
  stream.text("strl");
  stream.chunk("strh", "vidsMJPG" + numbers({0, 0, 0, 1, pictures_per_s, 0, count, width * height,
                                             0xFFFFFFFF, 0, 0, width | height << 16}));
  stream.chunk("strf", numbers({40, width, height, 1 | 24 << 16}) + "MJPG" +
                           numbers({3 * width * height, 0, 0, 0, 0}));
  header.text("hdrl");
  header.chunk("avih", numbers({1000000 / pictures_per_s, 0, 0, 0x10, count, 0, 1, width * height,
                                width, height, 0, 0, 0, 0}));
  header.chunk("LIST", stream.bytes());
  all.text("AVI ");
  all.chunk("LIST", header.bytes());
  all.chunk("LIST", movie.bytes());
  all.chunk("idx1", index.bytes());
  riff.chunk("RIFF", all.bytes());
  std::ofstream out(file, std::ios::binary);
  out << riff.bytes();
  if (!out.flush()) throw std::runtime_error(file + ": not written");
}

}  // namespace striate::reference
