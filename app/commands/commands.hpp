#pragma once

#include <CLI/CLI.hpp>

/// Each subcommand of `striate` adds itself to the command line; its callback sets the exit code:
/// 0 success, 1 mission failed or world broke, 2 a mistake of the user's, 130 interrupted.
namespace striate::app {

void add_run_command(CLI::App& app, int& exit_code);
void add_replay_command(CLI::App& app, int& exit_code);
void add_export_command(CLI::App& app, int& exit_code);
void add_recall_command(CLI::App& app, int& exit_code);
void add_trial_command(CLI::App& app, int& exit_code);
void add_perceive_command(CLI::App& app, int& exit_code);
void add_recognise_command(CLI::App& app, int& exit_code);
void add_odometry_command(CLI::App& app, int& exit_code);
void add_sim_command(CLI::App& app, int& exit_code);
void add_world_command(CLI::App& app, int& exit_code);
void add_task_command(CLI::App& app, int& exit_code);
void add_drive_command(CLI::App& app, int& exit_code);
void add_calibrate_command(CLI::App& app, int& exit_code);
void add_doctor_command(CLI::App& app, int& exit_code);
void add_check_command(CLI::App& app, int& exit_code);
void add_config_command(CLI::App& app, int& exit_code);
void add_ros_command(CLI::App& app, int& exit_code);
void add_eval_command(CLI::App& app, int& exit_code);
void add_learn_descriptor_command(CLI::App& app, int& exit_code);
void add_teach_command(CLI::App& app, int& exit_code);
void add_memory_command(CLI::App& app, int& exit_code);
void add_view_command(CLI::App& app, int& exit_code);
/// Explains all the others, so it comes last.
void add_help_command(CLI::App& app, int& exit_code);

}  // namespace striate::app
