// The common part of the commands for engines.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "farm/engines/engine_options.h"

namespace saccade::farm {

struct EngineCommand {
  std::string folder, output = {}, scenes = {}, meshes = {}, bakes = {};
  EngineOptions engine = {};
};

void addCommonOptions(CLI::App& command, EngineCommand& options);
void addParallelOption(CLI::App& command, EngineCommand& options);
void addProgramOption(CLI::App& command, EngineCommand& options);

// The options of the engine, with the words for scenes, meshes and bakes. `here`: the workers have the
// folders of this machine, which become absolute. Otherwise they are those of a container.
EngineOptions engineOf(const EngineCommand& options, bool here);

// Into the file that was asked for, or printed.
void writeEngine(const EngineCommand& options, const std::string& text);

}  // namespace saccade::farm
