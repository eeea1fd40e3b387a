// The options of commands that read files of events of others.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>

#include "client/formats/common/column_names.h"
#include "client/formats/common/reader.h"

namespace saccade::client {

struct ReadingOptions {
  SensorChoice sensor;
  ColumnOptions columns;
  std::int64_t sort_us = 0;  // 0: events are not sorted
  bool crop = false;         // whether events outside of the image are left out
  bool mends = false;        // whether the command has --sort and --crop
};

// --columns and --unit.
void addColumnOptions(CLI::App& command, ColumnOptions& options);
// --sensor and --topic.
void addSensorOptions(CLI::App& command, SensorChoice& choice);
// These, --sort and --crop.
void addReadingOptions(CLI::App& command, ReadingOptions& options);

}  // namespace saccade::client
