#include "client/commands/keygen.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <memory>
#include <system_error>
#include <zmq.hpp>

#include "client/commands/commands.h"
#include "client/terminal/console.h"

namespace saccade::client {
namespace {

[[noreturn]] void failWith(const std::string& path) {
  throw std::system_error(errno, std::generic_category(), path);
}

void writeNewFile(const std::string& path, const std::string& text, mode_t mode) {
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
  if (file < 0) failWith(path);
  const bool written = write(file, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  if ((close(file) != 0) | !written) failWith(path);
}

}  // namespace

void writeKeyPair(const std::string& name) {
  char public_key[41], secret_key[41];
  if (zmq_curve_keypair(public_key, secret_key) != 0) throw zmq::error_t();
  writeNewFile(name + ".key", secret_key + std::string("\n"), S_IRUSR | S_IWUSR);
  writeNewFile(name + ".pub", public_key + std::string("\n"), S_IRUSR | S_IWUSR | S_IRGRP | S_IROTH);
}

void addKeygenCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "keygen", "write a pair of keys: NAME.key to keep secret, NAME.pub to give to the other side");
  const auto name = std::make_shared<std::string>();
  command->add_option("name", *name, "first part of the two file names")->required()->type_name("NAME");
  command->callback([name] {
    writeKeyPair(*name);
    print("keep %s.key secret; give %s.pub to the other side\n", name->c_str(), name->c_str());
  });
}

}  // namespace saccade::client
