// Prints how many events a camera sees that moves to the right. Argument: the server, by default on this
// machine.
#include <chrono>
#include <iostream>

#include <saccade/subscription.h>

int main(int argc, char** argv) {
  using namespace saccade;
  zmq::context_t context;
  client::ControlClient control(context, argc > 1 ? argv[1] : "tcp://127.0.0.1:5770");
  v1::OpenStream request;
  request.set_scene("cornell-box");
  request.mutable_view()->set_width(64);
  request.mutable_view()->set_height(48);
  request.mutable_trajectory()->set_name("right");
  request.mutable_timing()->set_frame_rate_hz(1000);
  request.mutable_timing()->set_duration_s(0.05);
  request.add_sensors()->set_threshold(0.2);  // C
  client::StreamHandle stream(control, request);
  client::Subscription subscription(context, stream, {});
  for (bool ended = false; !ended;) {
    const auto batch = subscription.receive(std::chrono::seconds(1));
    if (!batch) continue;
    ended = batch->header.kind() == v1::KIND_END;
    std::cout << batch->events.size() << " events until " << batch->header.t1_ns() << " ns\n";
  }
}
