// saccade info: prints the version, limits, scene features, sensors, truth channels and methods of a server.
#include <chrono>
#include <cstdio>
#include <memory>

#include "client/commands/commands.h"
#include "client/commands/json_option.h"
#include "client/options/option_range.h"
#include "client/terminal/console.h"
#include "saccade/control_client.h"

namespace saccade::client {
namespace {

void printMethod(const v1::MethodInfo& method) {
  print("%s  %s\n", method.name().c_str(), method.description().c_str());
  for (const v1::ParamInfo& param : method.params()) {
    print("  %-20s %g (%g to %g)  %s\n", param.name().c_str(), param.default_value(), param.min(),
          param.max(), param.description().c_str());
  }
}

void printBudgets(const char* name, const char* options, const v1::BudgetInfo& budgets) {
  if (!budgets.unavailable().empty()) {
    print("no %s: %s\n", name, budgets.unavailable().c_str());
    return;
  }
  print("%s (record %s) for:", name, options);
  for (const std::string& scene : budgets.scenes()) print(" %s", scene.c_str());
  print("\n  measured with %s\n", budgets.measured_on().c_str());
}

void printTruth(const v1::TruthInfo& truth) {
  const char* unit = truth.unit().empty() ? "no unit" : truth.unit().c_str();
  print("  %-20s %s: ", truth.name().c_str(), truth.layout() == v1::LAYOUT_PICTURE ? "picture" : "row");
  const char* separator = "";
  for (const std::string& plane : truth.planes()) {
    print("%s%s", separator, plane.c_str());
    separator = ", ";
  }
  print(" (%s)  %s\n", unit, truth.description().c_str());
}

void printLimit(const v1::LimitInfo& limit) {
  char used[32] = "";
  if (limit.has_used()) std::snprintf(used, sizeof used, "%.15g", limit.used());
  print("  %-20s %9.15g %9s %-3s  %s\n", limit.name().c_str(), limit.value(), used, limit.unit().c_str(),
        limit.description().c_str());
}

void printServer(const v1::ServerDescription& server) {
  print("saccaded %s, protocol %u, %u threads, %s\n", server.version().c_str(), server.protocol_version(),
        server.threads(), server.instruction_set().c_str());
  print("data %s, broadcast %s\n", server.data_endpoint().c_str(), server.broadcast_endpoint().c_str());
  printBudgets("budgets", "--budget-ms, --max-false-rate", server.budgets());
  printBudgets("simplification", "--max-event-change", server.simplification());
  print("\nfeatures of scenes (record --disable), and what replaces them:\n");
  for (const v1::SceneFeatureInfo& feature : server.scene_features())
    print("  %-20s %s\n", feature.name().c_str(), feature.description().c_str());
  print("\nsensors of known cameras (record --preset):\n");
  for (const v1::PresetInfo& preset : server.presets())
    print("  %-20s %s\n", preset.name().c_str(), preset.description().c_str());
  print("\nlimits (set by saccaded --limit-NAME), and what all clients together hold of them:\n");
  for (const v1::LimitInfo& limit : server.limits()) printLimit(limit);
  print("\ntruth channels (record --truth), with their planes and unit:\n");
  for (const v1::TruthInfo& truth : server.truth()) printTruth(truth);
  print("\nmethods, and their parameters with default and range:\n");
  for (const v1::MethodInfo& method : server.methods()) printMethod(method);
}

struct InfoOptions {
  ServerOptions server;
  double wait_s = ControlClient::kDeadline.count();
  bool json = false;
};

void runInfo(const InfoOptions& options) {
  zmq::context_t context;
  ControlClient control = connectTo(context, options.server);
  v1::Request request;
  request.mutable_server_info();
  const auto wait = std::chrono::duration<double>(options.wait_s);
  const v1::Reply reply =
      control.call(std::move(request), std::chrono::ceil<std::chrono::milliseconds>(wait));
  options.json ? printJson(reply.server_info()) : printServer(reply.server_info());
}

}  // namespace

void addInfoCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "info", "print the server's version, limits, scene features, truth channels and methods");
  const auto options = std::make_shared<InfoOptions>();
  addServerOptions(*command, options->server);
  addJsonOption(*command, options->json);
  command->add_option("--wait", options->wait_s, "seconds to wait for a server that is not up yet")
      ->capture_default_str();
  limitTo(*command, "--wait", Range<double>{0.001, 86400});
  command->callback([options] { runInfo(*options); });
}

}  // namespace saccade::client
