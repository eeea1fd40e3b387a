// # cpu="AMD EPYC" size=128x128 threshold=0.2 ...                  of all rows; only cpu is compared
// scene,bounces,disabled,cpu_ms,false_events,missed_events,changed,noise
// kitchen,2,textures+masks,12.5,0.001,0.002,0.03,0.004
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "saccade/wire/ranges.h"
#include "tables/simplification_table.h"
#include "tables/table_file.h"

namespace saccade {
namespace {

SceneFeatures readFeatures(const TableFile& file) {
  SceneFeatures features;
  std::istringstream names(file.field("disabled"));
  for (std::string name; std::getline(names, name, '+');) {
    const SceneFeatureInfo* info = findFeature(name);
    if (!info)
      file.fail("disabled: no scene feature is named \"" + name + "\"; there are: " + featureNames());
    features.insert(info->feature);
  }
  return features;
}

std::string joined(const SceneFeatures& features) {
  std::string text;
  for (const std::string& name : namesOf(features)) text += (text.empty() ? "" : "+") + name;
  return text;
}

MeasuredModel readRow(const TableFile& file) {
  return {.scene = file.field("scene"),
          .model = {file.integer("bounces", ranges::kBounces.min, ranges::kBounces.max), readFeatures(file)},
          .cpu_ms = file.number("cpu_ms", 0, 1e9),
          .false_events = file.number("false_events", 0, 1e9),
          .missed_events = file.number("missed_events", 0, 1e9),
          .changed = file.number("changed", 0, 1e9),
          .noise = file.number("noise", 0, 1e9)};
}

}  // namespace

SimplificationTable readSimplificationTable(const std::string& path) {
  TableFile file(path, "table of `saccade-eval simplification`; it begins with # cpu=\"...\"");
  SimplificationTable table;
  table.settings = file.settings();
  table.cpu = file.field("cpu");
  file.readColumns(
      {"scene", "bounces", "disabled", "cpu_ms", "false_events", "missed_events", "changed", "noise"});
  while (file.nextRow()) {
    table.rows.push_back(readRow(file));
    const MeasuredModel& row = table.rows.back();
    if (table.modelsOf(row.scene).size() == 1 && (!row.model.disabled_features.empty() || row.changed != 0))
      file.fail("the first row of " + row.scene + " must be its whole model, with changed 0");
  }
  if (table.rows.empty()) file.fail("no row: nothing is measured");
  return table;
}

void writeSimplificationTable(const std::string& path, const SimplificationTable& table) {
  if (const auto folder = std::filesystem::path(path).parent_path(); !folder.empty())
    std::filesystem::create_directories(folder);
  std::ofstream file(path);
  file << "# " << table.settings
       << "\nscene,bounces,disabled,cpu_ms,false_events,missed_events,changed,noise\n";
  for (const MeasuredModel& row : table.rows) {
    file << row.scene << ',' << row.model.bounces << ',' << joined(row.model.disabled_features) << ','
         << row.cpu_ms << ',' << row.false_events << ',' << row.missed_events << ',' << row.changed << ','
         << row.noise << '\n';
  }
  if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

}  // namespace saccade
