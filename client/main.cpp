// The `saccade` command. Exit codes: 0 success, 1 the stream or the server failed, 2 wrong usage.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "client/commands/commands.h"
#include "client/options/field_options.h"
#include "client/options/help_formatter.h"
#include "client/options/usage_check.h"
#include "client/terminal/console.h"
#include "saccade/control_client.h"
#include "saccade/server_probe.h"

namespace saccade::client {
namespace {

int fail(const std::string& message, int code) {
  print(stderr, "saccade: %s\n", printable(message).c_str());
  return code;
}

bool isUsage(v1::Code code) {
  return code == v1::CODE_INVALID_ARGUMENT || code == v1::CODE_NOT_FOUND;
}

// A refusal names a field of the request. Where an option of the command has made it, that is named instead.
std::string refusalText(const CLI::App& app, const Refused& refused) {
  const std::string option = optionOf(refused.field);
  for (const CLI::App* command : app.get_subcommands())
    if (command->get_option_no_throw(option)) return option + (refused.what() + refused.field.size());
  return refused.what();
}

// `saccade help COMMAND` means `saccade COMMAND --help`.
std::vector<std::string> wordsOf(int argc, char** argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  if (words.empty() || words[0] != "help") return words;
  words.erase(words.begin());
  words.emplace_back("--help");
  return words;
}

std::string parseFault(const CLI::App*, const CLI::Error& error) {
  return std::string("saccade: ") + error.what() + "; see --help\n";
}

int run(int argc, char** argv) {
  CLI::App app("Client of saccaded, the event-camera daemon", "saccade");
  app.require_subcommand(1);
  app.failure_message(parseFault);
  app.formatter(std::make_shared<HelpFormatter>());
  app.set_help_all_flag("--help-all", "Print all options, also the rare ones, and exit");
  addListCommand(app);
  addInfoCommand(app);
  addStreamsCommand(app);
  addCloseCommand(app);
  addRecordCommand(app);
  addEventsCommand(app);
  addViewCommand(app);
  addServeDvCommand(app);
  addReplayCommand(app);
  addConvertCommand(app);
  addVerifyCommand(app);
  addKeygenCommand(app);
  app.set_version_flag("--version", SACCADE_VERSION);
  std::vector<std::string> words = wordsOf(argc, argv);
  const std::string fault = usageFault(app, words);
  if (!fault.empty()) return fail(fault + "; see --help", 2);
  try {
    std::reverse(words.begin(), words.end());  // as CLI11 wants them
    app.parse(words);
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::invalid_argument& error) {
    return fail(error.what(), 2);
  } catch (const Refused& error) {
    return fail(refusalText(app, error), isUsage(error.code) ? 2 : 1);
  } catch (const NoAnswer& silence) {
    return fail(explainSilence(silence), 1);
  } catch (const std::exception& error) {
    return fail(error.what(), 1);
  }
}

}  // namespace
}  // namespace saccade::client

int main(int argc, char** argv) {
  return saccade::client::run(argc, argv);
}
