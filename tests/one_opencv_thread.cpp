// OpenCV works in one thread in the tests, as it does in `striate`: tests run side by side, and
// the thread sanitizer does not see the locks of OpenCV's pool.
#include <gtest/gtest.h>

#include <opencv2/core/utility.hpp>

namespace {

class OneOpencvThread : public testing::Environment {
 public:
  void SetUp() override { cv::setNumThreads(1); }
};

[[maybe_unused]] const testing::Environment* const kOneOpencvThread =
    testing::AddGlobalTestEnvironment(new OneOpencvThread);

}  // namespace
