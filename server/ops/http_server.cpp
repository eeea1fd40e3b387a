#include "ops/http_server.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <utility>
#include <vector>

#include "ops/http_listener.h"

namespace saccade {
namespace {

constexpr std::size_t kMaxClients = 128;
constexpr int kWelcomesPerTurn = 64;
constexpr std::chrono::seconds kMaxTime{5};       // of a connection
constexpr int kGlanceMs = 1000;                   // at those whose time is up
constexpr std::chrono::milliseconds kPause{100};  // where the process may open no more files

bool noFileLeft() {
  return errno == EMFILE || errno == ENFILE;
}

}  // namespace

HttpServer::HttpServer(const std::string& endpoint, HttpPages pages)
    : pages_(std::move(pages)),
      listener_(listenForHttp(endpoint)),
      stop_(eventfd(0, EFD_CLOEXEC)),
      endpoint_(withPortOf(listener_, endpoint)),
      thread_([this] { run(); }) {}

HttpServer::~HttpServer() {
  eventfd_write(stop_, 1);
  thread_.join();
  close(stop_);
  close(listener_);
}

void HttpServer::run() {
  while (wait()) {
    std::erase_if(clients_, [this](HttpConnection& client) { return !client.goOn(pages_); });
    for (int i = 0; i < kWelcomesPerTurn && welcome(); ++i) {
    }
  }
}

// For something to do; false: to stop.
bool HttpServer::wait() const {
  std::vector<pollfd> awaited{{stop_, POLLIN, 0}, {listener_, POLLIN, 0}};
  for (const HttpConnection& client : clients_) awaited.push_back({client.socket(), client.awaits(), 0});
  poll(awaited.data(), awaited.size(), clients_.empty() ? -1 : kGlanceMs);
  return awaited[0].revents == 0;
}

// Answers one that waits to be let in, for its request has mostly come with it; false: nobody is.
bool HttpServer::welcome() {
  const int socket = accept4(listener_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
  if (socket < 0) return noFileLeft() && makeRoom();
  clients_.emplace_back(socket, HttpConnection::Clock::now() + kMaxTime);
  if (!clients_.back().goOn(pages_)) clients_.pop_back();
  if (clients_.size() > kMaxClients) clients_.pop_front();
  return true;
}

bool HttpServer::makeRoom() {
  if (clients_.empty()) std::this_thread::sleep_for(kPause);
  if (!clients_.empty()) clients_.pop_front();
  return !clients_.empty();
}

}  // namespace saccade
