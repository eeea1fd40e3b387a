#include "eval/tasks/nelder_mead.h"

#include <algorithm>
#include <cmath>

namespace saccade::eval {
namespace {

struct Vertex {
  Variables at;
  double value;
};

class Simplex {
 public:
  Simplex(const std::function<double(const Variables&)>& f, const Variables& start, double step) : f_(f) {
    vertices_.push_back(vertex(start));
    for (std::size_t i = 0; i < start.size(); ++i) {
      Variables at = start;
      at[i] += step;
      vertices_.push_back(vertex(at));
    }
    sort();
  }

  const Variables& best() const { return vertices_.front().at; }
  int calls() const { return calls_; }

  double size() const {
    double size = 0;
    for (const Vertex& v : vertices_)
      for (std::size_t i = 0; i < v.at.size(); ++i) size = std::max(size, std::abs(v.at[i] - best()[i]));
    return size;
  }

  void improve() {
    Vertex& worst = vertices_.back();
    const Vertex reflected = beyond(1);
    if (reflected.value < vertices_.front().value) {
      const Vertex expanded = beyond(2);
      worst = expanded.value < reflected.value ? expanded : reflected;
    } else if (reflected.value < vertices_[vertices_.size() - 2].value) {
      worst = reflected;
    } else {
      const Vertex contracted = beyond(reflected.value < worst.value ? 0.5 : -0.5);
      if (contracted.value < std::min(worst.value, reflected.value))
        worst = contracted;
      else
        shrink();
    }
    sort();
  }

 private:
  Vertex vertex(const Variables& at) {
    ++calls_;
    return {at, f_(at)};
  }

  // Through the middle of all but the worst one, by `times` its distance from that.
  Vertex beyond(double times) {
    const Variables& worst = vertices_.back().at;
    Variables at(worst.size());
    for (std::size_t i = 0; i < at.size(); ++i) {
      double middle = 0;
      for (std::size_t v = 0; v + 1 < vertices_.size(); ++v)
        middle += vertices_[v].at[i] / static_cast<double>(at.size());
      at[i] = middle + times * (middle - worst[i]);
    }
    return vertex(at);
  }

  void shrink() {
    for (std::size_t v = 1; v < vertices_.size(); ++v) {
      Variables at = vertices_[v].at;
      for (std::size_t i = 0; i < at.size(); ++i) at[i] = (at[i] + best()[i]) / 2;
      vertices_[v] = vertex(at);
    }
  }

  void sort() {
    std::stable_sort(vertices_.begin(), vertices_.end(),
                     [](const Vertex& a, const Vertex& b) { return a.value < b.value; });
  }

  const std::function<double(const Variables&)>& f_;
  std::vector<Vertex> vertices_;
  int calls_ = 0;
};

}  // namespace

Variables minimise(const std::function<double(const Variables&)>& f, const Variables& start, double step,
                   double tolerance, int most_calls) {
  Simplex simplex(f, start, step);
  while (simplex.size() > tolerance && simplex.calls() < most_calls) simplex.improve();
  return simplex.best();
}

}  // namespace saccade::eval
