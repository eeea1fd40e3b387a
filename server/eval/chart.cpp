// `saccade-eval chart`: accuracy against CPU time for every method at several budgets, and pictures of each.
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <thread>

#include "eval/bench.h"
#include "eval/commands.h"
#include "eval/figure6.h"
#include "eval/method_spec.h"
#include "eval/results.h"
#include "eval/svg_chart.h"

namespace saccade {
namespace {

struct ChartOptions {
  std::vector<std::string> scenes{"cornell-box", "textured-cornell-box", "cornell-bunny"};
  std::vector<std::string> methods{"event_svgf", "svgf", "svgf:as_falcor=1", "pt-correlated", "pt"};
  std::vector<int> spp{1, 2, 4, 8, 32, 128};
  std::string size = "128x128", output;
  BenchSetup setup;
  double threshold = 0.2, bias = 1e-3;
  int pictures_spp = 2;
};

std::string settingsText(const ChartOptions& o) {
  std::ostringstream text;
  text << "trajectory " << o.setup.trajectory << "; " << o.setup.width << "x" << o.setup.height << "; "
       << o.setup.frame_rate_hz << " Hz; frame " << o.setup.frame << "; " << o.setup.bounces
       << " indirect bounces; C " << o.threshold << "; bias " << o.bias << "; reference of "
       << o.setup.reference_spp << " spp";
  return text.str();
}

IntensityChange toChange(const ReferenceChange& truth, double frame_rate_hz) {
  IntensityChange change(truth.dI.width(), truth.dI.height());
  change.t1 = frameTime(1, frame_rate_hz);
  change.dI.copyFrom(truth.dI);
  change.I_prev.copyFrom(truth.I_prev);
  change.I_now.copyFrom(truth.I_now);
  return change;
}

// Runs what is missing of one scene; a section of the page shows the methods at one budget.
void runScene(const ChartOptions& o, const std::string& scene, TilePool& pool, ResultTable& table,
              Page& page) {
  BenchSetup setup = o.setup;
  setup.scene = scene;
  const Bench bench(setup, pool);
  const IntensityChange truth = toChange(bench.truth(), setup.frame_rate_hz);
  const auto bias = static_cast<float>(o.bias);
  Figure6 figure(truth, bias, o.threshold);
  Progress progress(scene, static_cast<double>(o.methods.size() * o.spp.size()));
  for (const std::string& text : o.methods) {
    const MethodSpec method = parseMethod(text);
    for (const int spp : o.spp) {
      progress.add(1);
      const bool show = spp == o.pictures_spp;
      if (!method.takes(spp) || (!show && table.has(scene, text, spp))) continue;
      const BenchRun run = bench.run(method.name, spp, method.params, 1);
      const FrameErrors errors = frameErrors(run.change, truth, bias, o.threshold);
      if (show) figure.add(text + ", " + std::to_string(spp) + " spp", run.change, &errors);
      if (!table.has(scene, text, spp)) {
        table.add({scene, text, spp, run.cpu_ms, run.trace_ms, bench.truth().error(), errors});
      }
    }
  }
  figure.add("reference", truth, nullptr);
  char title[256];
  std::snprintf(title, sizeof title, "%s (error of the reference's dI: %.3f)", scene.c_str(),
                bench.truth().error());
  page.heading(title);
  figure.write(page);
}

struct Metric {
  const char* label;
  double (*of)(const Result&);
};
constexpr Metric kMetrics[] = {
    {"relative L1 of dI", [](const Result& r) { return r.errors.dI_l1; }},
    {"relative L1 of dL", [](const Result& r) { return r.errors.dL_l1; }},
    {"false events per pixel-frame", [](const Result& r) { return r.errors.rates.false_events; }},
    {"missed events per pixel-frame", [](const Result& r) { return r.errors.rates.missed_events; }},
};

std::vector<ChartPanel> makePanels(const ChartOptions& o, const ResultTable& table) {
  std::vector<ChartPanel> panels;
  for (const std::string& scene : o.scenes) {
    for (const Metric& metric : kMetrics) {
      ChartPanel panel{scene, "CPU ms per frame", metric.label, {}};
      for (const std::string& method : o.methods) {
        ChartLine line{method, {}};
        for (const int spp : o.spp) {
          for (const Result& r : table.rows()) {
            if (r.scene != scene || r.method != method || r.spp != spp) continue;
            // A logarithmic axis has no place for 0, nor for the infinite error where the truth is 0.
            const double error = metric.of(r);
            if (error > 0 && std::isfinite(error))
              line.points.push_back({r.cpu_ms, error, std::to_string(spp) + " spp"});
          }
        }
        panel.lines.push_back(std::move(line));
      }
      panels.push_back(std::move(panel));
    }
  }
  return panels;
}

void runChart(ChartOptions& o) {
  const Size size = parseSize(o.size);
  o.setup.width = size.width, o.setup.height = size.height;
  for (const std::string& method : o.methods) parseMethod(method);  // before anything is rendered
  const std::filesystem::path folder(o.output);
  ResultTable table((folder / "results.csv").string(), settingsText(o));
  TilePool pool(static_cast<int>(std::thread::hardware_concurrency()));
  Page page("Saccade: accuracy against time");
  page.paragraph(settingsText(o) + ". CPU time is that of all threads together.");
  watchInterrupt();
  try {
    for (const std::string& scene : o.scenes) runScene(o, scene, pool, table, page);
  } catch (const Interrupted&) {
    throw std::runtime_error("interrupted; the same command goes on where it stopped");
  }
  const std::string chart = drawCharts(makePanels(o, table), static_cast<int>(std::size(kMetrics)));
  std::ofstream(folder / "chart.svg") << chart;
  page.heading("Accuracy against time");
  page.svg(chart);
  page.write((folder / "index.html").string());
  std::printf("wrote %s, chart.svg and index.html\n", (folder / "results.csv").string().c_str());
}

}  // namespace

void addChartCommand(CLI::App& app) {
  auto o = std::make_shared<ChartOptions>();
  o->setup.cache = defaultCache();
  auto* c = app.add_subcommand(
      "chart", "accuracy against CPU time for every method; can be interrupted and gone on with");
  c->add_option("scenes", o->scenes, "scenes by name or scene.xml by path")->capture_default_str();
  c->add_option("--methods", o->methods, "names with settings, such as svgf:as_falcor=1")
      ->delimiter(',')
      ->capture_default_str();
  c->add_option("--spp", o->spp, "budgets, paths per pixel and frame")
      ->delimiter(',')
      ->check(CLI::Range(1, 65536))
      ->capture_default_str();
  c->add_option("--trajectory", o->setup.trajectory)->capture_default_str();
  c->add_option("--size", o->size, "WxH")->capture_default_str();
  c->add_option("--rate", o->setup.frame_rate_hz, "frames per second")
      ->check(CLI::Range(0.1, 1e5))
      ->capture_default_str();
  c->add_option("--frame", o->setup.frame, "the frame that is scored")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  c->add_option("--bounces", o->setup.bounces, "indirect bounces")
      ->check(CLI::Range(0, 64))
      ->capture_default_str();
  c->add_option("--reference", o->setup.reference_spp, "paths per pixel of the reference")
      ->check(CLI::Range(64, 1 << 20))
      ->capture_default_str();
  c->add_option("--threshold", o->threshold, "C of the event rates")
      ->check(CLI::Range(1e-3, 10.0))
      ->capture_default_str();
  c->add_option("--bias", o->bias, "I_eps")->check(CLI::Range(1e-12, 1e6))->capture_default_str();
  c->add_option("--cache", o->setup.cache, "folder that keeps reference frames")->capture_default_str();
  c->add_option("-o,--output", o->output, "folder for results.csv, chart.svg and index.html")->required();
  c->callback([o] { runChart(*o); });
}

}  // namespace saccade
