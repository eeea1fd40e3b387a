#include "client/options/server_options.h"

namespace saccade::client {

void addServerOptions(CLI::App& command, ServerOptions& options) {
  command.add_option("--control", options.control, "control endpoint of the server")
      ->envname("SACCADE_SERVER")
      ->capture_default_str();
  command.add_option("--secret-key", options.secret_key, "file of your secret key, for a server with keys")
      ->envname("SACCADE_CLIENT_KEY");
  command
      .add_option("--server-key", options.server_key,
                  "file of the server's public key, for a server with keys")
      ->envname("SACCADE_SERVER_KEY");
}

}  // namespace saccade::client
