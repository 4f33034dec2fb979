#pragma once

#include <cstddef>

#include "striate/agent/plugins/body_registry.hpp"
#include "striate/base/version.hpp"
#include "striate/behaviours/registry.hpp"
#include "striate/perception/stage.hpp"
#include "striate/tasks/condition.hpp"

/// What a plugin includes: docs/plugins.md.
namespace striate::agent {

/// Counts up when PluginInfo, PluginRegistrar or one of the entries changes.
inline constexpr int kPluginInterface = 2;

/// What a plugin adds to the program: names that nobody has yet. Nothing is added before all of the
/// plugin was found good.
class PluginRegistrar {
 public:
  virtual void add(behaviours::BehaviourEntry entry) = 0;
  virtual void add(tasks::ConditionEntry entry) = 0;
  virtual void add(perception::StageEntry entry) = 0;
  virtual void add(BodyEntry entry) = 0;

 protected:
  ~PluginRegistrar() = default;
};

/// What a plugin says about itself. Only `interface` is read before it is known to be ours.
struct PluginInfo {
  int interface;                ///< kPluginInterface of the headers it was compiled with
  const char* striate_version;  ///< kVersion of them
  const char* compiler_abi;     ///< kCompilerAbi
  unsigned long layout;         ///< kPluginLayout
  const char* name;             ///< what people call it: "wave"
  void (*enroll)(PluginRegistrar&);
};

#define STRIATE_TEXT_OF(x) #x
#define STRIATE_TEXT(x) STRIATE_TEXT_OF(x)
/// What C++ objects look like between two compilers: the Itanium ABI and the kind of std::string.
inline constexpr const char* kCompilerAbi =
    "C++ ABI " STRIATE_TEXT(__GXX_ABI_VERSION) ", strings " STRIATE_TEXT(_GLIBCXX_USE_CXX11_ABI);
#undef STRIATE_TEXT
#undef STRIATE_TEXT_OF

/// A fingerprint of the sizes of what is handed over, which differ where the headers do: between
/// two commits that have the same version, for example.
inline constexpr unsigned long kPluginLayout = [] {
  unsigned long mixed = 5381;  // Bernstein's hash (djb2)
  for (const std::size_t size :
       {sizeof(behaviours::BehaviourEntry), sizeof(behaviours::Wish), sizeof(tasks::ConditionEntry),
        sizeof(perception::StageEntry), sizeof(perception::Percept), sizeof(BodyEntry),
        sizeof(memory::ShortTermMemory), sizeof(RobotDescription), sizeof(Senses),
        sizeof(MotorCommand), sizeof(config::Node), sizeof(config::Diagnostics)}) {
    mixed = mixed * 33 + size;
  }
  return mixed;
}();

}  // namespace striate::agent

/// Makes a shared object a plugin: once in it, outside of any namespace.
/// @param enroll_function of type void(striate::agent::PluginRegistrar&)
#define STRIATE_PLUGIN(plugin_name, enroll_function)                                       \
  extern "C" __attribute__((visibility("default"))) const striate::agent::PluginInfo*      \
  striate_plugin() {                                                                       \
    static constexpr striate::agent::PluginInfo info{                                      \
        striate::agent::kPluginInterface, striate::kVersion, striate::agent::kCompilerAbi, \
        striate::agent::kPluginLayout,    plugin_name,       enroll_function};             \
    return &info;                                                                          \
  }
