#pragma once

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "platform/pioneer/arcos/packet_stream.hpp"

/// Recorded bytes of real programs and simulators: one chunk a line, "seconds direction hex...".
/// They are looked for in STRIATE_SHARED_DATA/captures and are not part of the project.
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

inline std::filesystem::path captures_folder(const std::string& built_with) {
  const char* folder = std::getenv("STRIATE_SHARED_DATA");
  return std::filesystem::path(folder != nullptr ? folder : built_with) / "captures";
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

/// The captures that hold ARCOS; empty where there are none.
inline std::vector<std::filesystem::path> arcos_captures(const std::string& built_with) {
  std::vector<std::filesystem::path> files;
  const std::filesystem::path folder = captures_folder(built_with);
  if (!std::filesystem::is_directory(folder)) return files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    const bool arcos =
        name.find("amrisim") != std::string::npos || name.find("mobilesim") != std::string::npos;
    if (arcos) files.push_back(entry.path());
  }
  return files;
}

}  // namespace striate::reference
