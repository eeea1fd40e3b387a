#include "saccade/wire/curve_key.h"

#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace saccade {

bool isCurveKey(std::string_view text) {
  constexpr std::string_view kDigits =
      "0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ.-:+=^!/*?&<>()[]{}@%$#";
  return text.size() == 40 && text.find_first_not_of(kDigits) == std::string_view::npos;
}

std::string readCurveKey(const std::string& path) {
  std::ifstream file(path);
  std::string key, more;
  if (!file) throw std::invalid_argument("the key file " + path + " cannot be read");
  if (!(file >> key) || !isCurveKey(key) || file >> more) {
    throw std::invalid_argument(path + " holds no key as `saccade keygen` writes it");
  }
  return key;
}

std::string warningOfOpenKey(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code unknown;
  if ((fs::status(path, unknown).permissions() & fs::perms::others_read) == fs::perms::none) return {};
  return "every user of this machine can read the secret key " + path + ": run chmod o-rwx " + path;
}

std::string readSecretKey(const std::string& path) {
  if (path.ends_with(".pub"))
    throw std::invalid_argument(path + " is a public key by its name; the secret one is NAME.key");
  return readCurveKey(path);
}

std::string readPublicKey(const std::string& path) {
  requirePublic(path);
  return readCurveKey(path);
}

void requirePublic(const std::string& path) {
  if (path.ends_with(".key"))
    throw std::invalid_argument(path + " is a secret key by its name; the public one is NAME.pub");
}

}  // namespace saccade
