#include "eval/tasks/task_bench.h"

#include <algorithm>
#include <stdexcept>

#include "eval/bench/interrupt.h"
#include "eval/bench/progress.h"

namespace saccade::eval {
namespace {

class TaskRuns {
 public:
  TaskRuns(const Bench& bench, const TaskPlan& plan, TilePool& pool)
      : plan_(plan), truth_(truthOf(bench, plan.sensors.front().config.bias, pool)) {
    for (const Task* task : plan.tasks)
      if (task->applies(truth_)) tasks_.push_back(task);
    if (tasks_.empty())
      throw std::runtime_error(plan.scene +
                               ": no task applies; rotation needs a camera that only turns, ego_velocity "
                               "one that goes, and moving_objects a body that moves");
  }

  // Rows without scores, for each sensor and task.
  std::vector<TaskRow> rowsOf(const std::string& method, int spp) const {
    std::vector<TaskRow> rows;
    for (const TaskSensor& sensor : plan_.sensors)
      for (const Task* task : tasks_) rows.push_back({plan_.scene, sensor.noise, method, spp, task});
    return rows;
  }

  // Adds the scores of one run to the rows of its source.
  void score(const ChangeSequence& changes, int seed, double cpu_ms, std::vector<TaskRow>& rows) const {
    auto row = rows.begin();
    for (const TaskSensor& sensor : plan_.sensors) {
      const Events events = eventsFor(sensor, changes, seed, rows);
      const double pixels = static_cast<double>(truth_.camera.width) * truth_.camera.height;
      const TaskInput input{events, changes, sensor.config.threshold, sensor.config.bias, truth_};
      for (const Task* task : tasks_) {
        row->scores.push_back(task->score(input));
        row->cpu_ms += cpu_ms / plan_.repeats;
        row->events += double(events.size()) / pixels / double(changes.size()) / plan_.repeats;
        ++row;
        if (interrupted()) throw Interrupted{};
      }
    }
  }

 private:
  // The reference does not drift: it needs no reconstruction.
  static Events eventsFor(const TaskSensor& sensor, const ChangeSequence& changes, int seed,
                          const std::vector<TaskRow>& rows) {
    SensorConfig config = sensor.config;
    config.seed = static_cast<std::uint64_t>(seed);
    if (rows.front().isReference()) config.reconstruction = "direct";
    return eventsOf(changes, config);
  }

  const TaskPlan& plan_;
  const TaskTruth truth_;
  std::vector<const Task*> tasks_;
};

bool byNoise(const TaskPlan& plan, const TaskRow& a, const TaskRow& b) {
  const auto place = [&](const TaskRow& row) {
    return std::find_if(plan.sensors.begin(), plan.sensors.end(),
                        [&](const TaskSensor& sensor) { return sensor.noise == row.noise; });
  };
  return place(a) < place(b);
}

}  // namespace

std::vector<TaskRow> runTasks(const Bench& bench, const TaskPlan& plan, TilePool& pool) {
  const TaskRuns runs(bench, plan, pool);
  Progress progress("tasks of " + plan.scene,
                    static_cast<double>(1 + plan.methods.size() * plan.spp.size()) * plan.repeats);
  std::vector<TaskRow> all = runs.rowsOf(kReferenceSource, bench.setup().reference_spp);
  for (int seed = 1; seed <= plan.repeats; ++seed, progress.add(1))
    runs.score(sequenceOf(bench.truth()), seed, 0, all);
  for (const std::string& text : plan.methods) {
    const MethodSpec method = parseMethod(text);
    for (const int spp : plan.spp) {
      std::vector<TaskRow> rows = runs.rowsOf(text, spp);
      for (int seed = 1; seed <= plan.repeats; ++seed, progress.add(1)) {
        const BenchRun run = bench.run(method, spp, static_cast<std::uint64_t>(seed));
        runs.score(sequenceOf(run), seed, run.cpu_ms, rows);
      }
      all.insert(all.end(), rows.begin(), rows.end());
    }
  }
  std::stable_sort(all.begin(), all.end(),
                   [&](const TaskRow& a, const TaskRow& b) { return byNoise(plan, a, b); });
  return all;
}

}  // namespace saccade::eval
