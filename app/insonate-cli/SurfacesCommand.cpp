#include "Commands.h"

#include <insonate/cases/PatientCase.h>
#include <insonate/surface/SurfaceFiles.h>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>

namespace insonate::cli {
namespace {

namespace fs = std::filesystem;

struct SurfacesArguments {
  std::string caseFolder, folder;
  std::string format = "stl";
  SurfaceOptions options;
  bool json = false;
};

void print(const std::vector<SurfaceFile>& surfaces, const SurfacesArguments& a) {
  nlohmann::json rows = nlohmann::json::array();
  for (const SurfaceFile& s : surfaces) {
    const std::string file = (fs::path(a.folder) / s.fileName).string();
    if (!a.json) std::printf("%8zu triangles  %9.1f ml  %s\n", s.triangles, s.volume_mm3 / 1000, file.c_str());
    rows.push_back({{"label", s.label},
                    {"name", s.name},
                    {"file", file},
                    {"triangles", s.triangles},
                    {"area_mm2", s.area_mm2},
                    {"volume_mm3", s.volume_mm3}});
  }
  if (a.json) printJson({{"surfaces", rows}});
}

Result<void> makeSurfaces(const SurfacesArguments& a) {
  if (auto ok = checkSurfaceTarget(a.folder); !ok) return ok;
  const auto read = readCase(a.caseFolder);
  if (!read) return tl::unexpected(read.error());
  for (const std::string& note : read->notes) std::cerr << "note: " << note << '\n';
  const auto surfaces = writeSurfaces(read->patient.labels, a.folder, a.format, a.options, terminalProgress());
  if (!surfaces) return tl::unexpected(surfaces.error());
  print(*surfaces, a);
  return {};
}

}  // namespace

void addSurfacesCommand(CLI::App& app, Outcome& outcome) {
  auto* command =
      app.add_subcommand("surfaces", "Write each structure of a case as a mesh in patient coordinates (LPS, mm)");
  auto a = std::make_shared<SurfacesArguments>();
  command->add_option("CASE", a->caseFolder, "Folder of the case")->required()->check(notEmpty());
  command->add_option("DIR", a->folder, "New or empty folder for the meshes, one file for each structure")
      ->required()
      ->check(notEmpty());
  command->add_option("--format", a->format, "Format: stl, ply, obj or vtp")
      ->check(CLI::IsMember({"stl", "ply", "obj", "vtp"}))
      ->capture_default_str();
  command
      ->add_option("--smoothing", a->options.smoothing_mm,
                   "Smooth the surface: remove waves shorter than this (mm); 0 for no smoothing")
      ->capture_default_str();
  command->add_option("--detail", a->options.detail_mm, "Size of the smallest detail to keep (mm); 0 keeps every voxel")
      ->capture_default_str();
  command->add_flag("--json", a->json, "Print one JSON object");
  command->callback([a, &outcome] {
    outcome.json = a->json;
    if (auto done = makeSurfaces(*a); !done) refuse(outcome, done.error());
  });
}

}  // namespace insonate::cli
