// What one client says to a data server, over a real connection. The names of the streams stand for those of
// this input, which have packets to send; their tokens are filled in.
#include <limits>

#include "fuzz/fuzz_target.h"
#include "fuzz/inputs.pb.h"
#include "fuzz/message_mutator.h"
#include "mock/mock_subscriber.h"
#include "stream/data_server.h"

namespace saccade {
namespace {

constexpr int kMaxRequests = 32;  // their answers fit the server's queue
constexpr std::uint32_t kSensors = 2;
constexpr std::uint64_t kQueue = 150;  // bytes: a few packets

struct World {
  World() { server.start(); }

  SessionDirectory sessions;
  Traffic traffic;
  DataServer server{"tcp://127.0.0.1:*", sessions};
  std::shared_ptr<Signal> signal = std::make_shared<Signal>();
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

struct Answer {
  std::uint64_t packet_bytes = 0, largest = 0;
  int errors = 0;
};

// What comes before the refusal of one more request.
Answer receiveAll(MockSubscriber& client) {
  v1::StreamOpened none;
  none.set_stream_id("none");
  none.set_token("none");
  client.attach(none);
  Answer answer;
  while (true) {
    const auto packet = client.receive();
    SACCADE_CHECK(packet);
    if (packet->header.stream_id() == none.stream_id()) return answer;
    if (packet->header.kind() == v1::KIND_ERROR) {
      ++answer.errors;
    } else {
      answer.packet_bytes += packet->bytes;
      answer.largest = std::max<std::uint64_t>(answer.largest, packet->bytes);
    }
  }
}

bool read(std::string_view bytes) {
  static World world;
  ++world.inputs;
  MockSubscriber client(world.server.endpoint());
  fuzz::DataTalk talk;
  const bool parsed = talk.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()));
  const Served lossless(world, "lossless", v1::DELIVERY_LOSSLESS), live(world, "live", v1::DELIVERY_LIVE);
  if (!parsed) client.sendRaw(std::string(bytes));
  double credit = 0;
  for (int i = 0; parsed && i < std::min(kMaxRequests, talk.requests_size()); ++i) {
    v1::DataRequest& request = *talk.mutable_requests(i);
    fillIn(request, "lossless", *lossless);
    fillIn(request, "live", *live);
    credit += static_cast<double>(request.credit().bytes());
    client.sendRaw(request.SerializeAsString());
  }
  const Answer answer = receiveAll(client);
  if (parsed)
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
