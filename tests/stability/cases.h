// THE list of ways in which methods fail: one case each.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "stability/figures.h"

namespace saccade::test {

// The bounds that a method must hold in a case.
struct Claim {
  std::string method;
  double bound;  // of the figure that the case judges
  // Rivals that may be clearly better, and the reason.
  std::vector<std::string> beaten_by{};
  const char* why = "";
  double lap_ratio = 1.1;  // of a figure to the same of a lap before, at most; chance moves it by a tenth
};

struct StabilityCase {
  std::string name{};
  const char* why = "";  // why methods fail there
  std::string scene = "cornell-box", trajectory = "right";
  std::vector<std::string> objects = {};  // that move, as in BenchSetup
  double px_per_frame = 0;                // > 0: as in BenchSetup; 0: the trajectory as it is, at rate_hz
  double rate_hz = 250;
  bool jitter = false, mips = true;  // as in BenchSetup
  int width = 0, height = 0;         // 0: as wide and high as most cases of the form
  int last = 16, scored = 2;         // frames run from 0 to last; the last `scored` of them have a truth
  int truth_paths = 1;               // of the truth, in those of the form: more where light is hard to find
  int lap = 0;                       // > 0: the trajectory comes back to the same views after so many frames
  double threshold = 0.2, bias = 1e-3;               // C, natural log units; I_eps, scene luminance
  double Figures::*judged = &Figures::wrong_events;  // lower is better
  bool suppresses = false;                           // every method makes more events than a sensor sends
  std::vector<Claim> claims{};

  friend std::ostream& operator<<(std::ostream& out, const StabilityCase& c);
};

// The full form has larger pictures and longer runs. Bounds are regression guards from our own output: a
// quarter above the larger figure of 48x48 and 128x128. Another seed moves the figures by a tenth.
std::vector<StabilityCase> stabilityCases(bool full);
// Parts of that list:
std::vector<StabilityCase> motionCases();         // how the camera moves
std::vector<StabilityCase> bodyCases();           // how bodies move
std::vector<StabilityCase> bodyPlaceCases();      // where they move, and in which light
std::vector<StabilityCase> placeCases();          // where surfaces stand to each other, and to the camera
std::vector<StabilityCase> sceneCases();          // what the surfaces are like
std::vector<StabilityCase> lightCases();          // what the light is like
std::vector<StabilityCase> longCases(bool full);  // errors that time may add up

// The same views a lap earlier, where nothing is claimed.
StabilityCase lapBefore(StabilityCase c);

// The paths of the suite's own files.
std::string ownScene(const std::string& name);
std::string ownModel(const std::string& name);
std::string ownTrajectory(const std::string& name);

}  // namespace saccade::test
