#include "ops/http_server.h"

#include <civetweb.h>

#include <stdexcept>
#include <string_view>

namespace saccade {
namespace {

constexpr std::string_view kScheme = "http://";

// GET and HEAD have answers.
int answer(mg_connection* connection, void* page) {
  const std::string_view method = mg_get_request_info(connection)->request_method;
  const bool known = method == "GET" || method == "HEAD";
  const HttpAnswer answer =
      known ? (*static_cast<HttpServer::Page*>(page))() : HttpAnswer{.status = 405, .body = "GET or HEAD\n"};
  mg_printf(connection,
            "HTTP/1.1 %d %s\r\nContent-Type: %s\r\nContent-Length: %zu\r\nCache-Control: no-store\r\n"
            "Connection: close\r\n\r\n",
            answer.status, mg_get_response_code_text(connection, answer.status), answer.type.c_str(),
            answer.body.size());
  if (method != "HEAD") mg_write(connection, answer.body.data(), answer.body.size());
  return answer.status;
}

// What clients do wrong does not fill our log.
int passOver(const mg_connection*, const char*) {
  return 1;
}

}  // namespace

struct HttpServer::Impl {
  Pages pages;
  mg_context* context = nullptr;
};

HttpServer::HttpServer(const std::string& endpoint, Pages pages) : impl_(std::make_unique<Impl>()) {
  if (!endpoint.starts_with(kScheme)) {
    throw std::runtime_error(endpoint + " is no address such as http://127.0.0.1:5773");
  }
  const std::string address = endpoint.substr(kScheme.size());
  // A client that says nothing has its thread for half a second at most: dozens of them do not make who asks
  // for our health wait until it takes us for dead.
  const char* options[] = {"listening_ports",
                           address.c_str(),
                           "num_threads",
                           "16",
                           "request_timeout_ms",
                           "500",
                           "enable_keep_alive",
                           "no",
                           "tcp_nodelay",  // an answer is several writes
                           "1",
                           nullptr};
  mg_callbacks callbacks{};
  callbacks.log_message = passOver;
  mg_init_data init{&callbacks, nullptr, options};
  char reason[256] = "";
  mg_error_data fault{};
  fault.text = reason;
  fault.text_buffer_size = sizeof reason;
  impl_->pages = std::move(pages);
  impl_->context = mg_start2(&init, &fault);
  if (!impl_->context) throw std::runtime_error("cannot listen on " + endpoint + ": " + reason);
  for (auto& [path, page] : impl_->pages) {
    mg_set_request_handler(impl_->context, (path + "$").c_str(), answer, &page);
  }
  mg_server_port port{};
  mg_get_server_ports(impl_->context, 1, &port);
  endpoint_ = endpoint.substr(0, endpoint.rfind(':') + 1) + std::to_string(port.port);
}

HttpServer::~HttpServer() {
  mg_stop(impl_->context);
}

}  // namespace saccade
