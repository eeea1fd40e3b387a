// The help of a command. --help shows its common options, and --help-all all.
#pragma once

#include <CLI/CLI.hpp>
#include <set>
#include <string>

namespace saccade::client {

// Leaves all options of `command` but `common` and those of --help to --help-all.
void showInHelp(CLI::App& command, const std::set<std::string>& common);

// The common options of commands that open a stream.
const std::set<std::string>& commonRequestOptions();

class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;

 private:
  std::string options(const CLI::App& app, CLI::AppFormatMode mode) const;
};

}  // namespace saccade::client
