// The `saccade` command. Exit codes: 0 done, 1 the stream or the server failed, 2 wrong usage.
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>

#include "client/commands/commands.h"
#include "client/control_client.h"

namespace saccade::client {
namespace {

int fail(const std::exception& error, int code) {
  std::fprintf(stderr, "saccade: %s\n", error.what());
  return code;
}

bool isUsage(v1::Code code) {
  return code == v1::CODE_INVALID_ARGUMENT || code == v1::CODE_NOT_FOUND;
}

std::string usageFault(const CLI::App*, const CLI::Error& error) {
  return std::string("saccade: ") + error.what() + "; see --help\n";
}

int run(int argc, char** argv) {
  CLI::App app("Client of saccaded, the event-camera daemon");
  app.require_subcommand(1);
  app.failure_message(usageFault);
  addListCommand(app);
  addInfoCommand(app);
  addRecordCommand(app);
  addKeygenCommand(app);
  try {
    app.parse(argc, argv);
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::invalid_argument& error) {
    return fail(error, 2);
  } catch (const Refused& error) {
    return fail(error, isUsage(error.code) ? 2 : 1);
  } catch (const std::exception& error) {
    return fail(error, 1);
  }
}

}  // namespace
}  // namespace saccade::client

int main(int argc, char** argv) {
  return saccade::client::run(argc, argv);
}
