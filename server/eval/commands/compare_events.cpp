// `saccade-eval compare-events` compares two files of events, whoever wrote them.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

#include "base/number_in.h"
#include "eval/bench/arguments.h"
#include "eval/commands/commands.h"
#include "eval/files/file_comparison.h"
#include "eval/pictures/signed_picture.h"
#include "eval/pictures/text.h"

namespace saccade::eval {
namespace {

struct CompareEventsOptions {
  std::string a, b, size, picture;
  double window_s = 0.05;
  bool align = false, json = false;
};

// A line of the table: a number of A, of B, or of both together.
struct Figure {
  const char *name, *what;
  std::vector<double> values;
};

client::ImageSize sizeOf(const CompareEventsOptions& o) {
  if (o.size.empty()) return {};
  const Size size = parseSize(o.size);
  return {static_cast<std::uint32_t>(size.width), static_cast<std::uint32_t>(size.height)};
}

std::vector<Figure> figuresOf(const FileComparison& c) {
  const auto both = [&](auto figure) {
    return std::vector<double>{static_cast<double>((c.of_a.*figure)()),
                               static_cast<double>((c.of_b.*figure)())};
  };
  return {
      {"events", "", both(&StreamSummary::events)},
      {"seconds", "from the first event to the last", both(&StreamSummary::seconds)},
      {"rate_hz", "events per second", both(&StreamSummary::rate)},
      {"on_share", "share of ON events", both(&StreamSummary::onShare)},
      {"same_time", "share of events whose time another event has (TIDES)",
       both(&StreamSummary::sameTimeShare)},
      {"same_time_by_chance", "the same of a Poisson process of that rate, in microseconds",
       both(&StreamSummary::sameTimeByChance)},
      {"most_at_one_time", "events", both(&StreamSummary::mostAtOneTime)},
      {"count_error",
       "sum of |events of A - of B|, per pixel and polarity, over the events of B",
       {c.distance.countError()}},
      {"chamfer", "mean distance to the nearest event, A to B plus B to A (PECS)", {c.distance.chamfer()}},
      {"gaussian", "the same of 1 - exp(-d^2 / 0.4) (PECS)", {c.distance.gaussian()}},
      {"chamfer_px", "in pixels, a millisecond as a pixel", {c.distance.chamferPx()}},
      {"alone",
       "events in windows where the other file has none",
       {static_cast<double>(c.distance.alone())}}};
}

std::string numberOr(double value, const char* none) {
  return std::isfinite(value) ? format("%.6g", value) : none;
}

void printTable(const std::vector<Figure>& figures) {
  std::printf("%-20s %12s %12s\n", "", "A", "B");
  for (const Figure& f : figures) {
    std::string line = format("%-20s", f.name);
    for (const double value : f.values) line += format(" %12s", numberOr(value, "-").c_str());
    if (f.values.size() == 1) line += format(" %12s", "");
    std::printf("%s  %s\n", line.c_str(), f.what);
  }
}

// Infinite and unknown numbers are null.
void printJson(const std::vector<Figure>& figures) {
  std::string text;
  for (const Figure& f : figures) {
    text += format("%s\n  \"%s\": ", text.empty() ? "{" : ",", f.name);
    text += f.values.size() == 1
                ? numberOr(f.values[0], "null")
                : "[" + numberOr(f.values[0], "null") + ", " + numberOr(f.values[1], "null") + "]";
  }
  std::printf("%s\n}\n", text.c_str());
}

void writePicture(const CompareEventsOptions& o, const StreamDistance& distance) {
  const auto cell = [](const ImageF& plane) {
    const float scale = std::max(1.f, colorScale(plane));
    return signedPicture(plane, scale, format("full colour %.3g", static_cast<double>(scale)));
  };
  writeText(o.picture,
            drawPictureGrid(
                {"A, ON less OFF", "B, ON less OFF", "events of A less those of B"}, {""},
                {{cell(distance.balanceOfA()), cell(distance.balanceOfB()), cell(distance.difference())}},
                {"OFF, or fewer", "none, or equal", "ON, or more"}));
}

void runCompareEvents(const CompareEventsOptions& o) {
  if (!o.picture.empty()) checkOutputFile(o.picture, {".svg"});
  EventWindows a(o.a, sizeOf(o), o.align), b(o.b, sizeOf(o), o.align);
  const FileComparison result = compareFiles(a, b, std::llround(o.window_s * 1e9));
  const auto figures = figuresOf(result);
  o.json ? printJson(figures) : printTable(figures);
  if (!o.picture.empty()) writePicture(o, result.distance);
}

}  // namespace

void addCompareEventsCommand(CLI::App& app) {
  auto o = std::make_shared<CompareEventsOptions>();
  auto* c = app.add_subcommand("compare-events",
                               "compare two files of events: counts, rates, equal times, and distances; "
                               "draw a picture");
  c->add_option("A", o->a, "file to read: " + client::readerNames())->required()->check(CLI::ExistingFile);
  c->add_option("B", o->b, "the same, such as events of a camera")->required()->check(CLI::ExistingFile);
  c->add_option("--size", o->size, "WIDTHxHEIGHT, pixels, where a file does not tell its size");
  c->add_option("--window", o->window_s,
                "seconds; distances are taken between the events of one window, which are kept in memory, "
                "at most 4 million of each file")
      ->check(NumberIn(1e-6, 100.0))
      ->capture_default_str();
  c->add_flag("--align", o->align, "count the times of each file from its first event");
  c->add_flag("--json", o->json, "print JSON");
  c->add_option("-o,--output", o->picture,
                "SVG picture: events of A, of B, and the difference of their number");
  c->callback([o] { runCompareEvents(*o); });
}

}  // namespace saccade::eval
