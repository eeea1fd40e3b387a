// The subcommands of saccade-eval. Each adds its flags to the parser and runs if the command line names it.
#pragma once

#include <CLI/CLI.hpp>

namespace saccade::eval {

void addBakeCommand(CLI::App& app);
void addRenderCommand(CLI::App& app);
void addFramesCommand(CLI::App& app);
void addCompareCommand(CLI::App& app);
void addCompareEventsCommand(CLI::App& app);
void addCompareRendersCommand(CLI::App& app);
void addCellsCommand(CLI::App& app);
void addChartCommand(CLI::App& app);
void addFigureCommand(CLI::App& app);
void addOddsCommand(CLI::App& app);
void addRefineCommand(CLI::App& app);
void addSceneCommand(CLI::App& app);
void addSensorCommand(CLI::App& app);
void addSimplificationCommand(CLI::App& app);
void addTasksCommand(CLI::App& app);
void addTimesCommand(CLI::App& app);

// Requires one of the subcommands of `app`. The error for another word lists them; `what` is what they are.
// Call it after all were added.
void requireSubcommand(CLI::App& app, const std::string& what);

}  // namespace saccade::eval
