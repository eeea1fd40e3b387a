// saccade-farm makes data sets of many sequences, from a recipe.
#include <spdlog/spdlog.h>

#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>

#include "client/options/usage_check.h"
#include "client/terminal/console.h"
#include "farm/commands/commands.h"

namespace {

using namespace saccade::farm;

int fail(const std::string& fault, int code) {
  saccade::client::print(stderr, "saccade-farm: %s\n", fault.c_str());
  return code;
}

std::string parseFault(const CLI::App*, const CLI::Error& error) {
  return std::string("saccade-farm: ") + error.what() + "; see --help\n";
}

void addCommands(CLI::App& app, int& status) {
  addCheckCommand(app, status);
  addPlanCommand(app, status);
  addRunCommand(app, status);
  addStatusCommand(app, status);
  addVerifyCommand(app, status);
  addCardCommand(app, status);
  addPackCommand(app, status);
  addSlurmCommand(app, status);
  addKubernetesCommand(app, status);
  addSnakemakeCommand(app, status);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Makes data sets of many sequences, from a recipe", "saccade-farm");
  int status = 0;
  spdlog::set_level(spdlog::level::warn);
  app.require_subcommand(1);
  app.failure_message(parseFault);
  app.set_version_flag("--version", SACCADE_VERSION);
  addCommands(app, status);
  const std::string wrong = saccade::client::usageFault(app, {argv + 1, argv + argc});
  if (!wrong.empty()) return fail(wrong + "; see --help", kUsage);
  try {
    app.parse(argc, argv);
    return status;
  } catch (const CLI::ParseError& fault) {
    return app.exit(fault) == 0 ? 0 : kUsage;
  } catch (const std::invalid_argument& fault) {
    return fail(fault.what(), kUsage);
  } catch (const std::exception& fault) {
    return fail(fault.what(), kTryAgain);
  }
}
