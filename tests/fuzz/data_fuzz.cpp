// Messages of one client to a data server, over a real connection. The names of the streams stand for those
// of this input, which have packets to send; their tokens are filled in.
#include <algorithm>
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

struct Answer {
  std::uint64_t packet_bytes = 0, largest = 0;
  int errors = 0;
};

// A connection of its own for each input: its credit goes with it.
class Client {
 public:
  Client(zmq::context_t& context, const std::string& endpoint) : socket_(context, zmq::socket_type::dealer) {
    socket_.set(zmq::sockopt::linger, 0);
    socket_.set(zmq::sockopt::rcvtimeo, 5000);
    socket_.connect(endpoint);
  }
  void send(const std::string& bytes) { socket_.send(zmq::buffer(bytes)); }

  // Bytes before the refusal of one more request.
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
  zmq::socket_t socket_;
};

struct World {
  World() { server.start(); }

  SessionDirectory sessions;
  Traffic traffic;
  DataServer server{"tcp://127.0.0.1:*", sessions, std::int64_t{1} << 32};
  std::shared_ptr<ChangeNotifier> notifier = std::make_shared<ChangeNotifier>();
  zmq::context_t context;  // of all clients
  std::uint64_t inputs = 0;
};

// A stream that is there for one input.
class Served {
 public:
  Served(World& world, const std::string& name, v1::Delivery delivery)
      : world_(world),
        session_(std::make_shared<Session>(name + std::to_string(world.inputs), delivery, kSensors,
                                           world.server.wake(), world.notifier, world.traffic, kQueue)) {
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
    session_->makeRoom();
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

// Says it all, and returns how much credit it gives.
double sayTo(Client& client, fuzz::DataTalk talk, const Session& lossless, const Session& live) {
  double credit = 0;
  for (int i = 0; i < std::min(kMaxRequests, talk.requests_size()); ++i) {
    v1::DataRequest& request = *talk.mutable_requests(i);
    fillIn(request, "lossless", lossless);
    fillIn(request, "live", live);
    credit += static_cast<double>(request.credit().bytes());
    client.send(request.SerializeAsString());
  }
  return credit;
}

bool read(std::string_view bytes) {
  static World world;
  ++world.inputs;
  const Served lossless(world, "lossless", v1::DELIVERY_LOSSLESS), live(world, "live", v1::DELIVERY_LIVE);
  Client client(world.context, world.server.endpoint());
  fuzz::DataTalk talk;
  double credit = 0;
  if (talk.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) {
    credit = sayTo(client, std::move(talk), *lossless, *live);
  } else {
    client.send(std::string(bytes));
  }
  const Answer answer = client.receiveAll();
  // The last packet may overdraw the credit.
  SACCADE_CHECK(static_cast<double>(answer.packet_bytes) <= credit + static_cast<double>(answer.largest));
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
