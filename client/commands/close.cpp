// saccade close: ends streams on the server.
#include <memory>
#include <vector>

#include "client/commands/commands.h"
#include "client/terminal/console.h"
#include "saccade/control_client.h"

namespace saccade::client {
namespace {

struct CloseOptions {
  ServerOptions server;
  std::vector<std::string> streams;
};

void runClose(const CloseOptions& options) {
  zmq::context_t context;
  ControlClient control = connectTo(context, options.server);
  for (const std::string& stream : options.streams) {
    v1::Request request;
    request.mutable_close_stream()->set_stream_id(stream);
    control.call(std::move(request));
    print("closed %s\n", stream.c_str());
  }
}

}  // namespace

void addCloseCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "close", "end streams on the server: your own, and those of others where it lets you");
  const auto options = std::make_shared<CloseOptions>();
  addServerOptions(*command, options->server);
  command->add_option("streams", options->streams, "their ids, as `saccade streams` prints them")
      ->required()
      ->type_name("ID");
  command->callback([options] { runClose(*options); });
}

}  // namespace saccade::client
