#include <array>
#include <cstdio>
#include <filesystem>

#include "base/default_cache.h"
#include "farm/commands/commands.h"
#include "scene/library/find_scenes.h"
#include "tables/accuracy_table.h"
#include "tables/simplification_table.h"

namespace saccade::farm {
namespace {

std::string ifThere(const std::string& path) {
  return std::filesystem::exists(path) ? path : "";
}

std::string shortNumber(double number) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), number < 10 ? "%.1f" : "%.0f", number);
  return text.data();
}

}  // namespace

RenderSettings defaultRender() {
  return {.scenes = findScenes(),
          .meshes = kDefaultMeshes,
          .bakes = defaultCache() + "/bakes",
          .accuracy = ifThere(defaultAccuracyTable()),
          .simplification = ifThere(defaultSimplificationTable())};
}

void addRenderOptions(CLI::App& command, RenderSettings& settings) {
  command.add_option("--scenes", settings.scenes, "folder with a folder for each scene")
      ->check(CLI::ExistingDirectory)
      ->capture_default_str();
  command
      .add_option("--meshes", settings.meshes, "folders of meshes that scenes do not hold, with : between")
      ->capture_default_str();
  command.add_option("--bakes", settings.bakes, "folder for light that is computed ahead")
      ->capture_default_str();
}

void addTableOptions(CLI::App& command, RenderSettings& settings) {
  command
      .add_option("--accuracy", settings.accuracy,
                  "table for budget-ms and max-false-rate: results.csv of `saccade-eval chart`")
      ->check(CLI::ExistingFile)
      ->default_str(settings.accuracy);
  command
      .add_option("--simplification", settings.simplification,
                  "table for max-event-change, of `saccade-eval simplification`")
      ->check(CLI::ExistingFile)
      ->default_str(settings.simplification);
}

void addFolderOption(CLI::App& command, std::string& folder) {
  command.add_option("dataset", folder, "folder of the data set, which `saccade-farm plan` made")->required();
}

std::string bytesText(double bytes) {
  constexpr std::array<const char*, 5> kUnits{"B", "kB", "MB", "GB", "TB"};
  std::size_t unit = 0;
  for (; bytes >= 1000 && unit + 1 < kUnits.size(); ++unit) bytes /= 1000;
  return shortNumber(bytes) + " " + kUnits[unit];
}

std::string hoursText(double seconds) {
  if (seconds >= 3600) return shortNumber(seconds / 3600) + " h";
  return seconds >= 60 ? shortNumber(seconds / 60) + " min" : shortNumber(seconds) + " s";
}

}  // namespace saccade::farm
