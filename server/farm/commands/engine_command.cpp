#include "farm/commands/engine_command.h"

#include <cstdio>
#include <filesystem>
#include <sstream>

#include "farm/commands/commands.h"
#include "farm/dataset/json_file.h"
#include "farm/recipe/recipe.h"

namespace saccade::farm {
namespace {

namespace fs = std::filesystem;

std::string absolutePaths(const std::string& paths) {
  std::istringstream input(paths);
  std::string absolute, path;
  while (std::getline(input, path, ':'))
    absolute += (absolute.empty() ? "" : ":") + fs::absolute(path).string();
  return absolute;
}

}  // namespace

void addCommonOptions(CLI::App& command, EngineCommand& options) {
  addFolderOption(command, options.folder);
  command.add_option("-o,--output", options.output, "file to write; otherwise the text is printed");
  command.add_option("--cpus", options.engine.cpus, "CPUs of a task")
      ->check(CLI::Range(1, kMostCpus))
      ->capture_default_str();
  command.add_option("--memory", options.engine.memory_mib, "memory of a task, in MiB")
      ->check(CLI::Range(1, kMostMemoryMib))
      ->capture_default_str();
  command.add_option("--retries", options.engine.retries, "how often a task that fails runs again")
      ->check(CLI::Range(0, kMostRetries))
      ->capture_default_str();
  command.add_option("--scenes", options.scenes, "folder of scenes for the workers");
  command.add_option("--meshes", options.meshes, "folders of meshes for the workers, with : between");
  command.add_option("--bakes", options.bakes, "folder of bakes for the workers");
}

void addParallelOption(CLI::App& command, EngineCommand& options) {
  command
      .add_option("--parallel", options.engine.parallel,
                  "tasks at a time, at most; 0: as many as there is room for")
      ->check(CLI::Range(0, static_cast<int>(kMostShards)))
      ->capture_default_str();
}

void addProgramOption(CLI::App& command, EngineCommand& options) {
  options.engine.program = fs::read_symlink("/proc/self/exe");
  command.add_option("--program", options.engine.program, "saccade-farm on the machines of the workers")
      ->capture_default_str();
}

EngineOptions engineOf(const EngineCommand& options, bool here) {
  EngineOptions engine = options.engine;
  const auto add = [&](const char* option, const std::string& paths) {
    if (paths.empty()) return;
    engine.render.emplace_back(option);
    engine.render.push_back(here ? absolutePaths(paths) : paths);
  };
  add("--scenes", options.scenes);
  add("--meshes", options.meshes);
  add("--bakes", options.bakes);
  if (here) engine.program = fs::absolute(engine.program);
  return engine;
}

void writeEngine(const EngineCommand& options, const std::string& text) {
  if (options.output.empty()) {
    std::fwrite(text.data(), 1, text.size(), stdout);
  } else {
    writeText(options.output, text);
  }
}

}  // namespace saccade::farm
