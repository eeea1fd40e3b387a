// The options of all commands that speak to a server.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace saccade::client {

struct ServerOptions {
  std::string control = "tcp://127.0.0.1:5770";
  std::string secret_key, server_key;  // files
};

void addServerOptions(CLI::App& command, ServerOptions& options);

}  // namespace saccade::client
