#pragma once

#include <filesystem>
#include <opencv2/core.hpp>
#include <vector>

#include "striate/evaluation/patch_choice.hpp"
#include "striate/evaluation/patch_set.hpp"

/// Patches cut from image sequences with homographies.
namespace striate::evaluation {

/// What a folder holds, by name: the same order on every machine.
[[nodiscard]] std::vector<std::filesystem::path> sorted_entries(
    const std::filesystem::path& folder);

/// Two images of one sequence and what takes the first to the second.
struct SequencePair {
  std::filesystem::path first, second;
  cv::Matx33d homography;
};

/// The first image of a folder with each of the others; empty where none has a homography.
[[nodiscard]] std::vector<SequencePair> image_pairs(const std::filesystem::path& folder);

[[nodiscard]] PatchSet from_sequences(const std::vector<SequencePair>& pictures,
                                      const PatchChoice& choice);

}  // namespace striate::evaluation
