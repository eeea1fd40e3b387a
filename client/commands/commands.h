// The subcommands of `saccade`. Each adds itself to the command line and runs when it is named there.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "client/control_client.h"

namespace saccade::client {

void addListCommand(CLI::App& app);
void addInfoCommand(CLI::App& app);
void addRecordCommand(CLI::App& app);
void addKeygenCommand(CLI::App& app);

// Where the server is, and the keys it wants. All commands but keygen have it.
struct ServerOptions {
  std::string control = "tcp://127.0.0.1:5770";
  std::string secret_key, server_key;  // files
};
void addServerOptions(CLI::App& command, ServerOptions& options);
// Throws std::invalid_argument naming what is wrong.
ControlClient connectTo(zmq::context_t& context, const ServerOptions& options);

}  // namespace saccade::client
