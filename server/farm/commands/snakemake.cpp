// saccade-farm snakemake
#include <memory>

#include "farm/commands/commands.h"
#include "farm/commands/engine_command.h"
#include "farm/engines/snakemake.h"

namespace saccade::farm {

void addSnakemakeCommand(CLI::App& app, int& status) {
  CLI::App* command =
      app.add_subcommand("snakemake", "write a Snakefile: snakemake --snakefile FILE --cores all");
  const auto common = std::make_shared<EngineCommand>();
  addCommonOptions(*command, *common);
  addProgramOption(*command, *common);
  command->callback([=, &status] {
    writeEngine(*common, snakefile(DataSet(common->folder), engineOf(*common, true)));
    status = 0;
  });
}

}  // namespace saccade::farm
