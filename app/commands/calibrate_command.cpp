#include <fmt/format.h>

#include <memory>

#include "striate/app/commands/commands.hpp"
#include "striate/base/files.hpp"
#include "striate/base/user_error.hpp"
#include "striate/evaluation/calibration/board_images.hpp"
#include "striate/evaluation/calibration/calibrate_stereo.hpp"
#include "striate/platform/datasets/images/read_image.hpp"

namespace striate::app {
namespace {

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

Looks look_at_all(const evaluation::BoardFolder& folder, const CalibrateOptions& options) {
  Looks looks;
  for (const evaluation::BoardFiles& files : folder.looks) {
    if (files.right.empty()) {
      const auto [left, right] = datasets::read_side_by_side(files.left);
      look(files.name, left, right, options, looks);
    } else {
      const auto [left, right] = datasets::read_grey_pair(files.left, files.right);
      look(files.name, left, right, options, looks);
    }
  }
  return looks;
}

void print_report(const evaluation::CalibrationReport& report) {
  for (const evaluation::PairError& pair : report.pairs) {
    fmt::print("{}: reprojection {:.3f} px, rectification {:.3f} px\n", pair.name,
               pair.reprojection_px, pair.epipolar_px);
  }
  for (const evaluation::PairError& pair : report.left_out) {
    fmt::print("{}: LEFT OUT, it does not agree with the others: {:.1f} px away from them\n",
               pair.name, pair.reprojection_px);
  }
  const pioneer::StereoCalibration& found = report.calibration;
  fmt::print("{} pairs of {} x {} px: reprojection {:.3f} px, rectification {:.3f} px (rms)\n",
             found.pairs, found.size_px.width, found.size_px.height, found.reprojection_px,
             found.epipolar_px);
  fmt::print("focal lengths {:.1f} and {:.1f} px, baseline {:.2f} mm\n", found.left.matrix(0, 0),
             found.right.matrix(0, 0), 1000.0 * cv::norm(found.translation_m));
}

/// On standard error, where whoever keeps the output in a file sees it.
void warn(const evaluation::CalibrationReport& report) {
  if (!report.left_out.empty()) {
    fmt::print(stderr,
               "warning: {} of {} pairs left out, since they do not agree with the others: {}\n",
               report.left_out.size(), report.left_out.size() + report.pairs.size(),
               evaluation::worst_of(report.left_out));
  }
  const double error_px = pioneer::error_px(report.calibration);
  if (pioneer::exactness_of(error_px) != pioneer::Exactness::poor) return;
  fmt::print(stderr,
             "warning: it errs by {:.2f} px, below 0.5 px is usual: distances will be wrong; the "
             "worst pairs: {}\n",
             error_px, evaluation::worst_of(report.pairs));
}

int calibrate(const CalibrateOptions& given) {
  CalibrateOptions options = given;
  options.board.square_m = options.square_mm / 1000.0;
  check_writable(options.out);
  const evaluation::BoardFolder folder =
      evaluation::find_board_images(options.folder, options.side_by_side);
  for (const std::string& name : folder.unpaired) {
    fmt::print(stderr, "warning: {}: the other eye has no image of that name; it is left out\n",
               name);
  }
  const Looks looks = look_at_all(folder, options);
  for (const std::string& name : looks.without_board) {
    fmt::print("{}: the whole board is not seen in both images\n", name);
  }
  const evaluation::CalibrationReport report =
      evaluation::calibrate_stereo(looks.pairs, options.board, looks.size_px);
  print_report(report);
  warn(report);
  pioneer::write_calibration(options.out, report.calibration);
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
      "Pairs that do not agree with the others are named and left out; above 1 px of error it "
      "warns,\n"
      "above 3 px nothing is written and the exit code is 2.\n"
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
