// The subcommands of `saccade`. Each add...() adds one to the command line; parsing runs it.
#pragma once

#include <CLI/CLI.hpp>

#include "client/options/server_options.h"
#include "saccade/control_client.h"

namespace saccade::client {

void addListCommand(CLI::App& app);
void addInfoCommand(CLI::App& app);
void addStreamsCommand(CLI::App& app);
void addCloseCommand(CLI::App& app);
void addRecordCommand(CLI::App& app);
void addEventsCommand(CLI::App& app);
void addViewCommand(CLI::App& app);
void addServeDvCommand(CLI::App& app);
void addReplayCommand(CLI::App& app);
void addConvertCommand(CLI::App& app);
void addVerifyCommand(CLI::App& app);
void addKeygenCommand(CLI::App& app);

// Resolves the host; does not wait for the server. Throws std::invalid_argument with the option at fault.
ControlClient connectTo(zmq::context_t& context, const ServerOptions& options);

}  // namespace saccade::client
