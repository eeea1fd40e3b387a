// saccade-farm card: what a data set holds, for people and for hubs.
#include <memory>

#include "base/names.h"
#include "client/terminal/console.h"
#include "client/terminal/progress.h"
#include "farm/card/write_card.h"
#include "farm/commands/commands.h"

namespace saccade::farm {
namespace {

using client::print;

// "2026-11-27"
std::string checkDate(const std::string& text) {
  constexpr std::string_view kForm = "dddd-dd-dd";
  bool fits = text.size() == kForm.size();
  for (std::size_t i = 0; fits && i < kForm.size(); ++i)
    fits = kForm[i] == 'd' ? text[i] >= '0' && text[i] <= '9' : text[i] == kForm[i];
  return fits ? "" : "'" + text + "' is not a date such as 2026-11-27";
}

int runCard(const CardOptions& options) {
  client::Progress progress(0);
  const CardResult result = writeCard(
      options, [&](const std::string& fault) { progress.tell("saccade-farm: " + fault); },
      [&](std::uint64_t sequences) { progress.note("sequence " + std::to_string(sequences)); });
  progress.finish();
  print("README.md, croissant.json and card/ tell of %llu sequences\n",
        static_cast<unsigned long long>(result.sequences));
  for (const std::string& scene : result.unknown_licences)
    print(stderr,
          "saccade-farm: the licence of the scene '%s' is not known: %s/%s/README.md has no line "
          "'Licence: ...'\n",
          scene.c_str(), options.scenes.c_str(), scene.c_str());
  if (!result.lacking.empty())
    print(stderr, "saccade-farm: Croissant also requires: %s\n", joinNames(result.lacking).c_str());
  if (result.unfinished == 0) return 0;
  print(stderr, "saccade-farm: %u shards are not complete, and the card does not tell of them\n",
        result.unfinished);
  return kTryAgain;
}

}  // namespace

void addCardCommand(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("card", "write what a data set holds: README.md and croissant.json");
  const auto options = std::make_shared<CardOptions>();
  options->scenes = defaultRender().scenes;
  addFolderOption(*command, options->folder);
  command
      ->add_option("--scenes", options->scenes,
                   "folder with a folder for each scene, whose README.md tells its licence")
      ->check(CLI::ExistingDirectory)
      ->capture_default_str();
  command->add_option("--url", options->url, "address of the data set's page, for hubs");
  command->add_option("--licence", options->licence,
                      "licence of the data set, such as an address of spdx.org");
  command->add_option("--creator", options->creator, "who has made the data set");
  command->add_option("--published", options->published, "date, such as 2026-11-27")->check(checkDate);
  command->footer("Exit codes: 0 the card tells of all, 2 wrong usage, 75 some shards are not complete yet.");
  command->callback([=, &status] { status = runCard(*options); });
}

}  // namespace saccade::farm
