// A queue with one server, a constant service time and a bounded number of places: M/D/1/K.
#pragma once

namespace saccade::eval {

struct QueueLoad {
  double lost;    // share of the arrivals
  double wait_s;  // of those that are taken, on average
};

// Arrivals are a Poisson process of `offered_hz`. The server takes `service_hz` > 0. `waiting`: places before
// the server. The chain of the numbers left behind at departures gives both [Kleinrock 1975, ch. 5; the
// balance of the steps up and down across a level ours].
QueueLoad expectedQueue(double offered_hz, double service_hz, int waiting);

}  // namespace saccade::eval
