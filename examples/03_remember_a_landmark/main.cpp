// Teaches a thing from one image, keeps it on disk, and finds it again in another image.
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>

#include "striate/agent/landmark_knowledge.hpp"
#include "striate/agent/teaching/image_view.hpp"
#include "striate/agent/teaching/keep_taught.hpp"
#include "striate/base/geometry.hpp"
#include "striate/perception/recognition/recogniser.hpp"

namespace {
constexpr double kTurn_deg = 25.0,
                 kScale = 0.7;         // of the thing in the scene against the taught one
const cv::Point2f kTrue{400, 220};     // its middle in the scene, px
constexpr double kTolerance_px = 5.0;  // of the middle that is found

/// Coloured shapes, the same for the same seed: the cover of a book, or a room full of things.
cv::Mat3b paint(cv::Size size, std::uint64_t seed, int shapes) {
  cv::Mat3b image(size, cv::Vec3b(150, 170, 180));
  cv::RNG random(seed);
  for (int i = 0; i < shapes; ++i) {
    const cv::Point at(random.uniform(0, size.width), random.uniform(0, size.height));
    const cv::Size extent(random.uniform(8, 70), random.uniform(8, 70));
    const cv::Scalar colour(random.uniform(0, 256), random.uniform(0, 256), random.uniform(0, 256));
    if (i % 2 == 0) cv::rectangle(image, {at, extent}, colour, cv::FILLED, cv::LINE_AA);
    if (i % 2 == 1) cv::circle(image, at, extent.width / 2, colour, cv::FILLED, cv::LINE_AA);
  }
  return image;
}

/// The cover in another place of another image: smaller and turned.
cv::Mat3b scene_with(const cv::Mat3b& cover) {
  cv::Mat3b scene = paint({640, 480}, 99, 60);
  const cv::Point2f middle = cv::Point2f(cover.size()) * 0.5F;
  cv::Matx23d there = cv::getRotationMatrix2D(middle, kTurn_deg, kScale);
  there(0, 2) += kTrue.x - middle.x;
  there(1, 2) += kTrue.y - middle.y;
  cv::warpAffine(cover, scene, there, scene.size(), cv::INTER_AREA, cv::BORDER_TRANSPARENT);
  return scene;
}

}  // namespace

int main(int count, char** words) try {
  const std::string folder = count > 1 ? words[1] : ".";
  const std::string memory = folder + "/home.db";
  for (const char* part : {"", "-wal", "-shm"}) std::filesystem::remove(memory + part);
  const striate::memory::LongTermSettings settings;
  const cv::Mat3b cover = paint({300, 400}, 5, 80);
  const auto view = striate::agent::view_of_image(cover, settings);
  (void)striate::agent::keep_taught(memory, "book", {view}, settings);
  // From here on only the file knows the book: another program could go on.
  const auto knowledge = striate::agent::read_landmark_knowledge(memory);
  striate::perception::Recogniser recogniser{striate::perception::RecognitionSettings{}};
  for (std::size_t i = 0; i < knowledge.landmarks.size(); ++i) {
    for (const auto& view : knowledge.landmarks[i].views) recogniser.add(static_cast<int>(i), view);
  }
  cv::Mat3b scene = scene_with(cover);
  cv::Mat1b grey;
  cv::cvtColor(scene, grey, cv::COLOR_BGR2GRAY);
  bool found = false;
  for (const auto& one : recogniser.recognise(striate::agent::keypoints_to_learn(grey))) {
    const auto& known = knowledge.landmarks[static_cast<std::size_t>(one.landmark)].record;
    std::printf("%s at (%.0f, %.0f) px, %.2f of its size, turned by %.0f deg: %d keypoints agree\n",
                known.name.c_str(), one.u_px, one.v_px, one.scale, striate::degrees(one.angle_rad),
                one.inliers);
    cv::circle(scene, cv::Point2d(one.u_px, one.v_px), cvRound(one.width_px / 2), {60, 60, 230}, 3);
    found = found || std::hypot(one.u_px - kTrue.x, one.v_px - kTrue.y) < kTolerance_px;
  }
  if (!cv::imwrite(folder + "/found.png", scene)) return 1;
  return found ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
