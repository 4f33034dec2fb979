#include "striate/agent/pictures/animated_png.hpp"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace striate::agent::pictures {
namespace {

struct Chunk {
  std::string kind;
  std::string content;
  std::uint32_t crc = 0;
};

std::uint32_t big32(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value = value * 256U + static_cast<std::uint8_t>(bytes.at(at + i));
  return value;
}

/// Bit by bit, apart from the table that is judged.
std::uint32_t crc_of(const std::string& bytes) {
  std::uint32_t crc = ~0U;
  for (const char byte : bytes) {
    crc ^= static_cast<std::uint8_t>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 1U) != 0U ? 0xEDB88320U ^ (crc >> 1) : crc >> 1;
  }
  return ~crc;
}

std::vector<Chunk> chunks_of(const std::string& file) {
  std::vector<Chunk> chunks;
  for (std::size_t at = 8; at < file.size();) {
    const std::size_t length = big32(file, at);
    chunks.push_back(
        {file.substr(at + 4, 4), file.substr(at + 8, length), big32(file, at + 8 + length)});
    at += 12 + length;
  }
  return chunks;
}

cv::Mat3b disc(int x, int y) {
  cv::Mat3b frame(48, 64, cv::Vec3b(20, 30, 40));
  cv::circle(frame, {x, y}, 9, cv::Scalar(200, 100, 50), cv::FILLED);
  return frame;
}

TEST(AnimatedPng, HoldsEachFrameAsItWasWithRightChecksumsAndSequence) {
  AnimatedPng film(400);
  const std::vector<cv::Mat3b> frames{disc(10, 10), disc(30, 20), disc(50, 30)};
  for (const cv::Mat3b& frame : frames) film.add(frame);
  const std::string file = film.bytes();
  std::size_t shown = 0;
  std::uint32_t sequence = 0;
  std::string header;
  for (const Chunk& chunk : chunks_of(file)) {
    EXPECT_EQ(chunk.crc, crc_of(chunk.kind + chunk.content)) << chunk.kind;
    if (chunk.kind == "IHDR") header = chunk.content;
    if (chunk.kind == "acTL") {
      EXPECT_EQ(big32(chunk.content, 0), frames.size());
    }
    if (chunk.kind == "fcTL") {
      EXPECT_EQ(big32(chunk.content, 0), sequence++);
    }
    if (chunk.kind != "IDAT" && chunk.kind != "fdAT") continue;
    if (chunk.kind == "fdAT") {
      EXPECT_EQ(big32(chunk.content, 0), sequence++);
    }
    // Each frame's rows make a picture of its own, under the common header.
    const std::string rows = chunk.kind == "IDAT" ? chunk.content : chunk.content.substr(4);
    const auto one = [](const std::string& kind, const std::string& content) {
      const auto word = [](std::uint32_t v) {
        return std::string{static_cast<char>(v >> 24U), static_cast<char>(v >> 16U),
                           static_cast<char>(v >> 8U), static_cast<char>(v)};
      };
      return word(static_cast<std::uint32_t>(content.size())) + kind + content +
             word(crc_of(kind + content));
    };
    const std::string still =
        file.substr(0, 8) + one("IHDR", header) + one("IDAT", rows) + one("IEND", "");
    const cv::Mat decoded =
        cv::imdecode(std::vector<char>(still.begin(), still.end()), cv::IMREAD_COLOR);
    ASSERT_EQ(decoded.size(), frames[shown].size());
    EXPECT_EQ(cv::norm(decoded, frames[shown], cv::NORM_INF), 0.0) << "frame " << shown;
    ++shown;
  }
  EXPECT_EQ(shown, frames.size());
}

TEST(AnimatedPng, ShowsItsFirstFrameToAReaderThatKnowsStillPicturesOnly) {
  AnimatedPng film(100);
  film.add(disc(20, 20));
  film.add(disc(40, 20));
  const std::string file = film.bytes();
  const cv::Mat decoded =
      cv::imdecode(std::vector<char>(file.begin(), file.end()), cv::IMREAD_COLOR);
  EXPECT_EQ(cv::norm(decoded, disc(20, 20), cv::NORM_INF), 0.0);
}

TEST(AnimatedPng, RefusesAFrameOfAnotherSizeAndAFilmOfNone) {
  AnimatedPng film(100);
  EXPECT_THROW((void)film.bytes(), std::logic_error);
  film.add(disc(20, 20));
  EXPECT_FALSE(film.fits(cv::Mat3b(10, 10)));
  EXPECT_THROW(film.add(cv::Mat3b(10, 10)), std::invalid_argument);
  EXPECT_THROW(film.add(cv::Mat3b()), std::invalid_argument);
}

}  // namespace
}  // namespace striate::agent::pictures
