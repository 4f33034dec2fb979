#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "striate/platform/pioneer/arcos/packet_stream.hpp"

/// Recorded bytes: one chunk a line, "seconds direction hex...". The project's own recordings are
/// in tests/fixtures/captures; those of other programs and simulators are read beside them where
/// the public data is at hand (STRIATE_SHARED_DATA/captures).
namespace striate::reference {

/// "fa fb 03 00 00 00" as bytes.
inline Bytes from_hex(const std::string& text) {
  std::istringstream words(text);
  Bytes bytes;
  for (std::string word; words >> word;) {
    bytes.push_back(static_cast<std::uint8_t>(std::stoul(word, nullptr, 16)));
  }
  return bytes;
}

struct Chunk {
  double time_s = 0.0;
  std::string direction;  ///< "C>R", "R>C", "H>L", ...
  Bytes bytes;
};

inline std::vector<Chunk> read_capture(const std::filesystem::path& file) {
  std::ifstream lines(file);
  std::vector<Chunk> chunks;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    Chunk chunk;
    std::string rest;
    words >> chunk.time_s >> chunk.direction;
    std::getline(words, rest);
    if (rest.find("EOF") == std::string::npos) chunk.bytes = from_hex(rest);
    chunks.push_back(std::move(chunk));
  }
  return chunks;
}

/// All bytes that went one way.
inline Bytes one_way(const std::vector<Chunk>& chunks, const std::string& direction) {
  Bytes bytes;
  for (const Chunk& chunk : chunks) {
    if (chunk.direction != direction) continue;
    bytes.insert(bytes.end(), chunk.bytes.begin(), chunk.bytes.end());
  }
  return bytes;
}

/// All captures of one kind, those of the project first.
/// @param kind any of these words is in their names
/// @throws std::runtime_error when the project's own are missing: no test passes without bytes
inline std::vector<std::filesystem::path> captures(const std::vector<std::string>& kind) {
  namespace fs = std::filesystem;
  std::vector<fs::path> files;
  const auto add_all = [&](const fs::path& folder) {
    if (!fs::is_directory(folder)) return;
    for (const auto& entry : fs::directory_iterator(folder)) {
      const std::string name = entry.path().filename().string();
      const bool wanted = std::any_of(kind.begin(), kind.end(), [&](const std::string& word) {
        return name.ends_with(".hex") && name.find(word) != std::string::npos;
      });
      if (wanted) files.push_back(entry.path());
    }
  };
  add_all(STRIATE_SOURCE_DIR "/tests/fixtures/captures");
  if (files.empty()) throw std::runtime_error("no recording of " + kind[0] + " in tests/fixtures");
  const char* folder = std::getenv("STRIATE_SHARED_DATA");
  add_all(fs::path(folder != nullptr ? folder : STRIATE_SHARED_DATA) / "captures");
  return files;
}

/// A word that is in the file's name, not in that of its folder.
inline bool named(const std::filesystem::path& file, const std::string& word) {
  return file.filename().string().find(word) != std::string::npos;
}

inline std::vector<std::filesystem::path> arcos_captures() {
  return captures({"arcos", "amrisim", "mobilesim"});
}
inline std::vector<std::filesystem::path> lms_captures() {
  return captures({"lms200"});
}
inline std::vector<std::filesystem::path> urg_captures() {
  return captures({"urg"});
}
inline std::vector<std::filesystem::path> servo_captures() {
  return captures({"dynamixel"});
}

}  // namespace striate::reference
