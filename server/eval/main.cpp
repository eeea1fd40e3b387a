// saccade-eval renders pictures and references, runs methods, and measures them. It uses the code of the
// server.
#include <cstdio>
#include <stdexcept>

#include "base/instruction_set.h"
#include "base/names.h"
#include "eval/commands/commands.h"

namespace saccade::eval {

void requireSubcommand(CLI::App& app, const std::string& what) {
  app.require_subcommand(0, 1);
  app.allow_extras();  // reported below
  app.callback([&app, what] {
    if (!app.get_subcommands().empty()) return;
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
    const std::vector<std::string> words = app.remaining();
    const std::string fault =
        words.empty() ? "give a " + what : "there is no " + what + " '" + words.front() + "'";
    throw CLI::ValidationError(fault + "; there are: " + joinNames(names));
  });
}

}  // namespace saccade::eval

namespace {

void useInstructions(const std::string& name) {
  try {
    saccade::useInstructionSet(name);
  } catch (const std::runtime_error& fault) {
    throw CLI::ValidationError("--instructions", fault.what());
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Renders pictures and references, runs methods, and measures how accurate they are."};
  saccade::eval::addSceneCommand(app);
  saccade::eval::addRenderCommand(app);
  saccade::eval::addFramesCommand(app);
  saccade::eval::addCompareCommand(app);
  saccade::eval::addCompareEventsCommand(app);
  saccade::eval::addCompareRendersCommand(app);
  saccade::eval::addBakeCommand(app);
  saccade::eval::addChartCommand(app);
  saccade::eval::addCellsCommand(app);
  saccade::eval::addFigureCommand(app);
  saccade::eval::addOddsCommand(app);
  saccade::eval::addRefineCommand(app);
  saccade::eval::addSensorCommand(app);
  saccade::eval::addSimplificationCommand(app);
  saccade::eval::addTasksCommand(app);
  saccade::eval::addTimesCommand(app);
  saccade::eval::requireSubcommand(app, "command");
  app.set_version_flag("--version", SACCADE_VERSION);
  app.add_option_function<std::string>("--instructions", useInstructions,
                                       "vector instructions to render with; default: the widest of this "
                                       "processor")
      ->check(CLI::IsMember(saccade::kInstructionSetNames));
  app.footer(
      "Scenes: the environment variable SACCADE_SCENES names a folder to use instead of the built-in one.");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : 2;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "saccade-eval: %s\n", e.what());
    return 1;
  }
  return 0;
}
