#include <stdexcept>

#include "client/commands/commands.h"
#include "client/terminal/console.h"
#include "saccade/server_probe.h"
#include "saccade/wire/curve_key.h"

namespace saccade::client {
namespace {

// Returns what `read` returns, and puts the name of the option before the text of its exception.
auto named(const std::string& option, const auto& read) {
  try {
    return read();
  } catch (const std::invalid_argument& fault) {
    throw std::invalid_argument(option + ": " + fault.what());
  }
}

}  // namespace

ControlClient connectTo(zmq::context_t& context, const ServerOptions& options) {
  if (options.secret_key.empty() != options.server_key.empty()) {
    throw std::invalid_argument("give both --secret-key and --server-key, or neither");
  }
  named("--control", [&] { checkEndpoint(options.control); });
  CurveKeys keys;
  if (!options.secret_key.empty()) {
    keys = {named("--secret-key", [&] { return readSecretKey(options.secret_key); }),
            named("--server-key", [&] { return readPublicKey(options.server_key); })};
    const std::string warning = warningOfOpenKey(options.secret_key);
    if (!warning.empty()) print(stderr, "saccade: %s\n", warning.c_str());
  }
  return ControlClient(context, options.control, keys);
}

}  // namespace saccade::client
