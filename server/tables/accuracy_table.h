// The table of `saccade-eval chart`: the CPU time and the accuracy of each setting of the methods on one
// machine. Chooses a setting from it.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "methods/method_spec.h"
#include "tables/time_model.h"

namespace saccade {

struct MeasuredSetting {
  std::string scene;
  MethodSpec method;
  int spp = 0;
  double cpu_ms = 0;  // per frame, over all threads, of tracing and filter; without sensors
  double false_events = 0, missed_events = 0;  // per pixel-frame
  double small_ms = MeasuredTime{}.small_ms;   // as in MeasuredTime, where cpu_ms is first_ms
  double small_late_ms = MeasuredTime{}.small_late_ms;

  std::string text() const;  // "svgf:as_falcor=1 at 4 spp"
};

struct AccuracyTable {
  std::string settings;  // of all rows, as in the file: "cpu=... trajectory=... size=..."
  std::string cpu;       // cpuName() of the machine
  int width = 0, height = 0;
  int frames = 0;  // over which cpu_ms is a mean; 0: not known
  int bounces = 0;
  double threshold = 0;  // C of the event rates, natural log units
  std::vector<MeasuredSetting> rows;

  std::vector<std::string> scenes() const;  // sorted
};

// The file of `saccade-eval chart`. Throws std::runtime_error naming file and line.
AccuracyTable readAccuracyTable(const std::string& path);

// The default path of the file.
std::string defaultAccuracyTable();

// A client's wish for rendering.
struct SettingsQuery {
  std::string scene;
  double pixels = 0;     // of a frame
  double threshold = 0;  // C, natural log units
  std::string method;    // empty: any
  double frames = 0;     // of the stream; may be infinite. At most those of the table: its own time
};

// The table has no setting for a query; what() lists what it has.
struct NotMeasured : std::runtime_error {
  using runtime_error::runtime_error;
};

// No setting keeps a limit; what() names the nearest.
struct NothingFits : std::runtime_error {
  using runtime_error::runtime_error;
};

// The settings measured for the scene and the method of the query, which it compares by name alone. Time is
// scaled as time_model.h says, event rates by 1 / C [E (34)]; trajectory and bias are not compared. Never
// empty. Throws NotMeasured.
std::vector<MeasuredSetting> settingsFor(const AccuracyTable& table, const SettingsQuery& rendering);

// The setting with the fewest false and missed events in at most `budget_ms` of CPU time a frame. Throws
// NothingFits.
MeasuredSetting mostAccurate(const std::vector<MeasuredSetting>& settings, double budget_ms);

// The setting with the least CPU time and at most `max_false_rate` false events per pixel-frame. Throws
// NothingFits.
MeasuredSetting fastest(const std::vector<MeasuredSetting>& settings, double max_false_rate);

}  // namespace saccade
