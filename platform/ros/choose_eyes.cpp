#include "striate/platform/ros/choose_eyes.hpp"

#include <algorithm>
#include <cctype>
#include <utility>
#include <vector>

#include "striate/base/lower_case.hpp"
#include "striate/base/user_error.hpp"

namespace striate::ros {
namespace {

constexpr const char* kImage = "sensor_msgs/Image";  // type of an image; ROS 1 sensor_msgs
/// Type of a compressed image; ROS 1 sensor_msgs
constexpr const char* kCompressed = "sensor_msgs/CompressedImage";

int merit(const std::string& topic) {
  if (topic.find("rect_color") != std::string::npos) return 3;
  if (topic.find("rect") != std::string::npos) return 2;
  return topic.find("color") != std::string::npos ? 1 : 0;
}

bool is_image(const std::string& type) {
  return type == kImage || type == kCompressed;
}

/// "right" with the letters' case of a "left": LEFT, Left, left.
std::string right_like(const std::string& left) {
  const auto upper = [](char letter) {
    return std::isupper(static_cast<unsigned char>(letter)) != 0;
  };
  if (upper(left[1])) return "RIGHT";
  return upper(left[0]) ? "Right" : "right";
}

constexpr const char* kLeftEye = "left";  // in names of topics, by habit of ROS
constexpr std::size_t kLeftLetters = 4;   // letters of kLeftEye

/// The topic of the other eye that has one of the types: any one "left" of the name is the eye, or
/// all of them are.
template <class Fits>
EyeTopics partner_of(const std::string& left, const BagTopics& topics, Fits fits) {
  const std::string plain = lower_case(left);
  std::string all = left;
  std::string camera;
  for (std::size_t at = plain.rfind(kLeftEye); at != std::string::npos;
       at = at == 0 ? std::string::npos : plain.rfind(kLeftEye, at - 1)) {
    const std::string right = right_like(left.substr(at, kLeftLetters));
    std::string one = left;
    one.replace(at, kLeftLetters, right);
    all.replace(at, kLeftLetters, right);
    camera = left.substr(0, at);
    for (const std::string& name : {one, all}) {
      const auto found = topics.find(name);
      if (found != topics.end() && fits(found->second)) return {left, name, camera};
    }
  }
  return {};
}

/// The best pair of each camera, in the order of their names.
std::vector<EyeTopics> cameras_of(const BagTopics& topics) {
  std::vector<EyeTopics> cameras;
  for (const auto& [topic, type] : topics) {
    if (!is_image(type)) continue;
    const EyeTopics eyes = partner_of(topic, topics, is_image);
    if (eyes.left.empty()) continue;
    const auto same = std::find_if(cameras.begin(), cameras.end(),
                                   [&](const EyeTopics& one) { return one.camera == eyes.camera; });
    if (same == cameras.end()) {
      cameras.push_back(eyes);
    } else if (merit(eyes.left) > merit(same->left)) {
      *same = eyes;
    }
  }
  return cameras;
}

[[noreturn]] void refuse_choice(const std::string& why, const std::vector<EyeTopics>& cameras) {
  std::string text = why;
  for (const EyeTopics& one : cameras) text += "\n  " + one.left + " and " + one.right;
  throw UserError(text + "\n  hint: --camera says what the topics begin with, or the settings " +
                  "ros.left_image and ros.right_image name them");
}

}  // namespace

std::string full(const std::string& topic) {
  return topic.empty() || topic.front() == '/' ? topic : "/" + topic;
}

bool begins_with(const std::string& text, const std::string& beginning) {
  return text.compare(0, beginning.size(), beginning) == 0;
}

EyeTopics choose_eyes(const BagTopics& topics, const RosSettings& s, const std::string& camera) {
  const auto image_there = [&topics](const std::string& name) {
    const auto found = topics.find(name);
    return found != topics.end() && is_image(found->second);
  };
  const std::string left = full(s.left_image);
  const std::string right = full(s.right_image);
  if (camera.empty() && image_there(left)) {
    if (image_there(right)) return {left, right, {}};
    return partner_of(left, topics, is_image);  // never one of another camera
  }
  std::vector<EyeTopics> cameras = cameras_of(topics);
  if (!camera.empty()) {
    std::vector<EyeTopics> meant;
    for (const EyeTopics& one : cameras) {
      const std::string beginning = full(camera);
      if (one.camera == beginning || one.camera == beginning + "/") return one;
      if (begins_with(one.left, beginning)) meant.push_back(one);
    }
    if (meant.empty()) {
      refuse_choice("the bag has no stereo camera whose topics begin with " + full(camera) +
                        "; it has" + (cameras.empty() ? " none" : ":"),
                    cameras);
    }
    cameras = std::move(meant);
  }
  if (cameras.size() > 1) {
    refuse_choice("the bag has several stereo cameras; say which one:", cameras);
  }
  return cameras.empty() ? EyeTopics{} : cameras.front();
}

std::string find(const BagTopics& topics, const std::string& wanted, const std::string& type,
                 const std::string& part) {
  const std::string name = full(wanted);
  std::string first;
  for (const auto& [topic, its_type] : topics) {
    if (its_type != type) continue;
    if (topic == name) return topic;
    if (first.empty() && topic.find(part) != std::string::npos) first = topic;
  }
  return first.empty() ? name : first;
}

}  // namespace striate::ros
