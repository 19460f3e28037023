#include "Commands.h"

#include <insonate/cases/Phantom.h>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>

namespace insonate::cli {
namespace {

struct PhantomArguments {
  std::string folder;
  std::string variant{phantomVariants().front().name};
  std::uint32_t seed = 1;
  bool contrast = false, list = false, json = false;
};

void listVariants(bool json) {
  nlohmann::json rows = nlohmann::json::array();
  for (const PhantomVariant& v : phantomVariants()) {
    rows.push_back(
        {{"name", v.name}, {"title", v.title}, {"difficulty", v.difficulty}, {"description", v.description}});
    if (!json)
      std::printf("%-20s %-9s %s\n", std::string(v.name).c_str(), std::string(v.difficulty).c_str(),
                  std::string(v.description).c_str());
  }
  if (json) printJson({{"variants", rows}});
}

Result<void> makeCase(const PhantomArguments& a) {
  auto patient =
      makePhantom(a.variant, a.seed, terminalProgress(), a.contrast ? CtContrast::kArterial : CtContrast::kNative);
  if (!patient) return tl::unexpected(patient.error());
  if (auto written = writeCase(*patient, a.folder); !written) return written;
  if (a.json) printJson({{"case", a.folder}, {"title", patient->manifest.title}, {"source", patient->manifest.source}});
  return {};
}

}  // namespace

void addPhantomCommand(CLI::App& app, Outcome& outcome) {
  auto* command = app.add_subcommand("phantom", "Make a case from the built-in neck");
  auto a = std::make_shared<PhantomArguments>();
  auto* folder = command->add_option("CASE", a->folder, "Folder to write the case to");
  command->add_option("--variant", a->variant, "Which neck; see --list")->capture_default_str();
  command->add_option("--seed", a->seed, "Another neck of the same kind")->capture_default_str();
  command->add_flag("--contrast", a->contrast, "Iodine in the vessels of the CT");
  auto* list = command->add_flag("--list", a->list, "List the variants and stop");
  command->add_flag("--json", a->json, "Print one JSON object");
  command->callback([a, folder, list, &outcome] {
    if (*list) return listVariants(a->json);
    if (!*folder) throw CLI::RequiredError("CASE");
    if (auto made = makeCase(*a); !made) refuse(outcome, made.error());
  });
}

}  // namespace insonate::cli
