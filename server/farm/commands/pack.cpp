// saccade-farm pack: tar files for WebDataset.
#include "farm/pack/pack.h"

#include <memory>

#include "client/terminal/console.h"
#include "client/terminal/interrupt.h"
#include "client/terminal/progress.h"
#include "farm/commands/commands.h"

namespace saccade::farm {
namespace {

int finish(const PackCounts& counts, const std::string& folder) {
  client::print(
      "%llu tar files written, with %llu sequences and %s; %llu were there\n",
      static_cast<unsigned long long>(counts.written), static_cast<unsigned long long>(counts.sequences),
      bytesText(static_cast<double>(counts.bytes)).c_str(), static_cast<unsigned long long>(counts.found));
  if (counts.unfinished > 0)
    client::print(stderr, "saccade-farm: %u shards are not complete; `saccade-farm run %s` makes them\n",
                  counts.unfinished, folder.c_str());
  if (counts.faulty > 0) return kNever;
  return counts.stopped || counts.unfinished > 0 ? kTryAgain : 0;
}

int runPack(const std::string& folder) {
  const DataSet set(folder);
  client::watchInterrupt();
  client::Progress progress(0);
  const PackCounts counts = pack(
      set, client::interrupted, [&](const std::string& fault) { progress.tell("saccade-farm: " + fault); },
      [&](const PackCounts& now) {
        progress.note(std::to_string(now.sequences) + " sequences, " + std::to_string(now.written) +
                      " tar files");
      });
  progress.finish();
  return finish(counts, folder);
}

}  // namespace

void addPackCommand(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("pack", "write tar files for WebDataset");
  const auto folder = std::make_shared<std::string>();
  addFolderOption(*command, *folder);
  command->footer(
      "webdataset/SPLIT-SHARD.tar has the sequences of a split in a shard that is complete. Files that are "
      "there are not written again.\n"
      "Exit codes: 0 all is there, 2 wrong usage, 75 another run may pack what is missing, 78 a file is "
      "damaged.");
  command->callback([=, &status] { status = runPack(*folder); });
}

}  // namespace saccade::farm
