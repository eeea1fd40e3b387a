// The cases of errors that time may add up.
#include "stability/cases.h"

namespace saccade::test {

std::vector<StabilityCase> longCases(bool full) {
  return {
      {.name = "drift",
       .why = "changes of brightness, added up: small errors of one sign add up too",
       .rate_hz = 300,
       .width = full ? 64 : 48,
       .height = full ? 64 : 48,
       .last = full ? 2000 : 200,
       .scored = 1,
       .judged = &Figures::drift,
       .claims = {{"event_svgf", 0.31}, {"irradiance_cache", 0.094}}},
      {.name = "loop",
       .why = "the camera goes round once, and on the second lap all has been seen",
       .scene = ownScene("room"),
       .trajectory = ownTrajectory("laps"),
       .rate_hz = full ? 375 : 187.5,
       .last = full ? 238 : 119,
       .lap = full ? 120 : 60,
       .claims = {{.method = "event_svgf", .bound = 0.265},
                  {.method = "irradiance_cache", .bound = 0.115, .lap_ratio = 1.03}}},
      {.name = "long_run",
       .why = "a camera in the hand, which moves alike every 100 frames: what adds up or fills up shows in "
              "the end",
       .scene = ownScene("room"),
       .trajectory = "shake",
       .rate_hz = 50,
       .width = full ? 64 : 48,
       .height = full ? 64 : 48,
       .last = full ? 2050 : 150,
       .lap = full ? 1900 : 100,
       .judged = &Figures::drift,
       .claims =
           {{.method = "event_svgf",
             .bound = 0.105,
             .beaten_by = {"svgf"},
             .why = "it filters each change alone, and the errors stay in their sum; the changes of svgf add "
                    "up to its last picture"},
            {"irradiance_cache", 0.05}}},
      {.name = "standing",
       .why = "nothing changes, so that every event is false; seen by the most sensitive of sensors",
       .scene = "textured-cornell-box",
       .trajectory = "still",
       .last = full ? 500 : 60,
       .scored = 0,
       .threshold = 0.01,
       .bias = 1e-8,
       .judged = &Figures::events,
       .claims = {{"event_svgf", 0}, {"irradiance_cache", 0}, {"pt-correlated", 0}}},
  };
}

}  // namespace saccade::test
