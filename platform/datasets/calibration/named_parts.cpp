#include "striate/platform/datasets/calibration/named_parts.hpp"

#include <cctype>
#include <string_view>

#include "striate/base/plain_text.hpp"
#include "striate/platform/datasets/calibration/eye_fields.hpp"

namespace striate::datasets {
namespace {

using config::Node;

struct PartName {
  const char* letters;
  Part part;
};

/// What programs and people call the parts, in small letters without anything between.
constexpr PartName kPartNames[] = {{"k", Part::matrix},
                                   {"m", Part::matrix},
                                   {"mtx", Part::matrix},
                                   {"cameramatrix", Part::matrix},
                                   {"intrinsicmatrix", Part::matrix},
                                   {"intrinsics", Part::matrix},
                                   {"intrinsic", Part::matrix},
                                   {"matrix", Part::matrix},
                                   {"kmatrix", Part::matrix},
                                   {"d", Part::lens},
                                   {"dist", Part::lens},
                                   {"distcoeffs", Part::lens},
                                   {"distcoeff", Part::lens},
                                   {"distortion", Part::lens},
                                   {"distortioncoefficients", Part::lens},
                                   {"distortioncoeffs", Part::lens},
                                   {"distcoefs", Part::lens},
                                   {"coefficients", Part::lens},
                                   {"r", Part::turn},
                                   {"rotation", Part::turn},
                                   {"rot", Part::turn},
                                   {"rotationmatrix", Part::turn},
                                   {"rect", Part::turn},
                                   {"rectification", Part::turn},
                                   {"rectificationmatrix", Part::turn},
                                   {"rectificationtransform", Part::turn},
                                   {"p", Part::projection},
                                   {"proj", Part::projection},
                                   {"projection", Part::projection},
                                   {"projectionmatrix", Part::projection},
                                   {"t", Part::way},
                                   {"translation", Part::way},
                                   {"translationm", Part::way},
                                   {"trans", Part::way},
                                   {"translationvector", Part::way},
                                   {"tvec", Part::way},
                                   {"q", Part::to_depth},
                                   {"disparitytodepth", Part::to_depth},
                                   {"width", Part::width},
                                   {"imagewidth", Part::width},
                                   {"imgwidth", Part::width},
                                   {"w", Part::width},
                                   {"height", Part::height},
                                   {"imageheight", Part::height},
                                   {"imgheight", Part::height},
                                   {"h", Part::height},
                                   {"imagesize", Part::size},
                                   {"imgsize", Part::size},
                                   {"size", Part::size},
                                   {"resolution", Part::size},
                                   {"baseline", Part::baseline},
                                   {"baselinem", Part::baseline},
                                   {"distortionmodel", Part::lens_model},
                                   {"lensmodel", Part::lens_model},
                                   {"cameramodel", Part::lens_model},
                                   {"cameratype", Part::lens_model},
                                   {"model", Part::lens_model},
                                   {"fx", Part::fx},
                                   {"fy", Part::fy},
                                   {"cx", Part::cx},
                                   {"cy", Part::cy}};

struct Named {
  Part part = Part::none;
  Eye eye = Eye::both;
  bool from_zero = false;  ///< the eye was said by a 0: then 1 is the second one
};

Part part_named(std::string_view letters) {
  for (const PartName& name : kPartNames) {
    if (letters == name.letters) return name.part;
  }
  return Part::none;
}

struct EyeWord {
  const char* word;
  Eye eye;
  bool zero = false;
};

/// The longer ones first, so that `camera1` is not a `1` behind the unknown word `camera`.
constexpr EyeWord kEyeWords[] = {{"camera0", Eye::first, true},
                                 {"camera1", Eye::second},
                                 {"camera2", Eye::second},
                                 {"cam0", Eye::first, true},
                                 {"cam1", Eye::second},
                                 {"cam2", Eye::second},
                                 {"left", Eye::first},
                                 {"right", Eye::second},
                                 {"0", Eye::first, true},
                                 {"1", Eye::second},
                                 {"2", Eye::second},
                                 {"l", Eye::first},
                                 {"r", Eye::second}};

bool is_digit_word(const EyeWord& word) {
  return std::isdigit(
             static_cast<unsigned char>(word.word[std::string_view(word.word).size() - 1])) != 0;
}

/// `K1`, `left_camera_matrix`, `LEFT.K`, `cameraMatrixL`: what, and of which eye. A digit is kept
/// as 0, 1 or 2 by `digit`, since only all keys together say what 1 means.
struct Key {
  Named named;
  int digit = -1;
};

Key understood(const std::string& key) {
  const std::string letters = lower_letters(key);
  if (const Part whole = part_named(letters); whole != Part::none) return {{whole}, -1};
  for (const EyeWord& word : kEyeWords) {
    const std::string_view w = word.word;
    std::string_view rest = letters;
    if (rest.size() <= w.size()) continue;
    if (rest.ends_with(w)) {
      rest.remove_suffix(w.size());
    } else if (rest.starts_with(w) && w.size() > 1) {
      rest.remove_prefix(w.size());
    } else {
      continue;
    }
    const Part part = part_named(rest);
    if (part == Part::none) continue;
    return {{part, word.eye, word.zero}, is_digit_word(word) ? w.back() - '0' : -1};
  }
  return {};
}

/// Which eye a map of its own is about: `left: {...}`, `cam0: {...}`.
Key map_key(const std::string& key) {
  const std::string letters = lower_letters(key);
  for (const EyeWord& word : kEyeWords) {
    const std::string_view w = word.word;
    const bool same = letters == w || letters == std::string(w) + "camera" ||
                      letters == "camera" + std::string(w) || letters == "cam" + std::string(w);
    if (same) return {{Part::none, word.eye, word.zero}, is_digit_word(word) ? w.back() - '0' : -1};
  }
  return {{Part::none, Eye::both}, -1};
}

/// Every key that is understood, right in the file or in a map for an eye.
template <class Use>
void for_each(const Node& root, const Use& use) {
  for (const Node::Entry& entry : root.entries) {
    const Key key = understood(entry.key);
    if (key.named.part != Part::none) {
      use(key, entry);
      continue;
    }
    if (entry.value.kind != Node::Kind::map || entry.value.find("data") != nullptr) continue;
    const Key of_map = map_key(entry.key);
    for (const Node::Entry& inner : entry.value.entries) {
      Key inside = understood(inner.key);
      if (inside.named.part == Part::none) continue;
      if (of_map.named.eye != Eye::both) {
        inside.named.eye = of_map.named.eye;
        inside.named.from_zero = of_map.named.from_zero;
        inside.digit = of_map.digit;
      }
      use(inside, inner);
    }
  }
}

}  // namespace

NamedParts::NamedParts(const Node& root) {
  bool zero = false;
  for_each(root, [&](const Key& key, const Node::Entry&) { zero = zero || key.digit == 0; });
  for_each(root, [&](const Key& key, const Node::Entry& entry) {
    Eye eye = key.named.eye;
    if (key.digit >= 0) eye = key.digit == (zero ? 0 : 1) ? Eye::first : Eye::second;
    values_.try_emplace({key.named.part, eye}, Value{&entry.value, entry.key});
  });
}

const Node* NamedParts::find(Part part, Eye eye) const {
  const auto found = values_.find({part, eye});
  return found == values_.end() ? nullptr : found->second.node;
}

const Node* NamedParts::own_or_common(Part part, Eye eye) const {
  const Node* own = find(part, eye);
  return own != nullptr ? own : find(part, Eye::both);
}

std::string NamedParts::key(Part part, Eye eye) const {
  const auto found = values_.find({part, eye});
  return found == values_.end() ? "" : plain_text(found->second.key);
}

}  // namespace striate::datasets
