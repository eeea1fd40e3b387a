// The pages that an HTTP server serves, and the connections that it has.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "ops/http_answer.h"
#include "ops/http_upgrade.h"

namespace saccade {

using HttpPage = std::function<HttpAnswer()>;       // an exception becomes a 500
using HttpPages = std::map<std::string, HttpPage>;  // by path, such as "/healthz"

struct HttpSite {
  HttpPages pages;
  HttpUpgrades upgrades;
  std::vector<int> clients = {};  // their sockets, the oldest first; the server's thread alone uses them
};

}  // namespace saccade
