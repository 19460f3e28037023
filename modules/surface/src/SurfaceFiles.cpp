#include <insonate/core/AtomicFile.h>
#include <insonate/surface/MeshFile.h>
#include <insonate/surface/SurfaceFiles.h>
#include <insonate/tissue/Labels.h>

namespace insonate {
namespace fs = std::filesystem;
namespace {

std::string fileNameOf(std::string name, const std::string& format) {
  for (char& c : name)
    if (c == ' ') c = '-';
  return name + "." + format;
}

/// Share of one of `count` structures in the progress.
Progress partOf(const Progress& whole, std::size_t number, std::size_t count) {
  return [=](std::string_view doing, double fraction) {
    return report(whole, doing, (double(number) + fraction) / double(count));
  };
}

}  // namespace

Result<void> checkSurfaceTarget(const fs::path& folder) {
  if (auto ok = checkFolderTarget(folder); !ok) return ok;
  std::error_code error;
  if (fs::exists(folder, error) && (!fs::is_empty(folder, error) || error))
    return fail("The folder " + folder.string() +
                " is not empty, and surfaces of two cases must not mix. Name another folder.");
  return {};
}

Result<std::vector<SurfaceFile>> writeSurfaces(const LabelMap& labels, const fs::path& folder,
                                               const std::string& format, const SurfaceOptions& options,
                                               const Progress& progress) {
  if (auto ok = checkSurfaceTarget(folder); !ok) return tl::unexpected(ok.error());
  const auto structures = structuresIn(labels);
  if (structures.empty())
    return fail("Nothing is labeled, so there is no surface to write to " + folder.string() + ".");
  std::vector<SurfaceFile> surfaces;
  const auto written = writeFolderAtomically(folder, [&](const fs::path& beside) -> Result<void> {
    for (const std::uint8_t label : structures) {
      const auto mesh = extractSurface(labels, label, options, partOf(progress, surfaces.size(), structures.size()));
      if (!mesh) return tl::unexpected(mesh.error());
      const std::string fileName = fileNameOf(labelName(label), format);
      if (auto ok = writeMesh(beside / fileName, *mesh); !ok) return ok;
      surfaces.push_back(
          {label, labelName(label), fileName, mesh->triangleCount(), area_mm2(*mesh), volume_mm3(*mesh)});
    }
    return {};
  });
  if (!written) return tl::unexpected(written.error());
  return surfaces;
}

}  // namespace insonate
