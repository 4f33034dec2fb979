#include <fmt/format.h>

#include <algorithm>

#include "striate/base/files.hpp"
#include "striate/base/user_error.hpp"
#include "striate/platform/datasets/calibration/calibration_formats.hpp"
#include "striate/platform/datasets/calibration/judge_model.hpp"
#include "striate/platform/datasets/calibration/read_calibration.hpp"
#include "striate/platform/datasets/sequences/opened_sequences.hpp"

namespace striate::datasets {
namespace {

namespace fs = std::filesystem;

/// What lies beside the pictures and can only be a calibration: one file of both eyes, or one for
/// each, by their names.
FoundCalibration search_folder(const fs::path& folder, const SequenceOptions& options,
                               std::vector<std::string>& remarks) {
  std::vector<fs::path> candidates;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string suffix = entry.path().extension().string();
    constexpr const char* kTexts[] = {".yaml", ".yml", ".xml", ".json", ".txt"};
    if (std::ranges::find(kTexts, suffix) == std::end(kTexts)) continue;
    if (looks_like_calibration(entry.path())) candidates.push_back(entry.path());
  }
  std::ranges::sort(candidates);
  std::vector<fs::path> of_both;
  for (const fs::path& file : candidates) {
    for (const RightName& other : right_names(file.stem().string())) {
      const fs::path partner = file.parent_path() / (other.name + file.extension().string());
      if (std::ranges::find(candidates, partner) == candidates.end()) continue;
      if (of_both.empty()) of_both = {file, partner};
    }
  }
  if (of_both.empty() && candidates.size() == 1) of_both = candidates;
  if (of_both.empty()) {
    if (candidates.size() > 1) {
      remarks.push_back(
          fmt::format("{} holds {} files that may be calibrations: none was taken; "
                      "say which: --calibration FILE",
                      folder.string(), candidates.size()));
    }
    return {};
  }
  try {
    return read_found(of_both, options);
  } catch (const UserError& mistake) {
    remarks.push_back(fmt::format("a calibration was found but not used: {}", mistake.what()));
    return {};
  }
}

}  // namespace

FoundCalibration read_found(const std::vector<fs::path>& files, const SequenceOptions& options) {
  FoundCalibration found;
  found.model = read_calibration(files, options.exchanged);
  for (const fs::path& file : files) {
    found.file += (found.file.empty() ? "" : ", ") + file.string();
  }
  return found;
}

FoundCalibration calibration_of(const fs::path& folder, PictureList& list,
                                const SequenceOptions& options) {
  if (!options.calibration.empty()) return read_found(options.calibration, options);
  if (list.kind.starts_with("KITTI") && !list.calibration.empty()) {
    const std::string file = list.calibration.front().string();
    config::Diagnostics diagnostics(file);
    StereoModel model = read_kitti(read_file(file), list.kitti_first, diagnostics);
    diagnostics.throw_if_any();
    if (options.exchanged) exchange_eyes(model);
    judge_model(model, file);
    return {model, file};
  }
  if (!list.calibration.empty()) return read_found(list.calibration, options);
  return search_folder(folder, options, list.remarks);
}

}  // namespace striate::datasets
