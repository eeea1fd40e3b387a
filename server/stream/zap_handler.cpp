#include "stream/zap_handler.h"

#include <chrono>
#include <iterator>
#include <zmq_addon.hpp>

namespace saccade {
namespace {

constexpr std::size_t kKeyBytes = 32;
// ZMQ_ZAP_ENFORCE_DOMAIN, which Debian's header hides. Without it, CURVE without a handler accepts any key.
constexpr int kZapEnforceDomain = 93;

std::string keyText(const std::string& bytes) {
  char text[41];
  zmq_z85_encode(text, reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  return text;
}

// The parts of a request: version, request id, domain, address, identity, mechanism, credentials.
constexpr std::size_t kAddress = 3, kMechanism = 5, kCredentials = 6, kParts = 7;
constexpr const char* kRefused = "400";

// Empty where there is none.
std::string keyOf(const std::vector<std::string>& request) {
  const bool curve = request.size() == kParts && request[0] == "1.0" && request[kMechanism] == "CURVE" &&
                     request[kCredentials].size() == kKeyBytes;
  return curve ? keyText(request[kCredentials]) : "";
}

}  // namespace

std::vector<std::string> answerZap(const std::vector<std::string>& request, const ClientKeys& clients) {
  const std::string id = request.size() > 1 ? request[1] : "";
  const std::string key = keyOf(request);
  if (!clients.allow(key)) return {"1.0", id, kRefused, "the key is not on the list", "", ""};
  return {"1.0", id, "200", "OK", key, ""};
}

ZapHandler::ZapHandler(zmq::context_t& context, std::shared_ptr<ClientKeys> clients)
    : clients_(std::move(clients)), socket_(context, zmq::socket_type::rep) {
  socket_.set(zmq::sockopt::linger, 0);
  socket_.bind("inproc://zeromq.zap.01");
  thread_ = std::thread([this] { run(); });
}

ZapHandler::~ZapHandler() {
  stop_.wake();
  thread_.join();
}

void ZapHandler::run() {
  while (true) {
    zmq::pollitem_t items[] = {{socket_, 0, ZMQ_POLLIN, 0}, {nullptr, stop_.fd(), ZMQ_POLLIN, 0}};
    zmq::poll(items, 2, std::chrono::milliseconds(-1));
    if (items[1].revents) return;
    std::vector<zmq::message_t> parts;
    if (!zmq::recv_multipart(socket_, std::back_inserter(parts))) continue;
    std::vector<std::string> request;
    for (const auto& part : parts) request.push_back(part.to_string());
    std::vector<zmq::const_buffer> answer;
    const auto words = answerZap(request, *clients_);
    if (telling_ && words[2] == kRefused) tell(request);
    for (const auto& word : words) answer.push_back(zmq::buffer(word));
    zmq::send_multipart(socket_, answer);
  }
}

void ZapHandler::tell(const std::vector<std::string>& request) {
  clients_->countRefused();
  const std::string from = request.size() > kAddress ? request[kAddress] : "", key = keyOf(request);
  log_.write(spdlog::level::info,
             "refused a connection from " + (from.empty() ? "this machine" : from) + ": " +
                 (key.empty() ? "it has no key" : "its key " + key + " is not on the list"));
}

void secureServer(zmq::socket_t& socket, const std::string& secret_key) {
  const int on = 1;
  socket.set(zmq::sockopt::curve_server, true);
  socket.set(zmq::sockopt::curve_secretkey, secret_key);
  socket.set(zmq::sockopt::zap_domain, "saccade");
  if (zmq_setsockopt(socket.handle(), kZapEnforceDomain, &on, sizeof on) != 0) throw zmq::error_t();
}

}  // namespace saccade
