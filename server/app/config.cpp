#include "app/config.h"

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <filesystem>

#include "base/tile_pool.h"
#include "methods/accuracy_table.h"

namespace saccade {

Config parseConfig(int argc, const char* const* argv) {
  Config config;
  CLI::App app("saccaded: renders scenes, and streams what an event camera would see of them");
  app.add_option("--control", config.control, "endpoint for requests")->capture_default_str();
  app.add_option("--data", config.data, "endpoint for streams with credit")->capture_default_str();
  app.add_option("--broadcast", config.broadcast, "endpoint for broadcast streams")->capture_default_str();
  app.add_option("--threads", config.threads, "threads that render; 0: one per core")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  app.add_option("--scenes", config.scenes, "folder of the scenes")->check(CLI::ExistingDirectory);
  app.add_option(
         "--accuracy", config.accuracy,
         "results.csv of `saccade-eval chart`, which budgets of streams are answered from; default: " +
             defaultAccuracyTable() + ", if it is there")
      ->check(CLI::ExistingFile);
  app.add_option("--log-level", config.log_level)
      ->check(CLI::IsMember({"trace", "debug", "info", "warning", "error", "critical", "off"}))
      ->capture_default_str();
  app.set_version_flag("--version", SACCADE_VERSION);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& fault) {
    std::exit(app.exit(fault));
  }
  if (config.threads == 0) config.threads = hardwareThreads();
  if (config.scenes.empty()) config.scenes = findScenes();
  std::error_code none;
  if (config.accuracy.empty() && std::filesystem::exists(defaultAccuracyTable(), none)) {
    config.accuracy = defaultAccuracyTable();
  }
  return config;
}

std::string findScenes() {
  std::error_code none;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", none);
  const auto installed = program.parent_path().parent_path() / "share/saccade/scenes";
  return std::filesystem::is_directory(installed, none) ? installed.string() : SACCADE_SCENES;
}

}  // namespace saccade
