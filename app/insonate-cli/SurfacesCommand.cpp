#include "Commands.h"

#include <insonate/cases/PatientCase.h>
#include <insonate/core/AtomicFile.h>
#include <insonate/surface/ExtractSurface.h>
#include <insonate/surface/MeshFile.h>
#include <insonate/tissue/Labels.h>

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

struct WrittenSurface {
  std::uint8_t label;
  std::string name, fileName;
  std::size_t triangles;
  double area_mm2, volume_mm3;
};

Result<void> checkTarget(const fs::path& folder) {
  if (auto ok = checkFolderTarget(folder); !ok) return ok;
  std::error_code error;
  if (fs::exists(folder, error) && (!fs::is_empty(folder, error) || error))
    return fail("The folder " + folder.string() + " is not empty; surfaces of two cases would mix. Name another one.");
  return {};
}

std::string fileNameOf(std::string name, const std::string& format) {
  for (char& c : name)
    if (c == ' ') c = '-';
  return name + "." + format;
}

/// The part that one of `count` structures has in the whole.
Progress partOf(const Progress& whole, std::size_t number, std::size_t count) {
  return [=](std::string_view doing, double fraction) {
    return report(whole, doing, (double(number) + fraction) / double(count));
  };
}

Result<std::vector<WrittenSurface>> writeSurfaces(const LabelMap& labels, const SurfacesArguments& a) {
  const auto structures = structuresIn(labels);
  if (structures.empty()) return fail("Nothing is labelled in " + a.caseFolder + ", so there is no surface.");
  std::vector<WrittenSurface> surfaces;
  const auto written = writeFolderAtomically(a.folder, [&](const fs::path& beside) -> Result<void> {
    for (const std::uint8_t label : structures) {
      const Progress progress = partOf(terminalProgress(), surfaces.size(), structures.size());
      const auto mesh = extractSurface(labels, label, a.options, progress);
      if (!mesh) return tl::unexpected(mesh.error());
      const std::string fileName = fileNameOf(labelName(label), a.format);
      if (auto ok = writeMesh(beside / fileName, *mesh); !ok) return ok;
      surfaces.push_back(
          {label, labelName(label), fileName, mesh->triangleCount(), area_mm2(*mesh), volume_mm3(*mesh)});
    }
    return {};
  });
  if (!written) return tl::unexpected(written.error());
  return surfaces;
}

void print(const std::vector<WrittenSurface>& surfaces, const SurfacesArguments& a) {
  nlohmann::json rows = nlohmann::json::array();
  for (const WrittenSurface& s : surfaces) {
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
  if (auto ok = checkTarget(a.folder); !ok) return ok;
  const auto read = readCase(a.caseFolder);
  if (!read) return tl::unexpected(read.error());
  for (const std::string& note : read->notes) std::cerr << "note: " << note << '\n';
  const auto surfaces = writeSurfaces(read->patient.labels, a);
  if (!surfaces) return tl::unexpected(surfaces.error());
  print(*surfaces, a);
  return {};
}

}  // namespace

void addSurfacesCommand(CLI::App& app, Outcome& outcome) {
  auto* command = app.add_subcommand("surfaces", "Each structure of a case as a mesh, in patient LPS millimetres");
  auto a = std::make_shared<SurfacesArguments>();
  command->add_option("CASE", a->caseFolder, "Folder of the case")->required()->check(notEmpty());
  command->add_option("DIR", a->folder, "New or empty folder, for one file a structure")->required()->check(notEmpty());
  command->add_option("--format", a->format, "stl, ply or obj")
      ->check(CLI::IsMember({"stl", "ply", "obj"}))
      ->capture_default_str();
  command->add_option("--smoothing", a->options.smoothing_mm, "Smooth away waves shorter than this (mm); 0 for none")
      ->capture_default_str();
  command->add_option("--detail", a->options.detail_mm, "Size of what is kept (mm); 0 for every voxel")
      ->capture_default_str();
  command->add_flag("--json", a->json, "Print one JSON object");
  command->callback([a, &outcome] {
    outcome.json = a->json;
    if (auto done = makeSurfaces(*a); !done) refuse(outcome, done.error());
  });
}

}  // namespace insonate::cli
