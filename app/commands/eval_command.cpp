#include <memory>

#include "striate/app/commands/commands.hpp"
#include "striate/app/commands/eval_odometry_command.hpp"
#include "striate/app/commands/eval_places_command.hpp"
#include "striate/base/files.hpp"
#include "striate/evaluation/evaluation.hpp"

namespace striate::app {
namespace {

struct EvaluationKind {
  const char* name;
  const char* help;  ///< what is measured, and the layout of the folder
  int (*evaluate)(const evaluation::EvalOptions&);
};

/// What can be measured; each has its own file in evaluation/.
constexpr EvaluationKind kEvaluations[] = {
    {"stereo",
     "Disparities at 160x120 and 320x240, clean, disturbed and with rows off, beside StereoBM and\n"
     "StereoSGBM, the latter with a filter by weighted least squares, too.\n"
     "Folders in or below the given one that hold imL.png, imR.png, groundtruth.png (4 per px),\n"
     "nonocc.png (Middlebury 2003); view1.png, view5.png, disp1.png, disp5.png (3 per px; 2006);\n"
     "im0.png, im1.png, disp0.pfm (2014); or left.png, right.png, disparity.pfm.",
     evaluation::evaluate_stereo},
    {"keypoints",
     "Repeatability of keypoints in images of flat scenes; ORB, BRISK, AKAZE and SIFT beside.\n"
     "Folder, or its subfolders: img1.ppm, img2.ppm, H1to2p, ... (Oxford)\n"
     "or 1.ppm, 2.ppm, H_1_2, ... (HPatches); also pgm, png, jpg, bmp",
     evaluation::evaluate_keypoints},
    {"patches",
     "ROC of descriptors on true and false patch pairs. Folder: sequences with img1.* and H1to2p\n"
     "(Oxford) or 1.* and H_1_2 (HPatches), or info.txt, m50_*.txt and mosaics (Brown/Winder)",
     evaluation::evaluate_patches},
    {"objects",
     "Objects found in scenes; ORB, BRISK and SIFT beside.\n"
     "Folder: objects/NAME/*.png, scenes/*.png, truth.json ({\"scene\": [\"NAME\", ...]});\n"
     "or JSK ARC 2017; or pairs NAME.png, NAME_in_scene.png",
     evaluation::evaluate_objects},
    {"saliency",
     "Saliency against eye fixations: AUC-Judd, NSS, CC.\n"
     "FOLDER/fixations.csv: image,subject,order,x,y,duration_ms; images beside it or in stimuli/",
     evaluation::evaluate_saliency},
};

}  // namespace

void add_eval_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand(
      "eval",
      "Measures the vision on your own data, beside OpenCV's methods in the same run;\n"
      "prints a table and writes it as CSV and as a plot (SVG).");
  command->require_subcommand(1);
  for (const EvaluationKind& kind : kEvaluations) {
    auto options = std::make_shared<evaluation::EvalOptions>();
    options->out = std::string("out/eval_") + kind.name;
    CLI::App* one = command->add_subcommand(kind.name, kind.help);
    one->add_option("folder", options->folder, "the data")->type_name("FOLDER")->required();
    one->add_option("--out", options->out, "folder for the CSV file and the plot")
        ->type_name("FOLDER")
        ->capture_default_str();
    one->callback([options, &exit_code, evaluate = kind.evaluate] {
      make_folder(options->out);
      exit_code = evaluate(*options);
    });
  }
  add_eval_odometry(*command, exit_code);
  add_eval_places(*command, exit_code);
}

}  // namespace striate::app
