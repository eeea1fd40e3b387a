// saccade streams: prints the streams of a server.
#include <cctype>
#include <memory>

#include "client/commands/commands.h"
#include "client/commands/json_option.h"
#include "client/terminal/console.h"
#include "saccade/control_client.h"

namespace saccade::client {
namespace {

constexpr const char* kRow = "%-16s  %-12s  %-20s  %7s  %-8s  %10s  %12s\n";

// "running"
std::string stateText(v1::StreamState state) {
  std::string text = v1::StreamState_Name(state);
  text.erase(0, std::string("STREAM_STATE_").size());
  for (char& letter : text) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return text.empty() ? "unknown" : text;
}

const char* orDash(const std::string& text) {
  return text.empty() ? "-" : text.c_str();
}

void printStream(const v1::StreamInfo& stream) {
  print(kRow, stream.stream_id().c_str(), orDash(stream.client()), orDash(stream.scene()),
        std::to_string(stream.sensors()).c_str(), stateText(stream.state()).c_str(),
        std::to_string(stream.frames_done()).c_str(), std::to_string(stream.events()).c_str());
}

void printOpening(const v1::OpeningInfo& opening) {
  print("%-16s  %-12s  %-20s  for %.0f s: %s\n", "opening", orDash(opening.client()), orDash(opening.scene()),
        opening.elapsed_s(), opening.doing().c_str());
}

void printStreams(const v1::StreamList& list) {
  if (list.streams().empty() && list.opening().empty()) return print("no streams\n");
  print(kRow, "id", "client", "scene", "sensors", "state", "frames", "events");
  for (const v1::StreamInfo& stream : list.streams()) printStream(stream);
  for (const v1::OpeningInfo& opening : list.opening()) printOpening(opening);
}

struct StreamsOptions {
  ServerOptions server;
  bool json = false;
};

void runStreams(const StreamsOptions& options) {
  zmq::context_t context;
  ControlClient control = connectTo(context, options.server);
  v1::Request request;
  request.mutable_list_streams()->set_all(true);
  const v1::Reply reply = control.call(std::move(request));
  options.json ? printJson(reply.list_streams()) : printStreams(reply.list_streams());
}

}  // namespace

void addStreamsCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "streams", "print the streams of the server: your own, and those of others where it lets you");
  const auto options = std::make_shared<StreamsOptions>();
  addServerOptions(*command, options->server);
  addJsonOption(*command, options->json);
  command->callback([options] { runStreams(*options); });
}

}  // namespace saccade::client
