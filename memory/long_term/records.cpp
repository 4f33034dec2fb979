#include "striate/memory/long_term/records.hpp"

namespace striate::memory {

const char* name_of(SessionKind kind) {
  switch (kind) {
    case SessionKind::teach:
      return "teach";
    case SessionKind::mission:
      return "mission";
    case SessionKind::replay:
      return "replay";
    case SessionKind::import:
      return "import";
  }
  return "";
}

const char* name_of(SessionState state) {
  switch (state) {
    case SessionState::open:
      return "open";
    case SessionState::closed:
      return "closed";
    case SessionState::crashed:
      return "crashed";
  }
  return "";
}

const char* name_of(LandmarkKind kind) {
  return kind == LandmarkKind::taught ? "taught" : "candidate";
}

}  // namespace striate::memory
