#include "methods/irradiance_cache_params.h"

#include <algorithm>
#include <cmath>

namespace saccade {
namespace {

using P = IrradianceCacheParams;

// `memory_mib` bounds them, and so does what 25 pictures show that have nothing in common.
double bytesOfGrids(int memory_mib, double pixels) {
  constexpr double kMostPerPixel = 5000;
  return std::min(memory_mib * double(1 << 20), kMostPerPixel * pixels);
}

}  // namespace

const std::vector<ParamField<P>>& P::fields() {
  static const std::vector<ParamField<P>> table{
      {"cell_px", &P::cell_px, 0.1, 16,
       "edge of the finest cells with 2 paths, pixels; it is scaled by sqrt(2 / spp), to 0.35 at least",
       "[ours]", "finest"},
      {"tau", &P::tau, 0, 10, "standard deviations by which detail must exceed its noise", "[ours]"},
      {"noise", &P::noise, 0.001, 100, "variance of an interpolated mean, relative to that of one sample",
       "[ours]"},
      {"noise_weight", &P::noise_weight, 0, 100,
       "weight of noise against energy when detail is kept or dropped", "[ours]", "caution"},
      {"iterations", &P::iterations, 0, 5, "a-trous iterations, of spacing 1, 2, 4, ...", "[ours]"},
      {"sigma_l", &P::sigma_l, 0.01, 1000,
       "luminance tolerance of the primal, standard deviations of the mean", "[ours]"},
      {"sigma_l_diff", &P::sigma_l_diff, 0.01, 1000, "luminance tolerance of the difference, likewise",
       "[ours]"},
      {"target", &P::target, 0.0001, 10,
       "relative error below which a pixel gets fewer paths; it is scaled by sqrt(2 / spp)", "[ours]"},
      {"grid_paths", &P::grid_paths, 0, 64,
       "time of the grid in paths per pixel: so many paths are dropped, at most half of spp", "[ours]"},
      {"memory_mib", &P::memory_mib, 1, 65536,
       "MiB of the grid, which has at most 5 kB per pixel; at least what two frames need", "[ours]",
       "memory"},
      {"sigma_n", &P::sigma_n, 0, 1024, "normal exponent [E (24)]", "Falcor"},
      {"sigma_z", &P::sigma_z, 0.01, 1000, "depth tolerance, slopes [E (23)]", "Falcor"},
  };
  return table;
}

GridParams P::grid(int spp) const {
  constexpr float kLeast = 0.35f;
  const float edge = cell_px * std::sqrt(2 / static_cast<float>(std::max(2, spp)));
  return {.cell_px = std::max(std::min(kLeast, cell_px), edge),
          .blend = {.tau = tau, .noise = noise, .noise_weight = noise_weight}};
}

std::size_t P::gridBytes(double pixels) const {
  return static_cast<std::size_t>(bytesOfGrids(memory_mib, pixels));
}

// Measured with the least `memory_mib` on pictures of 512x512 of curved meshes and of the staircase.
double irradianceCacheBytes(const ParamValues& params, const ViewTraits& view) {
  constexpr double kPlaces = 1900, kMorePlaces = 1700, kTwoFrames = 600;  // per pixel
  constexpr double kPairs = 500, kMorePairs = 1000;                       // where a picture shows metals
  constexpr double kShadows = 300, kMoreShadows = 900;                    // rays to four lamps
  constexpr double kChanges = 1300, kMoreChanges = 200;  // where objects move: replays, changes, their grid
  const double of_jitter = kMorePlaces + kMorePairs + kMoreShadows + (view.moves ? kMoreChanges : 0);
  const double of_pixel = kPlaces + kPairs + kShadows + (view.moves ? kChanges : 0);
  return view.pixels * (of_pixel + (view.jitter ? of_jitter : 0)) +
         std::max(view.pixels * kTwoFrames,
                  bytesOfGrids(static_cast<int>(params.at("memory_mib")), view.pixels));
}

}  // namespace saccade
