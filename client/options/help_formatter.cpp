#include "client/options/help_formatter.h"

#include <algorithm>
#include <utility>

namespace saccade::client {
namespace {

constexpr const char* kRare = ", more";  // ends the name of a group of rare options

}  // namespace

void showInHelp(CLI::App& command, const std::set<std::string>& common) {
  for (CLI::Option* option : command.get_options()) {
    const auto isCommon = [&](const std::string& name) { return common.contains("--" + name); };
    const auto names = option->get_lnames();
    const bool help = option == command.get_help_ptr() || option == command.get_help_all_ptr();
    if (help || names.empty() || std::ranges::any_of(names, isCommon)) continue;
    option->group(option->get_group() + kRare);
  }
}

const std::set<std::string>& commonRequestOptions() {
  static const std::set<std::string> names{"--motion",        "--size", "--calibration", "--threshold",
                                           "--threshold-off", "--bias", "--preset",      "--rate",
                                           "--duration",      "--seed", "--control"};
  return names;
}

std::string HelpFormatter::make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const {
  if (mode == CLI::AppFormatMode::Sub) return make_expanded(app);
  return make_description(app) + make_usage(app, std::move(name)) + make_positionals(app) +
         options(*app, mode) + make_subcommands(app, mode) + "\n" + make_footer(app);
}

std::string HelpFormatter::options(const CLI::App& app, CLI::AppFormatMode mode) const {
  std::string text;
  std::size_t left_out = 0;
  for (const std::string& group : app.get_groups()) {
    const auto options = app.get_options(
        [&](const CLI::Option* option) { return option->get_group() == group && option->nonpositional(); });
    if (group.empty() || options.empty()) continue;
    if (mode != CLI::AppFormatMode::All && group.ends_with(kRare)) {
      left_out += options.size();
    } else {
      text += make_group(group, false, options);
    }
  }
  if (left_out > 0) text += "\n--help-all shows " + std::to_string(left_out) + " more options.\n";
  return text;
}

}  // namespace saccade::client
