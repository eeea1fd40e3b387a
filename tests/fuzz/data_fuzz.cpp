// What one client says to a data server, over a real connection. The names of the streams stand for those of
// this input, which have packets to send; their tokens are filled in.
#include <algorithm>
#include <optional>
#include <zmq.hpp>

#include "fuzz/fuzz_target.h"
#include "fuzz/inputs.pb.h"
#include "fuzz/message_mutator.h"
#include "stream/data_server.h"

namespace saccade {
namespace {

constexpr int kMaxRequests = 32;  // their answers fit the server's queue
constexpr std::uint32_t kSensors = 2;
constexpr std::uint64_t kQueue = 150;  // bytes: a few packets
constexpr double kMuch = 1e4;          // bytes of credit: another input shall not be told by it

struct Answer {
  std::uint64_t packet_bytes = 0, largest = 0;
  int errors = 0;
};

class Client {
 public:
  explicit Client(const std::string& endpoint) : socket_(context_, zmq::socket_type::dealer) {
    socket_.set(zmq::sockopt::linger, 0);
    socket_.set(zmq::sockopt::rcvtimeo, 5000);
    socket_.connect(endpoint);
  }
  void send(const std::string& bytes) { socket_.send(zmq::buffer(bytes)); }

  // What comes before the refusal of one more request.
  Answer receiveAll() {
    v1::DataRequest last;
    last.mutable_attach()->set_stream_id("none");
    send(last.SerializeAsString());
    Answer answer;
    while (true) {
      v1::PacketHeader header;
      take(header, answer);
      if (header.stream_id() == "none") return answer;
      if (header.kind() == v1::KIND_ERROR) ++answer.errors;
    }
  }

 private:
  void take(v1::PacketHeader& header, Answer& answer) {
    zmq::message_t head, payload;
    SACCADE_CHECK(receive(head) && head.more() && receive(payload));
    SACCADE_CHECK(header.ParseFromArray(head.data(), static_cast<int>(head.size())));
    if (header.kind() != v1::KIND_EVENTS) return;
    answer.packet_bytes += head.size() + payload.size();
    answer.largest = std::max<std::uint64_t>(answer.largest, head.size() + payload.size());
  }
  // Again where libFuzzer's clock has rung.
  bool receive(zmq::message_t& part) {
    while (true) {
      try {
        return socket_.recv(part).has_value();
      } catch (const zmq::error_t& fault) {
        if (fault.num() != EINTR) throw;
      }
    }
  }
  zmq::context_t context_;
  zmq::socket_t socket_;
};

struct World {
  World() { server.start(); }

  SessionDirectory sessions;
  Traffic traffic;
  DataServer server{"tcp://127.0.0.1:*", sessions, std::int64_t{1} << 32};
  std::shared_ptr<Signal> signal = std::make_shared<Signal>();
  std::optional<Client> client;
  double credit = 0;  // bytes that the client may be sent, at most
  std::uint64_t inputs = 0;
};

// A stream that is there for one input.
class Served {
 public:
  Served(World& world, const std::string& name, v1::Delivery delivery)
      : world_(world),
        session_(std::make_shared<Session>(name + std::to_string(world.inputs), delivery, kSensors,
                                           world.server.wake(), world.signal, world.traffic, kQueue)) {
    for (std::uint64_t i = 0; i < 3 * kSensors; ++i) push(i % kSensors, i / kSensors);
    session_->finish();
    world.sessions.add(session_);
  }
  ~Served() { world_.sessions.remove(session_->id()); }
  const Session& operator*() const { return *session_; }

 private:
  void push(std::uint64_t sensor, std::uint64_t seq) {
    v1::PacketHeader header;
    header.set_stream_id(session_->id());
    header.set_kind(v1::KIND_EVENTS);
    header.set_sensor(static_cast<std::uint32_t>(sensor));
    header.set_seq(seq);
    session_->push(sealPacket(std::move(header), "payload"));
  }
  World& world_;
  std::shared_ptr<Session> session_;
};

void fillIn(v1::DataRequest& request, const std::string& name, const Session& session) {
  if (!request.has_attach() || request.attach().stream_id() != name) return;
  request.mutable_attach()->set_stream_id(session.id());
  if (request.attach().token().empty()) request.mutable_attach()->set_token(session.token());
}

// Says it all, and returns the answer.
Answer talkTo(World& world, fuzz::DataTalk talk) {
  const Served lossless(world, "lossless", v1::DELIVERY_LOSSLESS), live(world, "live", v1::DELIVERY_LIVE);
  for (int i = 0; i < std::min(kMaxRequests, talk.requests_size()); ++i) {
    v1::DataRequest& request = *talk.mutable_requests(i);
    fillIn(request, "lossless", *lossless);
    fillIn(request, "live", *live);
    world.credit += static_cast<double>(request.credit().bytes());
    world.client->send(request.SerializeAsString());
  }
  return world.client->receiveAll();
}

bool read(std::string_view bytes) {
  static World world;
  ++world.inputs;
  if (!world.client || world.credit > kMuch) world.client.emplace(world.server.endpoint()), world.credit = 0;
  fuzz::DataTalk talk;
  if (!talk.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) {
    talk.Clear();
    v1::DataRequest request;  // which it may be nevertheless
    if (request.ParseFromArray(bytes.data(), static_cast<int>(bytes.size())))
      world.credit += static_cast<double>(request.credit().bytes());
    world.client->send(std::string(bytes));
  }
  const Answer answer = talkTo(world, std::move(talk));
  // A packet may overdraw, and so may one of the input before that comes only now; both are then forgotten
  // with their streams.
  SACCADE_CHECK(static_cast<double>(answer.packet_bytes) <=
                world.credit + 2 * static_cast<double>(answer.largest));
  world.credit = std::max(0., world.credit - static_cast<double>(answer.packet_bytes));
  return answer.errors == 0;
}

}  // namespace

const FuzzTarget& fuzzTarget() {
  static const std::vector<std::string> words{"lossless", "live", "", "0123456789abcdef0123456789abcdef",
                                              "\xc3\xa9"};
  static const FuzzTarget target{
      {bytesOf<fuzz::DataTalk>(
           "requests { attach { stream_id: 'lossless' } } requests { credit { bytes: 100 } } "
           "requests { ack { seq: 1 } } requests { credit { bytes: 1000 } }"),
       bytesOf<fuzz::DataTalk>(
           "requests { attach { stream_id: 'live' } } requests { credit { bytes: 50 } } "
           "requests { attach { stream_id: 'lossless' } } requests { ack { sensor: 1 } }")},
      words,
      read,
      [](const std::string& bytes, Draws& draw) { return mutateBytesOf<fuzz::DataTalk>(bytes, words, draw); },
      1000};
  return target;
}

}  // namespace saccade
