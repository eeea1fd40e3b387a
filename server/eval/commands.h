// The subcommands of saccade-eval. Each adds its flags to the parser and runs when it was called for.
#pragma once

#include <CLI/CLI.hpp>

#include "base/default_cache.h"

namespace saccade {

struct Size {
  int width = 256, height = 256;
};
// "WxH", 1 to 16384 each. Throws CLI::ValidationError.
Size parseSize(const std::string& text);

struct FrameRange {
  int first = 1, last = 21;
};
// "A:B", frames A to B with 1 <= A <= B (the change of frame 1 is since frame 0), or one frame. Throws as
// well.
FrameRange parseFrameRange(const std::string& text);

void addStillCommand(CLI::App& app);
void addFramesCommand(CLI::App& app);
void addCompareCommand(CLI::App& app);
void addChartCommand(CLI::App& app);
void addFigureCommand(CLI::App& app);

}  // namespace saccade
