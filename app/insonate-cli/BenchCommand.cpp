#include "Commands.h"

#include <insonate/simulator/UltrasoundBench.h>

#include <nlohmann/json.hpp>

#include <iostream>
#include <memory>

namespace insonate::cli {
namespace {

struct BenchOptions {
  std::string folder;
  bool quick = false, json = false;
};

Result<void> benchUltrasound(const BenchOptions& options) {
  if (auto ok = checkBenchFolder(options.folder); !ok) return ok;
  const auto plan = ultrasoundBenchPlan(options.quick, terminalProgress());
  if (!plan) return tl::unexpected(plan.error());
  const auto results = runUltrasoundBench(*plan, terminalProgress());
  if (!results) return tl::unexpected(results.error());
  if (auto ok = writeUltrasoundBench(*results, options.folder); !ok) return ok;
  if (options.json)
    printJson(toJson(*results));
  else
    std::cout << (std::filesystem::path(options.folder) / "index.md").string() << '\n';
  return {};
}

}  // namespace

void addBenchCommand(CLI::App& app, Outcome& outcome) {
  CLI::App* bench = app.add_subcommand("bench", "Tables and plots of speed against error");
  bench->require_subcommand(1);
  auto options = std::make_shared<BenchOptions>();
  CLI::App* command = bench->add_subcommand("ultrasound", "Frame times and errors of the ultrasound engines, realism");
  command->add_option("--out", options->folder, "Folder for tables and plots; created when missing")->required();
  command->add_flag("--quick", options->quick, "Fewer settings and pictures");
  command->add_flag("--json", options->json, "Print the tables as one JSON object");
  command->callback([options, &outcome] {
    outcome.json = options->json;
    if (auto ok = benchUltrasound(*options); !ok) refuse(outcome, ok.error());
  });
}

}  // namespace insonate::cli
