// Scores the frames of a method: all metrics of charts, figures and tables, averaged over the scored frames
// and over repeats with different seeds.
#pragma once

#include <array>
#include <span>

#include "eval/bench/bench.h"

namespace saccade::eval {

// All rates are per pixel-frame. Lower is better, and of a share 1 is right. NaN where a score has no
// meaning: noise of a single repeat, a region without pixels.
struct Score {
  double dI_l1, dI_mape, dL_l1, dL_mape;             // plane_error.h
  double dI_error, dI_share, dL_error, dL_share;     // noise_free_error.h, over all pixels and frames
  double false_events, missed_events;                // integrated over the threshold phase, event_rates.h
  double false_smooth, false_curved, false_changed;  // the same over the pixels of a region, regions.h
  double missed_smooth, missed_curved, missed_changed;
  double sigma_dL;                   // median over unchanged surfaces of the standard deviation over repeats
  double rms_dL, bias_dL, noise_dL;  // error_parts.h, over all pixels; roots of mean squares over frames
  double rms_smooth, rms_curved, rms_changed;  // of dL in a region
  double count_error, voxel_error;  // event_streams.h, over all scored frames; sensors that believe dL alone
  double time_error_ms;             // mean distance of an event to the nearest of the truth, at most 5
  double phase_error;               // event_phases.h, a root like those of rms; NaN for a single frame
};

struct ScoreColumn {
  const char *name, *label;  // in tables; in charts
  double Score::*value;
  const char* goal = "lower is better";  // in charts
};
inline constexpr std::array<ScoreColumn, 27> kScoreColumns{{
    {"dI_l1", "relative L1 of dI", &Score::dI_l1},
    {"dI_mape", "MAPE of dI", &Score::dI_mape},
    {"dL_l1", "relative L1 of dL", &Score::dL_l1},
    {"dL_mape", "MAPE of dL", &Score::dL_mape},
    {"dI_error", "noise-free error of dI", &Score::dI_error},
    {"dI_share", "share of dI that arrives", &Score::dI_share, "1 is right"},
    {"dL_error", "noise-free error of dL", &Score::dL_error},
    {"dL_share", "share of dL that arrives", &Score::dL_share, "1 is right"},
    {"false_events", "false events per pixel-frame", &Score::false_events},
    {"missed_events", "missed events per pixel-frame", &Score::missed_events},
    {"false_smooth", "false events, smooth surfaces", &Score::false_smooth},
    {"false_curved", "false events, curved surfaces", &Score::false_curved},
    {"false_changed", "false events, surface changed", &Score::false_changed},
    {"missed_smooth", "missed events, smooth surfaces", &Score::missed_smooth},
    {"missed_curved", "missed events, curved surfaces", &Score::missed_curved},
    {"missed_changed", "missed events, surface changed", &Score::missed_changed},
    {"sigma_dL", "sigma of dL, unchanged surfaces", &Score::sigma_dL},
    {"rms_dL", "rms error of dL", &Score::rms_dL},
    {"bias_dL", "bias of dL", &Score::bias_dL},
    {"noise_dL", "noise of dL", &Score::noise_dL},
    {"rms_smooth", "rms error of dL, smooth", &Score::rms_smooth},
    {"rms_curved", "rms error of dL, curved", &Score::rms_curved},
    {"rms_changed", "rms error of dL, surface changed", &Score::rms_changed},
    {"count_error", "count error of events", &Score::count_error},
    {"voxel_error", "voxel error of events, 5 ms", &Score::voxel_error},
    {"time_error_ms", "time error of events, ms", &Score::time_error_ms},
    {"phase_error", "phase error of events", &Score::phase_error},
}};

const ScoreColumn& columnOf(double Score::*value);
std::string scoreNames();  // "dI_l1, dI_mape, ..." for messages

// `truth`: consecutive frames. `repeats`: runs of them at one setting with different seeds. At least one of
// each. `bias` is I_eps, `threshold` C.
Score scoreOf(const std::vector<Truth>& truth, std::span<const BenchRun> repeats, double bias,
              double threshold);

// The false events per pixel-frame that the noise of the truth makes; it makes as many missed ones. They are
// half of those that one half of the truth has against the other.
double ownFalseEvents(const std::vector<Truth>& truth, double bias, double threshold);

}  // namespace saccade::eval
