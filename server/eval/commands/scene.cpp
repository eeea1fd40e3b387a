// `saccade-eval scene` tells what of a scene's file is read, and what it takes.
#include <chrono>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <utility>

#include "base/mebibyte.h"
#include "base/thread_time.h"
#include "eval/bench/open_scene.h"
#include "eval/bench/scene_report.h"
#include "eval/commands/commands.h"
#include "eval/pictures/text.h"

namespace saccade::eval {
namespace {

void print(const std::string& text) {
  std::fputs(text.c_str(), stdout);
}

void runScene(const std::string& name) {
  const auto started = processCpuTime();
  std::vector<std::string> faults;
  std::optional<Scene> scene = inspectScene(name, faults);
  if (scene) print(sceneReport(*scene));
  for (const std::string& fault : faults) print(reportLine("fault", fault));
  if (!scene) throw std::runtime_error(name + " cannot be opened at all");
  if (!faults.empty())
    throw std::runtime_error(name + " does not open: leave out or replace what has a fault (" +
                             std::to_string(faults.size()) + "); scenes/README.md lists what is supported");
  const RenderScene built(std::move(*scene));
  const double cpu_s = std::chrono::duration<double>(processCpuTime() - started).count();
  print(reportLine("memory", format("%.1f MiB, with the tree for tracing rays",
                                    static_cast<double>(built.bytes()) / kMiB)));
  print(reportLine("time", format("%.2f s of CPU to read it and to build the tree", cpu_s)));
}

}  // namespace

void addSceneCommand(CLI::App& app) {
  auto name = std::make_shared<std::string>();
  auto* command = app.add_subcommand("scene", "tell what of a scene is read, what is not, and what it takes");
  command->add_option("scene", *name, "a scene by name, or by the path of its file or folder")->required();
  command->callback([name] { runScene(*name); });
}

}  // namespace saccade::eval
