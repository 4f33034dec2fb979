#pragma once

#include <filesystem>
#include <random>
#include <string>

#include "striate/base/user_error.hpp"
#include "striate/memory/long_term/memory_file.hpp"
#include "striate/memory/long_term/memory_tables.hpp"
#include "striate/memory/long_term/memory_writer.hpp"
#include "striate/memory/long_term/teaching.hpp"
#include "tests/reference/temporary_folder.hpp"

/// What the tests of the long-term memory share.
namespace striate::memory::memory_tests {

using Folder = reference::TemporaryFolder;

/// Keypoints scattered over 200 x 150 px with descriptors of coin flips.
inline StoredView scattered_view(unsigned seed, int keypoints) {
  std::mt19937 random(seed);
  StoredView view;
  view.width_px = 200.0;
  view.height_px = 150.0;
  for (int k = 0; k < keypoints; ++k) {
    perception::ViewKeypoint point;
    point.x_px = static_cast<float>(random() % 2000) / 10.0F;
    point.y_px = static_cast<float>(random() % 1500) / 10.0F;
    point.size_px = 8.0F;
    view.keypoints.push_back(point);
    StoredDescriptor descriptor{};
    for (auto& byte : descriptor) byte = static_cast<std::uint8_t>(random());
    view.descriptors.push_back(descriptor);
  }
  return view;
}

/// The same thing seen a little differently: moved, and some bits flipped.
inline StoredView seen_again(StoredView view, float shift_px, int keypoints_lost) {
  for (perception::ViewKeypoint& point : view.keypoints) point.x_px += shift_px;
  for (StoredDescriptor& one : view.descriptors) one[3] ^= 0x11;
  const std::size_t left = view.keypoints.size() - static_cast<std::size_t>(keypoints_lost);
  view.keypoints.resize(left);
  view.descriptors.resize(left);
  return view;
}

inline MemoryOptions options(Access access) {
  MemoryOptions given;
  given.access = access;
  given.software = "striate test";
  given.now_unix_s = 1700000000;
  given.wait_ms = 2000;
  return given;
}

/// An opened memory with its tables.
struct Opened {
  Opened(const std::string& path, Access access) : Opened(path, options(access)) {}
  Opened(const std::string& path, const MemoryOptions& given)
      : file(path, given), tables(file.database()) {}
  MemoryFile file;
  MemoryTables tables;
};

/// A landmark with one view, as taught in a session of its own.
inline void add_landmark(MemoryTables& tables, const std::string& name, unsigned seed,
                         int keypoints = 50) {
  const Session session = tables.sessions.begin(SessionKind::teach, "striate test",
                                                name + " " + std::to_string(seed), 1700000000);
  Landmark landmark;
  landmark.session = session.id;
  landmark.name = name;
  landmark.history = {1, session.operating_start_s, {session.operating_start_s}};
  StoredView view = scattered_view(seed, keypoints);
  view.landmark = tables.landmarks.add(landmark);
  view.session = session.id;
  view.image = {1, 2, 3};
  tables.views.add(view);
  tables.sessions.end(session.id, 0.0, "kept");
}

/// What a UserError thrown by `action` says; empty: none was thrown.
template <class Action>
std::string sentence_of(Action action) {
  try {
    action();
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

inline Taught teach_in_session(Opened& memory, const std::string& name,
                               const std::vector<StoredView>& views,
                               const LongTermSettings& settings = {}) {
  const Session session =
      memory.tables.sessions.begin(SessionKind::teach, "striate test", name, 1700000000);
  const Taught taught = teach(memory.tables, session, name, views, settings);
  memory.tables.sessions.end(session.id, 0.0, "kept");
  return taught;
}

}  // namespace striate::memory::memory_tests
