#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>

#include "striate/base/user_error.hpp"
#include "striate/platform/datasets/images/read_image.hpp"
#include "tests/fuzz/fuzz_target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto file = std::filesystem::temp_directory_path() /
                           ("striate_fuzz_" + std::to_string(getpid()) + ".png");
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  try {
    (void)striate::datasets::read_any_image(file);
  } catch (const striate::UserError&) {
  }
  std::filesystem::remove(file);
  return 0;
}

std::vector<std::string> striate::fuzz::seeds() {
  std::vector<std::string> seeds;
  for (const char* kind : {".png", ".jpg", ".bmp", ".pgm", ".tiff", ".webp"}) {
    std::vector<uchar> bytes;
    cv::imencode(kind, cv::Mat1b(20, 24, uchar{77}), bytes);
    seeds.emplace_back(bytes.begin(), bytes.end());
  }
  return seeds;
}
