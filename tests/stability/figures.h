// Text about a method in a case of the stability suite.
#pragma once

#include <array>

namespace saccade::test {

// Rates are per pixel-frame. NaN where the case has no truth, or no repeats.
struct Figures {
  // False and missed ones of the scored frames, integrated over the threshold phase: of dL, before a sensor.
  double wrong_events;
  double false_events, missed_events;
  double dL_l1;       // relative L1 of dL
  double sigma_dL;    // over repeats, median over unchanged surfaces
  double drift;       // median |L - L_truth| after the last frame, of a default sensor, natural log units
  double events;      // that a default sensor sends, all frames
  double suppressed;  // that it withholds, all frames
  double non_finite;  // values of dI, I_prev, I_now and dL as reconstructed, all frames
};

struct FigureColumn {
  const char* name;
  double Figures::*value;
};
inline constexpr std::array<FigureColumn, 9> kFigureColumns{{
    {"wrong_events", &Figures::wrong_events},
    {"false_events", &Figures::false_events},
    {"missed_events", &Figures::missed_events},
    {"dL_l1", &Figures::dL_l1},
    {"sigma_dL", &Figures::sigma_dL},
    {"drift", &Figures::drift},
    {"events", &Figures::events},
    {"suppressed", &Figures::suppressed},
    {"non_finite", &Figures::non_finite},
}};

}  // namespace saccade::test
