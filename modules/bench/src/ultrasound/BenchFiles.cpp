#include "report/CellTable.h"
#include "ultrasound/BenchPlots.h"
#include "ultrasound/BenchTables.h"

#include <insonate/core/AtomicFile.h>
#include <insonate/simulator/ImageFiles.h>

#include <nlohmann/json.hpp>
#include <unistd.h>

#include <cmath>

namespace insonate {
namespace fs = std::filesystem;
namespace {

using bench::fixed;

std::string csvLine(const std::vector<std::string>& cells) {
  std::string text = "|";
  for (const std::string& cell : cells) text += " " + cell + " |";
  return text + "\n";
}

std::string header(const std::vector<std::string>& cells) {
  return csvLine(cells) + csvLine(std::vector<std::string>(cells.size(), "---"));
}

std::string machineText(const UltrasoundBench& bench) {
  const BenchComputer& m = bench.machine;
  std::string text = m.processor + ", " + std::to_string(m.cores) + " cores, " + m.vectors + " vectors.\n\n" +
                     header({"threads", "multiply-add, GFLOP/s", "cache triad, GB/s", "memory triad, GB/s"});
  for (const BenchComputer::Limits& l : m.limits)
    text += csvLine(
        {std::to_string(l.threads), fixed(l.multiplyAdd_GFLOPs, 1), fixed(l.cache_GBps, 1), fixed(l.memory_GBps, 1)});
  return text;
}

std::string rowsText(const UltrasoundBench& bench) {
  std::string text = header({"engine", "look", "threads", "scanlines", "samples", "planes", "gate mm", "median ms",
                             "p95 ms", "min ms", "CPU ms", "plain loop / this", "the same, CPU", "envelope error %",
                             "SSIM", "discretisation error %", "discretisation SSIM"});
  for (const UltrasoundBenchRow& r : bench.rows)
    text += csvLine({r.engine, r.look, std::to_string(r.threads), std::to_string(r.scanlines),
                     std::to_string(r.samples), std::to_string(r.elevationPlanes), fixed(r.gate_mm, 3),
                     fixed(r.times.median_ms, 2), fixed(r.times.p95_ms, 2), fixed(r.times.min_ms, 2),
                     fixed(r.times.cpu_ms, 2), fixed(bench.plainLoop.median_ms / r.times.median_ms, 2),
                     fixed(bench.plainLoop.cpu_ms / r.times.cpu_ms, 2), fixed(r.envelopeError_percent, 3),
                     fixed(r.ssim, 4), fixed(r.discretisationError_percent, 2), fixed(r.discretisationSsim, 4)});
  return text;
}

std::string stagesText(const UltrasoundBench& bench) {
  std::string text = header({"engine", "stage", "threads", "median ms", "least ms", "Gop/s", "GB/s",
                             "% of arithmetic peak", "% of cache bandwidth", "% of memory bandwidth"});
  for (const StageLimits& s : bench.stages) {
    const auto known = [&](double value) { return s.operations > 0 ? fixed(value, 1) : std::string(); };
    text += csvLine({s.engine, s.stage, std::to_string(s.threads), fixed(s.time.median_ms, 3), fixed(s.time.min_ms, 3),
                     known(s.giga_operationsPerSecond), known(s.gigabytesPerSecond), known(s.percentOfArithmetic),
                     known(s.percentOfCache), known(s.percentOfMemory)});
  }
  return text;
}

std::string realismText(const UltrasoundBench& bench) {
  std::string text = header({"case", "view", "measure", "patch", "value", "real pictures", "median", "in range"});
  int inRange = 0;
  for (const RealismRow& r : bench.realism) {
    inRange += r.inRange;
    text += csvLine({r.variant, r.view, r.measure, r.patch, fixed(r.value, 3),
                     fixed(r.low, 3) + " to " + fixed(r.high, 3), fixed(r.median, 3), r.inRange ? "yes" : "**no**"});
  }
  return std::to_string(inRange) + " of " + std::to_string(bench.realism.size()) +
         " measures lie in the range of 15 real pictures of the neck.\n\n" + text;
}

std::string penetrationText(const UltrasoundBench& bench) {
  std::string text =
      "Depth at which echoes are as strong as the noise (IEC 61391-2), in tissue whose attenuation the built-in TGC "
      "compensates, at each machine's own frequency. Expected: noise over attenuation; 60 cm MHz over the frequency "
      "for "
      "-44 dB (Szabo and Lewin 2013). Harmonic imaging receives the same frequency; its echoes are weaker.\n\n" +
      header({"machine", "probe", "MHz", "expected, mm", "penetration, mm", "harmonic, mm", "harmonic, loss dB"});
  for (const PenetrationRow& r : bench.penetration)
    text += csvLine({r.machine, r.probe, fixed(r.frequency_MHz, 1), fixed(r.expected_mm, 0), fixed(r.penetration_mm, 0),
                     fixed(r.harmonic_mm, 0), fixed(r.loss_dB, 1)});
  return text;
}

}  // namespace

namespace bench {

std::string indexPage(const UltrasoundBench& results) {
  std::string text = "# Ultrasound: speed against error\n\n" + machineText(results) +
                     "\n## Frames\n\nThe first row is workload W1. A plain scalar loop of it takes " +
                     fixed(results.plainLoop.median_ms, 1) + " ms (least " + fixed(results.plainLoop.min_ms, 1) +
                     ", processor " + fixed(results.plainLoop.cpu_ms, 1) + ").\n\n" + rowsText(results) + "\n";
  for (const auto& [name, svg] : plotsOf(results)) text += "![" + name + "](" + name + ")\n";
  text += "\n## Stages of W1\n\n" + stagesText(results) + "\n## Realism\n\n" + realismText(results) + "\n";
  for (const BenchImage& picture : results.pictures) text += "![" + picture.name + "](" + picture.name + ".png)\n";
  if (!results.penetration.empty()) text += "\n## Penetration\n\n" + penetrationText(results);
  text += "\n## Notes\n\n";
  for (const std::string& note : results.notes) text += "- " + note + "\n";
  return text;
}

}  // namespace bench

Result<void> checkBenchFolder(const fs::path& folder) {
  const fs::path target = folder.has_filename() ? folder : folder.parent_path();
  std::error_code error;
  if (fs::exists(target, error)) {
    if (!fs::is_directory(target, error))
      return fail("Could not write to " + target.string() + ": it is a file; a folder is needed.");
    if (::access(target.c_str(), W_OK | X_OK) != 0)
      return fail("Could not write to " + target.string() + ": the folder cannot be written; choose another.");
  }
  const fs::path parent = target.has_parent_path() ? target.parent_path() : fs::path(".");
  if (!fs::is_directory(parent, error))
    return fail("Could not write to " + target.string() + ": the folder " + parent.string() +
                " does not exist; create it first.");
  if (::access(parent.c_str(), W_OK | X_OK) != 0)
    return fail("Could not write to " + target.string() + ": the folder " + parent.string() +
                " cannot be written; choose another.");
  return {};
}

Result<void> writeUltrasoundBench(const UltrasoundBench& results, const fs::path& folder) {
  if (auto ok = checkBenchFolder(folder); !ok) return ok;
  std::map<std::string, std::string> files = bench::plotsOf(results);
  files["ultrasound.json"] = toJson(results).dump(2) + "\n";
  files["ultrasound.csv"] = bench::rowsCsv(results);
  files["stages.csv"] = bench::stagesCsv(results);
  files["realism.csv"] = bench::realismCsv(results);
  files["penetration.csv"] = bench::penetrationCsv(results);
  files["index.md"] = bench::indexPage(results);
  return writeFolderAtomically(folder, [&](const fs::path& beside) -> Result<void> {
    for (const auto& [name, text] : files)
      if (auto ok = writeAtomically(beside / name, text); !ok) return ok;
    for (const BenchImage& picture : results.pictures)
      if (auto ok = writePng(picture.image, beside / (picture.name + ".png")); !ok) return ok;
    return {};
  });
}

}  // namespace insonate
