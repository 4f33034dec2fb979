#include "striate/tasks/task_reader.hpp"

#include <filesystem>

#include "striate/config/yaml.hpp"
#include "striate/tasks/reader/script_reader.hpp"

namespace striate::tasks {
namespace {

using config::Diagnostics;
using config::Node;

Task read(Node root, ReadContext& context, const GivenVariables& given, Diagnostics& diagnostics) {
  std::error_code code;
  const std::string path = std::filesystem::weakly_canonical(diagnostics.file(), code).string();
  context.files.push_back({path, path});
  context.read = context.files;
  Variables variables;
  for (const auto& [name, text] : given) {
    Variable& variable = variables[name];
    variable.value.kind = Node::Kind::scalar;
    variable.value.text = text;
    variable.origin = "given from outside";
  }
  Task task = std::move(ScriptReader(context, variables, diagnostics).read(std::move(root)).task);
  task.files = context.read;
  return task;
}

Task load(const std::string& file, ReadContext& context, const GivenVariables& given) {
  Diagnostics diagnostics(file, 'T');
  Task task = read(load_yaml(diagnostics), context, given, diagnostics);
  diagnostics.throw_if_any();
  return task;
}

}  // namespace

Task load_task(const std::string& file, const RobotDescription& robot, const GivenVariables& given,
               const KnownLandmarks* landmarks) {
  ReadContext context(robot);
  context.landmarks = landmarks;
  return load(file, context, given);
}

Task check_task(const std::string& file, const RobotDescription& robot,
                const KnownLandmarks* landmarks) {
  ReadContext context(robot);
  context.landmarks = landmarks;
  context.parameters_stay_open = true;
  return load(file, context, {});
}

Task read_task(const std::string& text, Diagnostics& diagnostics, const RobotDescription& robot,
               const GivenVariables& given) {
  ReadContext context(robot);
  return read(parse_yaml(text, diagnostics), context, given, diagnostics);
}

}  // namespace striate::tasks
