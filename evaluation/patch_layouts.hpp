#pragma once

#include <string>

#include "striate/evaluation/patch_choice.hpp"
#include "striate/evaluation/patch_set.hpp"

namespace striate::evaluation {

/// Reads patch pairs from a folder of any of these layouts:
///   Oxford:  [DIR/]SEQUENCE/img1.png ... img6.png with H1to2p ... (any image format)
///   HPatches: [DIR/]SEQUENCE/1.ppm ... 6.ppm with H_1_2 ...
///   Brown/Winder: info.txt, m50_*.txt, patches0000.bmp ... (mosaics of 16x16 patches of 64x64 px)
/// @throws UserError where the folder holds none of them or a file is damaged (file:line).
[[nodiscard]] PatchSet load_patches(const std::string& folder, const PatchChoice& choice);

}  // namespace striate::evaluation
