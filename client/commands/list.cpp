// saccade list: prints the scenes of a server.
#include <memory>

#include "client/commands/commands.h"
#include "client/commands/json_option.h"
#include "client/options/request_text.h"
#include "client/terminal/console.h"
#include "saccade/control_client.h"

namespace saccade::client {
namespace {

void printObjects(const v1::SceneInfo& scene) {
  if (scene.objects().empty()) return;
  print("  objects:");
  for (const v1::SceneObject& object : scene.objects()) {
    print(" %s", object.name().c_str());
    if (!object.motion().empty()) print(" (moves: %s)", object.motion().c_str());
  }
  print("\n");
}

void printNames(const char* what, const google::protobuf::RepeatedPtrField<std::string>& names) {
  if (names.empty()) return;
  print("  %s:", what);
  for (const std::string& name : names) print(" %s", name.c_str());
  print("\n");
}

void printScene(const v1::SceneInfo& scene) {
  print("%s  %s\n", scene.name().c_str(), scene.description().c_str());
  if (!scene.unavailable().empty()) print("  cannot be opened here: %s\n", scene.unavailable().c_str());
  if (!scene.stats().empty()) print("  %s\n", scene.stats().c_str());
  printObjects(scene);
  printNames("animations", scene.animations());
  printNames("trajectories", scene.trajectories());
}

struct ListOptions {
  ServerOptions server;
  bool json = false;
};

void runList(const ListOptions& options) {
  zmq::context_t context;
  ControlClient control = connectTo(context, options.server);
  v1::Request request;
  request.mutable_list_scenes();
  const v1::Reply reply = control.call(std::move(request));
  if (options.json) return printJson(reply.list_scenes());
  if (reply.list_scenes().scenes().empty()) return print("the server has no scenes\n");
  for (const v1::SceneInfo& scene : reply.list_scenes().scenes()) printScene(scene);
  print("every scene also has the motions KIND:SPEED, such as pan:10, with KIND one of %s\n",
        enumWords<v1::MotionKind>().c_str());
}

}  // namespace

void addListCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "list", "print the scenes of the server, and the trajectories, objects and animations of each");
  const auto options = std::make_shared<ListOptions>();
  addServerOptions(*command, options->server);
  addJsonOption(*command, options->json);
  command->callback([options] { runList(*options); });
}

}  // namespace saccade::client
