#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace striate::config {

/// What a configuration file holds: each kind has its folder in a configuration.
enum class FileKind { task, world, robot, any };

/// "tasks", "worlds", "robots"; several for `any`, in the order in which they are searched.
[[nodiscard]] std::vector<std::string> folders_of(FileKind kind);

/// A folder that holds a configuration (`tasks/`, `worlds/`, `robots/`), or would hold one.
struct ConfigurationFolder {
  std::filesystem::path path;
  std::string what;  ///< for a person: "beside the program"
};

/// Where configurations are looked for, in this order, whether they are there or not:
/// `config` beside the program, `../share/striate/config` from its folder (an installation), and
/// `$XDG_CONFIG_HOME/striate`, which is `~/.config/striate` where that variable says nothing.
/// The shipped files come first, so that a command in a document does the same for everybody; a
/// file of your own needs a name of its own, or its path.
[[nodiscard]] const std::vector<ConfigurationFolder>& configuration_folders();

/// The same for a program in `program_folder`.
/// @param xdg_config_home, home as in the environment; nullptr or empty: not set. A relative
///   `$XDG_CONFIG_HOME` does not count, as its specification demands.
[[nodiscard]] std::vector<ConfigurationFolder> configuration_folders_of(
    const std::filesystem::path& program_folder, const char* xdg_config_home, const char* home);

/// Every path that `given` may mean, in the order in which they are looked at: first as given,
/// relative to the working directory. Only two kinds of names mean more: those that begin with
/// `config/`, and bare ones ("corridor.yaml", "corridor"), which stand in the folder of their kind.
/// ".yaml" may be left out.
[[nodiscard]] std::vector<std::filesystem::path> meanings_of(
    const std::string& given, FileKind kind, const std::vector<ConfigurationFolder>& folders);

/// The file that such a name means in the folders alone, not in the working directory; "": none.
[[nodiscard]] std::string find_in_configuration(
    const std::string& given, FileKind kind,
    const std::vector<ConfigurationFolder>& folders = configuration_folders());

/// The first of meanings_of() at which there is a file; "" stays "". A path that has no other
/// meaning is returned as it is: reading it says what is wrong with it.
/// @throws UserError with every place that was looked at where there is none.
[[nodiscard]] std::string find_configuration(
    const std::string& given, FileKind kind,
    const std::vector<ConfigurationFolder>& folders = configuration_folders());

}  // namespace striate::config
