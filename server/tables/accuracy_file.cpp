// # cpu="AMD EPYC" size=128x128 bounces=3 threshold=0.2 ...    of all rows; other keys are only reported
// scene,method,spp,cpu_ms,false_events,missed_events,...       in any order, among others; small_ms and
//                                                              small_late_ms may be there
// cornell-box,svgf:as_falcor=1,4,12.5,0.013,0.021,...
#include <algorithm>
#include <cstdio>

#include "saccade/wire/ranges.h"
#include "tables/accuracy_table.h"
#include "tables/table_file.h"

namespace saccade {
namespace {

void readSettings(const TableFile& file, AccuracyTable& table) {
  table.settings = file.settings();
  table.cpu = file.field("cpu");
  char rest = 0;
  if (std::sscanf(file.field("size").c_str(), "%dx%d%c", &table.width, &table.height, &rest) != 2 ||
      std::min(table.width, table.height) < 1) {
    file.fail("size is \"" + file.field("size") + "\", not WxH");
  }
  if (file.has("frames") &&
      (std::sscanf(file.field("frames").c_str(), "%*d:%d%c", &table.frames, &rest) != 1 || table.frames < 1))
    file.fail("frames is \"" + file.field("frames") + "\", not A:B");
  table.bounces = file.integer("bounces", ranges::kBounces.min, ranges::kBounces.max);
  table.threshold = file.number("threshold", ranges::kThreshold.min, ranges::kThreshold.max);
}

MeasuredSetting readRow(const TableFile& file) {
  MeasuredSetting row;
  row.scene = file.field("scene");
  try {
    row.method = parseMethod(file.field("method"));
  } catch (const std::runtime_error& fault) {
    file.fail(fault.what());
  }
  row.spp = file.integer("spp", ranges::kSpp.min, ranges::kSpp.max);
  if (!row.method.takes(row.spp)) file.fail(row.method.name + " cannot run at " + file.field("spp") + " spp");
  row.cpu_ms = file.number("cpu_ms", 0, 1e9);
  if (file.has("small_ms")) row.small_ms = file.number("small_ms", 0, 1e9);
  if (file.has("small_late_ms")) row.small_late_ms = file.number("small_late_ms", 0, 1e9);
  row.false_events = file.number("false_events", 0, 1e9);
  row.missed_events = file.number("missed_events", 0, 1e9);
  return row;
}

}  // namespace

AccuracyTable readAccuracyTable(const std::string& path) {
  TableFile file(path, "chart's results; they begin with # cpu=\"...\" size=WxH bounces=N threshold=C");
  AccuracyTable table;
  readSettings(file, table);
  file.readColumns({"scene", "method", "spp", "cpu_ms", "false_events", "missed_events"});
  while (file.nextRow()) table.rows.push_back(readRow(file));
  if (table.rows.empty()) file.fail("no row: nothing is measured");
  return table;
}

}  // namespace saccade
