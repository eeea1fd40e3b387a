// `saccade-eval tasks` tells how well classical algorithms do on the events of methods.
#include <cstdio>
#include <filesystem>
#include <memory>

#include "base/names.h"
#include "base/new_folder.h"
#include "eval/bench/arguments.h"
#include "eval/bench/bench_options.h"
#include "eval/bench/interrupt.h"
#include "eval/bench/open_scene.h"
#include "eval/commands/commands.h"
#include "eval/pictures/text.h"
#include "eval/tasks/task_bench.h"
#include "eval/tasks/task_chart.h"
#include "events/noise/presets.h"

namespace saccade::eval {
namespace {

struct TasksOptions {
  BenchOptions bench;
  std::vector<std::string> scenes, tasks, noises{kNoNoise, "davis346"};
  std::vector<std::string> methods{"irradiance_cache", "event_svgf", "svgf", "pt"};
  std::vector<int> spp{2, 8, 32};
  std::string output = "out/tasks";
};

const Task& findTask(const std::string& name) {
  if (const Task* task = findRow(taskTable(), name)) return *task;
  throw CLI::ValidationError("--tasks",
                             "there is no \"" + name + "\"; there are: " + joinRowNames(taskTable()));
}

// The thresholds stay, so that noise alone is compared.
TaskSensor sensorOf(const BenchOptions& bench, const std::string& noise) {
  TaskSensor sensor{noise, {}};
  sensor.config.threshold = sensor.config.threshold_off = bench.threshold;
  sensor.config.bias = bench.bias;
  if (noise == kNoNoise) return sensor;
  const SensorPreset* preset = findPreset(noise);
  if (!preset)
    throw CLI::ValidationError(
        "--noise", "there is no \"" + noise + "\"; there are: " + kNoNoise + ", " + presetNames());
  sensor.config.noise = preset->noise;
  sensor.config.refractory = TimeNs(std::llround(1e9 * preset->refractory_s));
  return sensor;
}

TaskPlan planOf(const TasksOptions& o) {
  TaskPlan plan{"", {}, {}, o.methods, o.spp, o.bench.repeats};
  for (const std::string& name : o.tasks) plan.tasks.push_back(&findTask(name));
  for (const std::string& noise : o.noises) plan.sensors.push_back(sensorOf(o.bench, noise));
  return plan;
}

std::vector<TaskRow> runScene(const TasksOptions& o, const std::string& scene, TaskPlan plan,
                              TilePool& pool) {
  BenchSetup setup = o.bench.setup;
  setup.scene = scene, plan.scene = sceneName(scene);
  const Bench bench(setup, pool);
  std::printf("%s: %.2f px per frame, error of the reference's dI %.3f\n", plan.scene.c_str(),
              bench.medianPxPerFrame(), bench.referenceError());
  return runTasks(bench, plan, pool);
}

void runTasksOf(TasksOptions& o) {
  resolve(o.bench);
  requireTableNames(o.scenes);
  checkSpp(o.methods, o.spp);
  const TaskPlan plan = planOf(o);
  const std::filesystem::path folder(o.output);
  std::filesystem::create_directories(folder);
  TilePool pool(hardwareThreads());
  watchInterrupt();
  std::string csv = "# " + o.bench.text() + '\n';
  std::vector<TaskRow> all;
  try {
    for (const std::string& scene : o.scenes) {
      const std::vector<TaskRow> rows = runScene(o, scene, plan, pool);
      std::fputs(tableOf(rows).c_str(), stdout);
      writeText((folder / (sceneName(scene) + ".svg")).string(), chartOf(rows));
      all.insert(all.end(), rows.begin(), rows.end());
      writeText((folder / "tasks.csv").string(), csv + csvOf(all));
    }
  } catch (const Interrupted&) {
    throw std::runtime_error("interrupted; the same command keeps the reference frames so far");
  }
  std::printf("wrote %s/tasks.csv, and a chart for each scene\n", o.output.c_str());
}

}  // namespace

void addTasksCommand(CLI::App& app) {
  auto o = std::make_shared<TasksOptions>();
  o->bench.size = "64x48", o->bench.frames = "9:40";
  o->bench.setup.trajectory = "pan:0.5px", o->bench.setup.reference_spp = 512;
  std::string tasks;
  for (const Task& task : taskTable()) {
    o->tasks.emplace_back(task.name);
    tasks += std::string(tasks.empty() ? "" : "; ") + task.name + ": " + task.what;
  }
  auto* c = app.add_subcommand("tasks",
                               "tell how well classical algorithms do on the events of methods: a table, and "
                               "charts of their errors against the CPU time of rendering");
  c->add_option("scenes", o->scenes, "scenes by name, or by the path of a file or folder")->required();
  c->add_option("--tasks", o->tasks, tasks)->delimiter(',')->capture_default_str();
  c->add_option("--noise", o->noises,
                "none, or the noise and refractory period of a camera: " + presetNames() +
                    ". The thresholds stay those of --threshold")
      ->delimiter(',')
      ->capture_default_str();
  addMethodOptions(*c, o->methods, o->spp);
  addBenchOptions(*c, o->bench);
  c->add_option("-o,--output", o->output, "folder for the table and the charts")
      ->check(CLI::Validator(newFolderFault, ""))
      ->capture_default_str();
  c->callback([o] { runTasksOf(*o); });
}

}  // namespace saccade::eval
