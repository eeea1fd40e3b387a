#include "app/accuracy_source.h"

#include <spdlog/spdlog.h>

#include "base/cpu_name.h"

namespace saccade {
namespace {

// Reads the table; returns why it cannot be used, or nothing.
std::string readTable(const std::string& path, AccuracyTable& table) {
  if (path.empty()) return "this server has no table of accuracy";
  try {
    table = readAccuracyTable(path);
  } catch (const std::runtime_error& fault) {
    if (path != defaultAccuracyTable()) throw;
    spdlog::warn(fault.what());
    return "this server's table of accuracy cannot be read";
  }
  if (table.cpu == cpuName()) return {};
  return "this server's table of accuracy is of another CPU: " + table.cpu + ", not " + cpuName();
}

}  // namespace

v1::BudgetInfo AccuracySource::info() const {
  v1::BudgetInfo info;
  info.set_unavailable(unavailable);
  if (!unavailable.empty()) return info;
  info.set_measured_on(table.settings);
  for (const std::string& scene : table.scenes()) info.add_scenes(scene);
  return info;
}

AccuracySource openAccuracySource(const std::string& path) {
  AccuracySource source;
  source.unavailable = readTable(path, source.table);
  if (source.unavailable.empty()) {
    spdlog::info("budgets are answered from {}", path);
  } else {
    source.unavailable += "; run `saccade-eval chart --quick` on its machine and start it again";
    spdlog::info("no budgets: {}", source.unavailable);
  }
  return source;
}

}  // namespace saccade
