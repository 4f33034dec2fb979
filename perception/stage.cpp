#include "striate/perception/stage.hpp"

#include <utility>

namespace striate::perception {
namespace {

StageRegistry& table() {
  static StageRegistry stages;
  return stages;
}

}  // namespace

const StageRegistry& stage_registry() {
  return table();
}

bool enroll(StageEntry entry) {
  return table().add(std::move(entry));
}

}  // namespace striate::perception
