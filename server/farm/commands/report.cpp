// saccade-farm status and verify: what a data set holds.
#include <cmath>
#include <cstdio>
#include <memory>

#include "client/terminal/console.h"
#include "client/terminal/progress.h"
#include "farm/commands/commands.h"
#include "farm/report/status.h"
#include "farm/report/verify.h"

namespace saccade::farm {
namespace {

using client::print;

long long asInt(std::uint64_t number) {
  return static_cast<long long>(number);
}

void printJson(const Status& status) {
  print(
      "{\"all\":%lld,\"done\":%lld,\"retry\":%lld,\"never\":%lld,\"running\":%lld,\"workers\":%lld,"
      "\"per_s\":%.6g,\"left_s\":%.6g}\n",
      asInt(status.all), asInt(status.done), asInt(status.retry), asInt(status.never), asInt(status.running),
      asInt(status.workers), status.per_s, status.left_s);
}

void printText(const Status& status) {
  print("%lld of %lld sequences (%.3g %%)\n", asInt(status.done), asInt(status.all),
        100 * static_cast<double>(status.done) / static_cast<double>(status.all));
  if (status.retry + status.never > 0)
    print("failed: %lld that another run may make, %lld that can never be made\n", asInt(status.retry),
          asInt(status.never));
  if (status.workers == 0) return;
  print("%lld runs are at %lld sequences, and make %.2g a second", asInt(status.workers),
        asInt(status.running), status.per_s);
  print(status.left_s > 0 ? "; %s left\n" : "%s\n",
        status.left_s > 0 ? client::timeText(status.left_s).c_str() : "");
}

std::string progressOf(const Verified& now, const v1::DataSetPlan& plan, double elapsed_s) {
  const std::uint64_t seen = now.sequences + now.failed;
  std::string text = std::to_string(seen) + " of " + std::to_string(plan.sequences()) + " sequences, " +
                     bytesText(static_cast<double>(now.bytes));
  const std::uint64_t faults = now.damaged + now.missing + now.foreign;
  if (faults > 0) text += ", " + std::to_string(faults) + " faults";
  if (seen == 0 || elapsed_s < 1) return text;
  const double left = static_cast<double>(plan.sequences() - seen) / static_cast<double>(seen) * elapsed_s;
  return text + ", " + client::timeText(left) + " left";
}

int runVerify(const std::string& folder) {
  const DataSet set(folder);
  client::Progress progress(0);
  const Verified found = verify(
      set, [&](const std::string& fault) { progress.tell(fault); },
      [&](const Verified& now) { progress.note(progressOf(now, set.plan(), progress.elapsed_s())); });
  progress.finish();
  print("%lld sequences are as they should be (%s); %lld damaged, %lld missing, %lld foreign\n",
        asInt(found.sequences), bytesText(static_cast<double>(found.bytes)).c_str(), asInt(found.damaged),
        asInt(found.missing), asInt(found.foreign));
  if (found.failed > 0) print("%lld can never be made; failed/ says why\n", asInt(found.failed));
  if (found.damaged + found.missing > 0)
    print("where a sequence is not whole, remove its folder; `saccade-farm run` makes what is missing\n");
  return found.whole() ? 0 : 1;
}

}  // namespace

void addStatusCommand(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("status", "tell how far a data set is");
  const auto folder = std::make_shared<std::string>();
  const auto json = std::make_shared<bool>(false);
  addFolderOption(*command, *folder);
  command->add_flag("--json", *json, "print one JSON object");
  command->callback([=, &status] {
    const Status found = statusOf(DataSet(*folder));
    *json ? printJson(found) : printText(found);
    status = 0;
  });
}

void addVerifyCommand(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("verify", "compare all files of a data set with their digests");
  const auto folder = std::make_shared<std::string>();
  addFolderOption(*command, *folder);
  command->footer(
      "Exit codes: 0 all is there and sound, 1 something is damaged, missing or foreign, 2 wrong usage.");
  command->callback([=, &status] { status = runVerify(*folder); });
}

}  // namespace saccade::farm
