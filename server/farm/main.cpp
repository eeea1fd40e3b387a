// saccade-farm makes data sets of many sequences, from a recipe.
#include <spdlog/spdlog.h>

#include <cstdio>
#include <exception>
#include <stdexcept>

#include "client/terminal/console.h"
#include "farm/commands/commands.h"

namespace {

int fail(const std::exception& fault, int code) {
  saccade::client::print(stderr, "saccade-farm: %s\n", fault.what());
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace saccade::farm;
  CLI::App app("Makes data sets of many sequences, from a recipe", "saccade-farm");
  int status = 0;
  spdlog::set_level(spdlog::level::warn);
  app.require_subcommand(1);
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
  app.set_version_flag("--version", SACCADE_VERSION);
  try {
    app.parse(argc, argv);
    return status;
  } catch (const CLI::ParseError& fault) {
    return app.exit(fault) == 0 ? 0 : kUsage;
  } catch (const std::invalid_argument& fault) {
    return fail(fault, kUsage);
  } catch (const std::exception& fault) {
    return fail(fault, kTryAgain);
  }
}
