// A path of the HTTP server whose connections leave HTTP for another protocol, such as WebSocket.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "ops/http_answer.h"

struct MHD_UpgradeResponseHandle;

namespace saccade {

// The value of a header of the request, by its name; empty: there is none.
using HttpHeader = std::function<std::string(const char* name)>;

// A connection after its last byte of HTTP. Destroy it before the server that gave it.
struct UpgradedSocket {
  using Handle = std::unique_ptr<MHD_UpgradeResponseHandle, void (*)(MHD_UpgradeResponseHandle*)>;
  int fd;         // does not block; read, write and shut it down, but do not close it
  Handle handle;  // closes it
};

struct HttpUpgrade {
  std::function<HttpAnswer(const HttpHeader&)> answer;  // status 101: then take() follows
  std::function<void(UpgradedSocket)> take;             // a thread of the server calls both
};
using HttpUpgrades = std::map<std::string, HttpUpgrade>;  // by path

}  // namespace saccade
