#include "Commands.h"

#include <insonate/cases/CropCase.h>

#include <nlohmann/json.hpp>

#include <iostream>
#include <memory>
#include <vector>

namespace insonate::cli {
namespace {

using nlohmann::json;

struct CropArguments {
  std::string caseFolder, folder;
  std::vector<double> from_mm, to_mm, spacing_mm;
  bool replace = false, json = false;
};

CropOptions optionsOf(const CropArguments& a, const VolumeGeometry& geometry) {
  CropOptions options{boxOf(geometry), {}};
  if (!a.from_mm.empty())
    options.box =
        boxBetween(geometry, {a.from_mm[0], a.from_mm[1], a.from_mm[2]}, {a.to_mm[0], a.to_mm[1], a.to_mm[2]});
  const auto& s = a.spacing_mm;
  if (!s.empty()) options.spacing_mm = s.size() == 3 ? Vec3{s[0], s[1], s[2]} : Vec3{s[0], s[0], s[0]};
  return options;
}

Result<void> crop(const CropArguments& a) {
  if (auto ok = checkCaseTarget(a.folder, a.replace); !ok) return ok;
  auto read = readCase(a.caseFolder);
  if (!read) return tl::unexpected(read.error());
  for (const std::string& note : read->notes) std::cerr << "note: " << note << '\n';
  const auto part = cropCase(read->patient, optionsOf(a, read->patient.ct.geometry), terminalProgress());
  if (!part) return tl::unexpected(part.error());
  const auto& notes = part->manifest.importNotes;
  for (std::size_t n = read->patient.manifest.importNotes.size(); n < notes.size(); ++n)
    std::cerr << "note: " << notes[n] << '\n';
  if (auto ok = writeOrReplace(*part, a.folder); !ok) return ok;
  printNextSteps(a.folder);
  const VolumeGeometry& g = part->ct.geometry;
  if (a.json)
    printJson({{"case", a.folder},
               {"size", g.size},
               {"spacing_mm", jsonArray(g.spacing_mm)},
               {"origin_mm", jsonArray(g.origin_mm)}});
  return {};
}

}  // namespace

void addCropCommand(CLI::App& app, Outcome& outcome) {
  auto* command = app.add_subcommand(
      "crop", "Make a smaller case from a part of a case, CT and labels together; optionally resample it");
  auto a = std::make_shared<CropArguments>();
  command->add_option("CASE", a->caseFolder, "Folder of the case")->required()->check(notEmpty());
  command->add_option("OUT", a->folder, "Folder for the new case")->required()->check(notEmpty());
  auto* from =
      command->add_option("--from", a->from_mm, "One corner of the part to keep (patient LPS, mm): x y z")->expected(3);
  auto* to = command->add_option("--to", a->to_mm, "Opposite corner of the part to keep (patient LPS, mm): x y z")
                 ->expected(3);
  from->needs(to);
  to->needs(from);
  auto* spacing = command
                      ->add_option("--spacing", a->spacing_mm,
                                   "New voxel spacing in mm: one number, or three for the axes of the grid")
                      ->expected(1, 3);
  command->add_flag("--replace", a->replace, "Replace the case in OUT, which is kept as an earlier version");
  command->add_flag("--json", a->json, "Print one JSON object");
  command->callback([a, from, spacing, &outcome] {
    outcome.json = a->json;
    if (!*from && !*spacing) throw CLI::RequiredError("--from and --to, or --spacing");
    if (a->spacing_mm.size() == 2) throw CLI::ValidationError("--spacing", "needs one number, or three");
    if (auto done = crop(*a); !done) refuse(outcome, done.error());
  });
}

}  // namespace insonate::cli
