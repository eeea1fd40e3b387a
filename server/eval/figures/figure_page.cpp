#include "eval/figures/figure_page.h"

#include <filesystem>
#include <set>

#include "base/names.h"
#include "eval/pictures/page.h"

namespace saccade::eval {
namespace {

namespace fs = std::filesystem;

// "out/figure7_box.svg" of figure 7, not of figure 71.
bool isOf(const std::string& figure, const std::string& file) {
  return file.starts_with(figure + ".") || file.starts_with(figure + "_");
}

// The files of a folder that belong to a figure, sorted.
std::set<std::string> filesOf(const std::string& figure, const std::string& folder, const char* extension) {
  std::set<std::string> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (isOf(figure, name) && name.ends_with(extension)) files.insert(name);
  }
  return files;
}

void addFigure(const FigureRun& run, const std::string& folder, Page& page) {
  const std::string name = "figure" + std::to_string(run.options.number);
  page.heading(name + ": " + run.figure->what);
  page.paragraph("Methods: " + joinNames(run.options.methods) + ".");
  page.paragraph("Settings: " + run.options.bench.text() + ".");
  page.paragraph("Tables: " + joinNames(filesOf(name, folder, ".csv")) + ".");
  for (const std::string& picture : filesOf(name, folder, ".svg")) page.picture(picture);
}

}  // namespace

void writeFigurePage(const std::vector<FigureRun>& runs, const std::string& folder) {
  Page page("Saccade: figures of the paper");
  for (const FigureRun& run : runs) addFigure(run, folder, page);
  page.write((fs::path(folder) / "index.html").string());
}

}  // namespace saccade::eval
