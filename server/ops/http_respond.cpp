#include "ops/http_respond.h"

#include <exception>
#include <memory>
#include <string_view>
#include <utility>

#include "ops/http_site.h"

namespace saccade {
namespace {

using Response = std::unique_ptr<MHD_Response, decltype(&MHD_destroy_response)>;

HttpAnswer answerTo(const char* path, std::string_view method, const HttpPages& pages) {
  if (method != "GET" && method != "HEAD") return {.status = 405, .body = "GET or HEAD\n"};
  const auto page = pages.find(path);
  if (page == pages.end()) return {.status = 404, .body = "Not Found\n"};
  try {
    return page->second();
  } catch (const std::exception&) {
    return {.status = 500, .body = "Internal Server Error\n"};
  }
}

MHD_Result queue(MHD_Connection* client, const HttpAnswer& answer, const Response& response) {
  if (!response) return MHD_NO;
  for (const auto& [name, value] : answer.headers) {
    MHD_add_response_header(response.get(), name.c_str(), value.c_str());
  }
  return MHD_queue_response(client, static_cast<unsigned>(answer.status), response.get());
}

MHD_Result queuePage(MHD_Connection* client, HttpAnswer answer) {
  const Response response(
      MHD_create_response_from_buffer(answer.body.size(), answer.body.data(), MHD_RESPMEM_MUST_COPY),
      MHD_destroy_response);
  answer.headers.insert(
      {{"Content-Type", answer.type}, {"Cache-Control", "no-store"}, {"Connection", "close"}});
  if (answer.status == 405) answer.headers["Allow"] = "GET, HEAD";
  return queue(client, answer, response);
}

void closeUpgraded(MHD_UpgradeResponseHandle* handle) {
  MHD_upgrade_action(handle, MHD_UPGRADE_ACTION_CLOSE);
}

// A client of the protocol waits for the answer: one that has sent bytes before (`early`) is refused.
void take(void* site, MHD_Connection*, void* upgrade, const char*, std::size_t early, MHD_socket fd,
          MHD_UpgradeResponseHandle* handle) {
  UpgradedSocket socket{fd, {handle, closeUpgraded}};
  std::erase(static_cast<HttpSite*>(site)->clients, fd);
  if (early > 0) return;
  try {
    static_cast<const HttpUpgrade*>(upgrade)->take(std::move(socket));
  } catch (const std::exception&) {
    // No memory or no thread: the connection closes.
  }
}

MHD_Result respondTo(HttpSite& site, MHD_Connection* client, const HttpUpgrade& upgrade) {
  const HttpAnswer answer = upgrade.answer([client](const char* name) -> std::string {
    const char* value = MHD_lookup_connection_value(client, MHD_HEADER_KIND, name);
    return value ? value : "";
  });
  if (answer.status != MHD_HTTP_SWITCHING_PROTOCOLS) return queuePage(client, answer);
  return queue(client, answer, {MHD_create_response_for_upgrade(take, &site), MHD_destroy_response});
}

}  // namespace

MHD_Result respond(void* cls, MHD_Connection* client, const char* path, const char* method, const char*,
                   const char*, std::size_t* body_bytes, void** upgrade) {
  auto& site = *static_cast<HttpSite*>(cls);
  const auto found = site.upgrades.find(path);
  if (found == site.upgrades.end() || std::string_view(method) != "GET")
    return queuePage(client, answerTo(path, method, site.pages));
  // libmicrohttpd closes a connection that is answered at the first call, before its body.
  if (!std::exchange(*upgrade, &found->second)) return MHD_YES;
  return *body_bytes > 0 ? MHD_NO : respondTo(site, client, found->second);
}

}  // namespace saccade
