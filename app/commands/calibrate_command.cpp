#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <opencv2/imgcodecs.hpp>

#include "striate/app/commands/commands.hpp"
#include "striate/base/files.hpp"
#include "striate/base/user_error.hpp"
#include "striate/evaluation/calibration/calibrate_stereo.hpp"

namespace striate::app {
namespace {

namespace fs = std::filesystem;

struct CalibrateOptions {
  std::string folder;
  std::string out = "stereo_calibration.yaml";
  evaluation::Chessboard board;
  double square_mm = 25.0;  // side of a square, as boards to print come
  bool swap = false;
  bool side_by_side = false;
};

struct Looks {
  std::vector<evaluation::BoardPair> pairs;
  std::vector<std::string> without_board;
  cv::Size size_px;
};

/// Shown where a folder holds no pairs
constexpr const char* kLayout =
    "\n  hint: FOLDER/left/*.png and FOLDER/right/*.png with the same names, or with "
    "--side-by-side "
    "FOLDER/*.png";

std::vector<fs::path> images_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string kind = entry.path().extension();
    if (kind == ".png" || kind == ".jpg" || kind == ".pgm" || kind == ".bmp") {
      files.push_back(entry.path());
    }
  }
  if (error) throw UserError(folder.string() + ": " + error.message() + kLayout);
  std::sort(files.begin(), files.end());
  if (files.empty()) throw UserError(folder.string() + ": no images" + kLayout);
  return files;
}

cv::Mat1b read_grey(const fs::path& file) {
  cv::Mat1b image = cv::imread(file, cv::IMREAD_GRAYSCALE);
  if (image.empty()) throw UserError(file.string() + ": is no image" + kLayout);
  return image;
}

void look(const std::string& name, const cv::Mat1b& left, const cv::Mat1b& right,
          const CalibrateOptions& options, Looks& looks) {
  if (looks.size_px.empty()) looks.size_px = left.size();
  if (left.size() != looks.size_px || right.size() != looks.size_px) {
    throw UserError(name + ": is of another size than the images before it");
  }
  auto pair = evaluation::find_board(options.swap ? right : left, options.swap ? left : right,
                                     options.board);
  if (!pair) {
    looks.without_board.push_back(name);
    return;
  }
  pair->name = name;
  looks.pairs.push_back(std::move(*pair));
}

Looks look_at_all(const CalibrateOptions& options) {
  Looks looks;
  const fs::path folder = options.folder;
  for (const fs::path& file : images_in(options.side_by_side ? folder : folder / "left")) {
    const std::string name = file.filename();
    const cv::Mat1b image = read_grey(file);
    if (options.side_by_side) {
      const int half = image.cols / 2;
      look(name, image.colRange(0, half), image.colRange(half, 2 * half), options, looks);
    } else {
      look(name, image, read_grey(folder / "right" / name), options, looks);
    }
  }
  return looks;
}

int calibrate(const CalibrateOptions& given) {
  CalibrateOptions options = given;
  options.board.square_m = options.square_mm / 1000.0;
  check_writable(options.out);
  const Looks looks = look_at_all(options);
  for (const std::string& name : looks.without_board) {
    fmt::print("{}: the whole board is not seen in both images\n", name);
  }
  const evaluation::CalibrationReport report =
      evaluation::calibrate_stereo(looks.pairs, options.board, looks.size_px);
  for (const evaluation::PairError& pair : report.pairs) {
    fmt::print("{}: reprojection {:.3f} px, rectification {:.3f} px\n", pair.name,
               pair.reprojection_px, pair.epipolar_px);
  }
  const pioneer::StereoCalibration& found = report.calibration;
  pioneer::write_calibration(options.out, found);
  fmt::print("{} pairs of {} x {} px: reprojection {:.3f} px, rectification {:.3f} px (rms)\n",
             found.pairs, found.size_px.width, found.size_px.height, found.reprojection_px,
             found.epipolar_px);
  fmt::print("focal lengths {:.1f} and {:.1f} px, baseline {:.2f} mm\n", found.left.matrix(0, 0),
             found.right.matrix(0, 0), 1000.0 * cv::norm(found.translation_m));
  fmt::print(
      "{}: written; the robot's settings name it: pioneer: {{camera: {{calibration: {}}}}}\n",
      options.out, options.out);
  return 0;
}

}  // namespace

void add_calibrate_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<CalibrateOptions>();
  CLI::App* command = app.add_subcommand(
      "calibrate",
      "Finds lenses and pose of a stereo camera from chessboard pairs, and tells how exact it is.\n"
      "Example: striate calibrate images --columns 9 --rows 6 --square-mm 25 --out stereo.yaml");
  command
      ->add_option("folder", options->folder, "with left/*.png and right/*.png of the same names")
      ->type_name("FOLDER")
      ->required();
  command->add_option("--columns", options->board.columns, "corners inside the board, a row")
      ->check(CLI::Range(3, 50))
      ->capture_default_str();
  command->add_option("--rows", options->board.rows, "rows of corners")
      ->check(CLI::Range(3, 50))
      ->capture_default_str();
  command->add_option("--square-mm", options->square_mm, "side of a square")
      ->check(CLI::Range(1.0, 1000.0))
      ->capture_default_str();
  command->add_option("--out", options->out, "file for the calibration")->capture_default_str();
  command->add_flag("--side-by-side", options->side_by_side,
                    "each image in the folder shows both eyes");
  command->add_flag("--swap", options->swap, "right and left are exchanged");
  command->callback([options, &exit_code] { exit_code = calibrate(*options); });
}

}  // namespace striate::app
