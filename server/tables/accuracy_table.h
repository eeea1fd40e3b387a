// What every setting of the methods costs and how right it is, as `saccade-eval chart` measured it on one
// machine; and which of them to take.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "methods/method_spec.h"

namespace saccade {

struct MeasuredSetting {
  std::string scene;
  MethodSpec method;
  int spp = 0;
  double cpu_ms = 0;  // per frame, over all threads, of tracing and filter; sensors come on top
  double false_events = 0, missed_events = 0;  // per pixel-frame

  std::string text() const;  // "svgf:as_falcor=1 at 4 spp"
};

struct AccuracyTable {
  std::string settings;  // all that the rows share, as the file says it: "cpu=... trajectory=... size=..."
  std::string cpu;       // as cpuName() says it
  int width = 0, height = 0;
  int bounces = 0;
  double threshold = 0;  // C of the event rates, natural log units
  std::vector<MeasuredSetting> rows;

  std::vector<std::string> scenes() const;  // sorted
};

// The file of `saccade-eval chart`. Throws std::runtime_error naming file and line.
AccuracyTable readAccuracyTable(const std::string& path);

// Where it stands unless it is said otherwise.
std::string defaultAccuracyTable();

// What is to be rendered.
struct SettingsQuery {
  std::string scene;
  double pixels = 0;     // of a frame
  double threshold = 0;  // C, natural log units
  std::string method;    // empty: any
};

// The table knows no setting for a rendering; what() names what it knows.
struct NotMeasured : std::runtime_error {
  using runtime_error::runtime_error;
};

// No setting keeps a limit; what() names the one that comes nearest.
struct NothingFits : std::runtime_error {
  using runtime_error::runtime_error;
};

// What the settings cost and give there: time grows with the pixels, event rates with 1 / C [E (34)]. Never
// empty. Throws NotMeasured.
std::vector<MeasuredSetting> settingsFor(const AccuracyTable& table, const SettingsQuery& rendering);

// The least false and missed events in at most `budget_ms` of CPU time a frame. Throws NothingFits.
MeasuredSetting mostAccurate(const std::vector<MeasuredSetting>& settings, double budget_ms);

// The least CPU time with at most `max_false_rate` false events per pixel-frame. Throws NothingFits.
MeasuredSetting fastest(const std::vector<MeasuredSetting>& settings, double max_false_rate);

}  // namespace saccade
