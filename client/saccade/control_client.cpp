#include "saccade/control_client.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include "saccade/wire/protocol.h"

namespace saccade::client {
namespace {

constexpr std::chrono::milliseconds kPollInterval{200};  // between two calls of Waiting
constexpr std::chrono::milliseconds kParting{200};       // to deliver a last message when the socket closes
constexpr std::chrono::seconds kWatchInterval{1};
constexpr int kMostUnknown = 3;  // lists without a call, whose reply comes after it has left the list
constexpr std::uint64_t kUnreadRequest = 0;  // of a reply to an unreadable request; ours are not 0

std::uint64_t randomId() {
  std::random_device random;
  return std::uint64_t{random()} << 31 | random() >> 1;
}

std::string describe(const v1::Status& status) {
  std::string text = status.message();
  if (text.empty()) text = "refused with status " + std::to_string(status.code()) + ", without a reason";
  if (!status.field().empty()) text = status.field() + ": " + text;
  if (status.retry_after_s() > 0) {
    char hint[64];
    std::snprintf(hint, sizeof hint, " (try again in %g s)", status.retry_after_s());
    text += hint;
  }
  return text;
}

const v1::OpeningInfo* findOpening(const v1::StreamList& list, std::uint64_t request_id) {
  const auto& all = list.opening();
  const auto at = std::find_if(all.begin(), all.end(),
                               [&](const auto& opening) { return opening.request_id() == request_id; });
  return at == all.end() ? nullptr : &*at;
}

// The fault of a call that has gone with its server.
v1::Status lostCall() {
  v1::Status status;
  status.set_code(v1::CODE_UNAVAILABLE);
  status.set_message("the server has restarted and no longer knows the request");
  return status;
}

v1::Status refusedKey(const std::string& endpoint) {
  v1::Status status;
  status.set_code(v1::CODE_PERMISSION_DENIED);
  status.set_message("the server at " + endpoint +
                     " refuses your key: it is not on its list, the file of saccaded --client-keys");
  return status;
}

}  // namespace

NoAnswer::NoAnswer(const std::string& endpoint, bool has_keys)
    : runtime_error("no saccaded answers at " + endpoint), endpoint(endpoint), has_keys(has_keys) {}

Refused::Refused(const v1::Status& status)
    : runtime_error(describe(status)),
      code(status.code()),
      field(status.field()),
      message(status.message()) {}

ControlClient::ControlClient(zmq::context_t& context, const std::string& endpoint, const CurveKeys& keys)
    : endpoint_(endpoint),
      keys_(keys),
      socket_(connectSocket(context, zmq::socket_type::dealer, endpoint, keys,
                            [&](zmq::socket_t& socket) {
                              if (!keys.secret.empty()) key_watch_.emplace(context, socket);
                            })),
      request_id_(randomId()) {}

v1::Request listStreams() {
  v1::Request request;
  request.mutable_list_streams();
  return request;
}

v1::Reply ControlClient::call(v1::Request request, std::chrono::milliseconds deadline, const Waiting& waiting,
                              const Watching& watching) {
  const int call = request.call_case();
  requireKey();
  if (!send(std::move(request))) throw NoAnswer(endpoint_, !keys_.secret.empty());
  v1::Reply reply = await(request_id_, deadline, waiting, watching);
  if (reply.status().code() != v1::CODE_OK) throw Refused(reply.status());
  if (reply.result_case() != call)  // calls and results have the same numbers
    throw std::runtime_error("the server at " + endpoint_ + " sent a reply without the result of the call");
  return reply;
}

void ControlClient::tell(v1::Request request) {
  // Without this, closing the socket would drop the message.
  socket_.set(zmq::sockopt::linger, static_cast<int>(kParting.count()));
  send(std::move(request));
}

void ControlClient::requireKey() {
  if (key_watch_ && key_watch_->refused()) throw Refused(refusedKey(endpoint_));
}

bool ControlClient::send(v1::Request request) {
  request.set_request_id(++request_id_);
  request.set_protocol_version(kProtocolVersion);
  const std::string bytes = request.SerializeAsString();
  if (!v1::Request().ParseFromString(bytes))
    throw std::invalid_argument("a text of the request is not UTF-8");
  return socket_.send(zmq::buffer(bytes), zmq::send_flags::dontwait).has_value();
}

v1::Reply ControlClient::await(std::uint64_t request_id, std::chrono::milliseconds deadline,
                               const Waiting& waiting, const Watching& watching) {
  using Clock = std::chrono::steady_clock;
  const auto until = Clock::now() + deadline;
  auto watched = Clock::now();
  int unknown = 0;  // lists in a row that do not have the call
  for (auto left = deadline; left.count() > 0;
       left = std::chrono::ceil<std::chrono::milliseconds>(until - Clock::now())) {
    if (waiting) waiting();
    requireKey();
    if (watching && Clock::now() - watched >= kWatchInterval) send(listStreams()), watched = Clock::now();
    zmq::message_t message;
    if (!waitReadable(socket_, std::min(left, kPollInterval)) ||
        !socket_.recv(message, zmq::recv_flags::dontwait))
      continue;
    if (message.more())
      throw std::runtime_error(endpoint_ + " is not a control socket; is it the data port?");
    v1::Reply reply;
    if (!reply.ParseFromArray(message.data(), static_cast<int>(message.size())))
      throw std::runtime_error("the server at " + endpoint_ + " sent a reply that cannot be read");
    if (reply.request_id() == request_id || reply.request_id() == kUnreadRequest) return reply;
    if (!watching || !reply.has_list_streams()) continue;
    const v1::OpeningInfo* opening = findOpening(reply.list_streams(), request_id);
    if (opening) watching(*opening);
    unknown = opening ? 0 : unknown + 1;
    if (unknown == kMostUnknown) throw Refused(lostCall());
  }
  throw NoAnswer(endpoint_, !keys_.secret.empty());
}

}  // namespace saccade::client
