// The subcommands of `saccade-farm`. Each add...() adds one to the command line; parsing runs it, and sets
// `status`, the exit code of the program.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "farm/worker/sequence_renderer.h"

namespace saccade::farm {

// Exit codes, as sysexits.h has the last two. Engines act on them.
inline constexpr int kUsage = 2;      // the command line is wrong
inline constexpr int kTryAgain = 75;  // something failed, or was stopped, that another run may mend
inline constexpr int kNever = 78;     // something can never be as it is: the recipe, a scene, this build

void addCheckCommand(CLI::App& app, int& status);
void addCardCommand(CLI::App& app, int& status);
void addPackCommand(CLI::App& app, int& status);
void addPlanCommand(CLI::App& app, int& status);
void addRunCommand(CLI::App& app, int& status);
void addStatusCommand(CLI::App& app, int& status);
void addVerifyCommand(CLI::App& app, int& status);
void addSlurmCommand(CLI::App& app, int& status);
void addKubernetesCommand(CLI::App& app, int& status);
void addSnakemakeCommand(CLI::App& app, int& status);

// The options for what workers render from. The values in `settings` are the defaults.
void addRenderOptions(CLI::App& command, RenderSettings& settings);
// The options for tables that answer a budget.
void addTableOptions(CLI::App& command, RenderSettings& settings);
RenderSettings defaultRender();

// Reads the data set's folder, an argument of most commands.
void addFolderOption(CLI::App& command, std::string& folder);

std::string bytesText(double bytes);    // "1.2 GB"
std::string hoursText(double seconds);  // "3.4 h", "12 min", "5 s"

}  // namespace saccade::farm
