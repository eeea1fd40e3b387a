#include "eval/bench/cell_bench.h"

#include <algorithm>

#include "eval/bench/open_scene.h"

namespace saccade::eval {

CellBench::CellBench(const BenchOptions& o, std::vector<Setting> baselines, std::vector<Setting> candidates,
                     const std::string& results)
    : o_(o),
      baselines_(std::move(baselines)),
      candidates_(std::move(candidates)),
      table_(results, o.text()),
      pool_(hardwareThreads()) {}

const Result* CellBench::find(const Cell& cell, const Setting& s) const {
  return table_.find(cell.name(), s.method.text, s.spp);
}

bool CellBench::isComplete(const Cell& cell) const {
  const auto stands = [&](const Setting& s) { return find(cell, s) != nullptr; };
  return std::all_of(baselines_.begin(), baselines_.end(), stands) &&
         std::all_of(candidates_.begin(), candidates_.end(), stands);
}

ComparedCell CellBench::compare(const Cell& cell) {
  ComparedCell compared{cell};
  if (!isComplete(cell)) compared.left_out = fill(cell);
  if (!compared.left_out.empty()) return compared;
  for (const Setting& s : baselines_) compared.baselines.push_back(*find(cell, s));
  for (const Setting& s : candidates_) compared.candidates.push_back(*find(cell, s));
  return compared;
}

// Measures the missing rows, or returns why the cell is left out.
std::string CellBench::fill(const Cell& cell) {
  if (!scene_ || scene_name_ != cell.scene)
    scene_ = openMovingScene(cell.scene, parseObjects(o_.setup.objects), o_.setup.animation),
    scene_name_ = cell.scene;
  BenchSetup setup = cell.setup(o_.setup);
  setup.reference_spp = 0;
  const std::string fault = whyLeftOut(cell, Bench(setup, scene_, pool_).view());
  if (!fault.empty()) return fault;
  setup.reference_spp = o_.setup.reference_spp;
  const Bench bench(setup, scene_, pool_);
  for (const auto* settings : {&baselines_, &candidates_})
    for (const Setting& s : *settings) measure(bench, cell.name(), s.method, s.spp, o_, table_);
  return {};
}

}  // namespace saccade::eval
