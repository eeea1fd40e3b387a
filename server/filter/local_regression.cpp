#include "filter/local_regression.h"

#include <algorithm>
#include <cmath>

namespace saccade {
namespace {

constexpr std::size_t kTerms = kRegressionFeatures + 1;  // a comes first
constexpr std::size_t kFirstPlace = 4;                   // of the features
// Of the sum of weights, added to the diagonal: it stands for the published pseudo-inverse, which cuts
// singular values below 1e-8 of the largest [ours].
constexpr double kRidge = 1e-6;

struct Window {
  template <class F>
  void forEach(const F& f) const {
    for (int v = y0; v <= y1; ++v)
      for (int u = x0; u <= x1; ++u) f(u, v);
  }
  int x0, y0, x1, y1;  // inclusive
};

// The upper triangle of the normal equations, and their right side.
struct Equations {
  void add(const std::array<double, kTerms>& x, double w, double y) {
    for (std::size_t i = 0; i < kTerms; ++i) {
      for (std::size_t j = i; j < kTerms; ++j) m[i][j] += w * x[i] * x[j];
      r[i] += w * x[i] * y;
    }
  }

  // By Cholesky's decomposition, in place.
  std::array<double, kTerms> solve() {
    const double ridge = kRidge * m[0][0];
    for (std::size_t i = 1; i < kTerms; ++i) m[i][i] += ridge;
    for (std::size_t i = 0; i < kTerms; ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        for (std::size_t j = i; j < kTerms; ++j) m[i][j] -= m[k][i] * m[k][j];
        r[i] -= m[k][i] * r[k];
      }
      const double root = std::sqrt(std::max(m[i][i], ridge));
      for (std::size_t j = i; j < kTerms; ++j) m[i][j] /= root;
      m[i][i] = root, r[i] /= root;
    }
    for (std::size_t i = kTerms; i-- > 0;) {
      for (std::size_t j = i + 1; j < kTerms; ++j) r[i] -= m[i][j] * r[j];
      r[i] /= m[i][i];
    }
    return r;
  }

  std::array<std::array<double, kTerms>, kTerms> m{};
  std::array<double, kTerms> r{};
};

// The ranges of a model. `varies` tells which features have more than one value, up to rounding.
RegressionFeatures rangesOf(const GBuffer& g, const Window& window, const RegressionFeatures& centre,
                            std::array<bool, kRegressionFeatures>& varies) {
  RegressionFeatures low = centre, high = centre, range;
  window.forEach([&](int u, int v) {
    const RegressionFeatures x = featuresAt(g, u, v);
    for (std::size_t k = 0; k < x.size(); ++k)
      low[k] = std::min(low[k], x[k]), high[k] = std::max(high[k], x[k]);
  });
  for (std::size_t k = 0; k < range.size(); ++k) {
    const float size = k < kFirstPlace ? 1 : std::abs(centre.back());
    varies[k] = high[k] - low[k] > 1e-5f * size;
    range[k] = varies[k] ? high[k] - low[k] : size;
  }
  return range;
}

}  // namespace

std::array<float, 3> placeAt(const GBuffer& g, float x, float y, float z) {
  const auto half = [](int size) { return 0.5f * static_cast<float>(size - 1); };
  const float unit = 1 / static_cast<float>(g.z.width());
  return {(x - half(g.z.width())) * z * unit, (y - half(g.z.height())) * z * unit, z};
}

RegressionFeatures featuresAt(const GBuffer& g, int x, int y) {
  const auto place = placeAt(g, static_cast<float>(x), static_cast<float>(y), g.z.at(x, y));
  const float E = g.emission.at(x, y);
  return {g.albedo.at(x, y) + E / (E + 1),
          g.nx.at(x, y),
          g.ny.at(x, y),
          g.nz.at(x, y),
          place[0],
          place[1],
          place[2]};
}

LocalModel fitLocally(const GBuffer& g, const ImageF& brightness, int x, int y, int radius) {
  const Window window{std::max(x - radius, 0), std::max(y - radius, 0), std::min(x + radius, g.z.width() - 1),
                      std::min(y + radius, g.z.height() - 1)};
  const RegressionFeatures centre = featuresAt(g, x, y);
  std::array<bool, kRegressionFeatures> varies;
  LocalModel model;
  model.range = rangesOf(g, window, centre, varies);
  Equations equations;
  window.forEach([&](int u, int v) {
    const RegressionFeatures at = featuresAt(g, u, v);
    std::array<double, kTerms> terms{1};
    double w = 1;
    for (std::size_t k = 0; k < at.size(); ++k) {
      const double t = varies[k] ? (at[k] - centre[k]) / model.range[k] : 0;
      terms[k + 1] = t, w *= std::max(0.75 * (1 - t * t), 1e-8);
    }
    equations.add(terms, w, brightness.at(u, v));
  });
  const std::array<double, kTerms> solved = equations.solve();
  model.a = static_cast<float>(solved[0]);
  for (std::size_t k = 0; k < model.b.size(); ++k)
    model.b[k] = varies[k] ? static_cast<float>(solved[k + 1] / model.range[k]) : 0;
  return model;
}

}  // namespace saccade
