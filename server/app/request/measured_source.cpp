#include "app/request/measured_source.h"

#include <spdlog/spdlog.h>

#include "base/cpu_name.h"

namespace saccade {
namespace {

// A kind of table.
template <class Table>
struct Kind {
  std::string name, answers, command;  // for people: what it is, what it is for, what makes it
  std::string default_path;
  Table (*read)(const std::string& path);
};

// Reads the table; returns why it cannot be used, or nothing.
template <class Table>
std::string readTable(const Kind<Table>& kind, const std::string& path, Table& table) {
  if (path.empty()) return "this server has no " + kind.name;
  try {
    table = kind.read(path);
  } catch (const std::runtime_error& fault) {
    if (path != kind.default_path) throw;
    spdlog::warn(fault.what());
    return "this server's " + kind.name + " cannot be read";
  }
  if (table.cpu == cpuName()) return {};
  return "this server's " + kind.name + " is of another CPU: " + table.cpu + ", not " + cpuName();
}

template <class Table>
MeasuredSource<Table> openSource(const Kind<Table>& kind, const std::string& path) {
  MeasuredSource<Table> source;
  source.unavailable = readTable(kind, path, source.table);
  if (source.unavailable.empty()) {
    spdlog::info("{} are answered from {}", kind.answers, path);
  } else {
    source.unavailable += "; run `" + kind.command + "` on its machine and start it again";
    spdlog::info("no {}: {}", kind.answers, source.unavailable);
  }
  return source;
}

}  // namespace

template <class Table>
v1::BudgetInfo MeasuredSource<Table>::info() const {
  v1::BudgetInfo info;
  info.set_unavailable(unavailable);
  if (!unavailable.empty()) return info;
  info.set_measured_on(table.settings);
  for (const std::string& scene : table.scenes()) info.add_scenes(scene);
  return info;
}
template struct MeasuredSource<AccuracyTable>;
template struct MeasuredSource<SimplificationTable>;

AccuracySource openAccuracySource(const std::string& path) {
  return openSource<AccuracyTable>({"table of accuracy", "budgets", "saccade-eval chart --quick",
                                    defaultAccuracyTable(), readAccuracyTable},
                                   path);
}

SimplificationSource openSimplificationSource(const std::string& path) {
  return openSource<SimplificationTable>(
      {"simplification table", "simplification", "saccade-eval simplification", defaultSimplificationTable(),
       readSimplificationTable},
      path);
}

}  // namespace saccade
