#include "client/commands/commands.h"

namespace saccade {

void addControlOption(CLI::App& command, std::string& endpoint) {
  endpoint = "tcp://127.0.0.1:5770";
  command.add_option("--control", endpoint, "control endpoint of saccaded")->capture_default_str();
}

}  // namespace saccade
