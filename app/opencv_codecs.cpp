#include "striate/app/late_opencv.hpp"

/// In late_opencv.cpp, which the program has and other programs have not.
extern "C" [[gnu::weak]] void striate_load_opencv_codecs();

namespace striate::app {

void load_opencv_codecs() {
  if (striate_load_opencv_codecs != nullptr) striate_load_opencv_codecs();
}

}  // namespace striate::app
