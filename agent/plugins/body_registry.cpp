#include "striate/agent/plugins/body_registry.hpp"

#include <utility>

namespace striate::agent {
namespace {

BodyRegistry& table() {
  static BodyRegistry bodies;
  return bodies;
}

}  // namespace

const BodyRegistry& body_registry() {
  return table();
}

bool enroll(BodyEntry entry) {
  return table().add(std::move(entry));
}

}  // namespace striate::agent
