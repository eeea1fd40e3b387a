// The parameters of irradiance_cache, and what follows from them alone.
#pragma once

#include "cache/grid/surface_grid.h"
#include "methods/param_fields.h"

namespace saccade {

// irradiance_cache_params.cpp states the range and the source of each parameter.
struct IrradianceCacheParams {
  float cell_px = GridParams{}.cell_px;
  float tau = GridParams{}.blend.tau;
  float noise = GridParams{}.blend.noise;
  float noise_weight = GridParams{}.blend.noise_weight;
  int iterations = 3;
  float sigma_l = 3;
  float sigma_l_diff = 6;
  float target = 0.15f;
  float grid_paths = 1;
  int memory_mib = 256;
  float sigma_n = 128;
  float sigma_z = 1;

  static const std::vector<ParamField<IrradianceCacheParams>>& fields();

  // Of its grids, with so many paths per pixel. More paths prove finer detail.
  GridParams grid(int spp) const;
  // Bytes of all grids of a view.
  std::size_t gridBytes(double pixels) const;
};

// See MethodInfo::memory.
double irradianceCacheBytes(const ParamValues& params, const ViewTraits& view);

}  // namespace saccade
