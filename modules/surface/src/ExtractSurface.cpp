#include "Blocks.h"
#include "MeshParts.h"
#include "Smoothing.h"
#include "VtkRun.h"

#include <insonate/surface/ExtractSurface.h>
#include <insonate/tissue/Labels.h>

#include <vtkCellArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <new>
#include <string>
#include <utility>

namespace insonate {
namespace {

Result<Mesh> toPatient(vtkPolyData& surface, const VolumeGeometry& grid) {
  const vtkIdType points = surface.GetNumberOfPoints(), triangles = surface.GetNumberOfPolys();
  if (points > std::numeric_limits<std::uint32_t>::max())
    return fail("The surface has too many points; ask for less detail (a larger detail_mm).");
  Mesh mesh;
  mesh.points_mm.reserve(3 * points);
  const Transform patientFromIndex = grid.patientFromIndex();
  for (vtkIdType p = 0; p < points; ++p) {
    Vec3 index;
    surface.GetPoints()->GetPoint(p, &index.x);
    const Vec3 patient = patientFromIndex * index;
    for (int a = 0; a < 3; ++a) mesh.points_mm.push_back(static_cast<float>(patient[a]));
  }
  mesh.triangles.reserve(3 * triangles);
  // A left-handed grid is mirrored on its way to patient space, and its triangles with it.
  const bool mirrored = determinant(grid.direction) < 0;
  for (vtkIdType t = 0; t < triangles; ++t) {
    const vtkIdType* corner = nullptr;
    vtkIdType count = 0;
    surface.GetPolys()->GetCellAtId(t, count, corner);
    for (const int c : {0, mirrored ? 2 : 1, mirrored ? 1 : 2})
      mesh.triangles.push_back(static_cast<std::uint32_t>(corner[c]));
  }
  return mesh;
}

/// The surface where shares pass one half, in patient LPS, facing out of the larger shares; without normals. Closed
/// when the outermost shares are 0.
Result<Mesh> contour(Volume<std::uint8_t>& share, const Progress& progress, std::string_view doing, double from,
                     double to) {
  vtkNew<vtkUnsignedCharArray> values;
  values->SetArray(share.voxels.data(), static_cast<vtkIdType>(share.voxels.size()), 1);  // 1: not VTK's to free
  vtkNew<vtkImageData> image;  // in index space; VTK's own directions know no mirrored grids
  image->SetDimensions(share.geometry.size.data());
  image->GetPointData()->SetScalars(values);

  vtkNew<vtkFlyingEdges3D> filter;
  filter->SetInputData(image);
  filter->SetValue(0, 127.5);  // between two shares, so that no point falls on a block's center
  filter->ComputeNormalsOff();
  filter->ComputeGradientsOff();
  filter->ComputeScalarsOff();
  if (auto ok = runFilter(*filter, progress, doing, from, to); !ok) return tl::unexpected(ok.error());
  return toPatient(*filter->GetOutput(), share.geometry);
}

constexpr double kLargest_mm = 100;
/// Waves shorter than this multiple of the grid's coarsest spacing are voxel steps.
constexpr double kStairs = 6;
/// Maximum relative change of the volume by blocks.
constexpr double kVolumeChange = 0.1;

std::string nameOf(std::uint8_t label) {
  const std::string number = "label " + std::to_string(label);
  return label < kLabelCount ? std::string(labelTable()[label].name) + " (" + number + ")" : number;
}

Result<void> checkInput(const LabelMap& labels, const SurfaceOptions& options) {
  if (auto ok = validate(labels.geometry); !ok) return ok;
  if (labels.voxels.size() != labels.geometry.voxelCount())
    return fail("The label map has " + std::to_string(labels.voxels.size()) + " voxels where its grid has " +
                std::to_string(labels.geometry.voxelCount()) + ".");
  for (const auto& [name, value] : {std::pair{"smoothing_mm", options.smoothing_mm}, {"detail_mm", options.detail_mm}})
    if (!(value >= 0 && value <= kLargest_mm))
      return fail(std::string(name) + " is " + std::to_string(value) + "; it must be from 0 to 100 mm.");
  return {};
}

/// An unsmoothed surface and its grid.
struct Extracted {
  Mesh mesh;
  VolumeGeometry grid;
};

double volumeOf_mm3(const VolumeGeometry& grid, const LabelBox& box) {
  return double(box.voxels) * grid.spacing_mm.x * grid.spacing_mm.y * grid.spacing_mm.z;
}

/// Uses blocks of the requested size, or smaller ones if the structure has thin parts.
Result<Extracted> extract(const LabelMap& labels, const LabelSet& structure, const LabelBox& box, double detail_mm,
                          const Progress& progress, std::string_view doing) {
  const double labeled_mm3 = volumeOf_mm3(labels.geometry, box);
  for (;; detail_mm /= 2) {
    const auto size = blockSize(labels.geometry, detail_mm);
    auto share = structureShare(labels, structure, box, size);
    auto mesh = contour(share, progress, doing, 0.1, 0.4);
    if (!mesh) return tl::unexpected(mesh.error());
    const bool wholeVoxels = size == std::array{1, 1, 1};
    if (wholeVoxels || std::abs(volume_mm3(*mesh) - labeled_mm3) <= kVolumeChange * labeled_mm3)
      return Extracted{std::move(*mesh), share.geometry};
  }
}

Result<void> smooth(Extracted& extracted, double smoothing_mm, double labeled_mm3, const Progress& progress,
                    std::string_view doing) {
  const Vec3 spacing_mm = extracted.grid.spacing_mm;
  const auto [least, most] = std::minmax({spacing_mm.x, spacing_mm.y, spacing_mm.z});
  const double wavelength_mm = std::max(smoothing_mm, kStairs * most);
  auto ok = smoothMesh(extracted.mesh, wavelength_mm, extracted.grid.indexFromPatient(), progress, doing, 0.4, 0.9);
  if (ok) restoreVolume(extracted.mesh, labeled_mm3, least / 4);
  return ok;
}

/// `name` is the structure's name in error sentences.
Result<Mesh> surfaceOf(const LabelMap& labels, const LabelSet& structure, const std::string& name,
                       const SurfaceOptions& options, const Progress& progress) try {
  if (auto ok = checkInput(labels, options); !ok) return tl::unexpected(ok.error());
  const std::string doing = "Surface of " + name;
  if (!report(progress, doing, 0)) return fail(std::string(kCancelled));
  const auto box = boxOf(labels, structure);
  if (!report(progress, doing, 0.05)) return fail(std::string(kCancelled));
  if (!box) return fail("No voxel is labeled " + name + ", so it has no surface.");
  auto extracted = extract(labels, structure, *box, options.detail_mm, progress, doing);
  if (!extracted) return tl::unexpected(extracted.error());
  if (options.smoothing_mm > 0)
    if (auto ok = smooth(*extracted, options.smoothing_mm, volumeOf_mm3(labels.geometry, *box), progress, doing); !ok)
      return tl::unexpected(ok.error());
  extracted->mesh.normals = pointNormals(extracted->mesh);
  if (!report(progress, doing, 1)) return fail(std::string(kCancelled));
  return std::move(extracted->mesh);
} catch (const std::bad_alloc&) {
  return fail("There is too little memory for the surface of " + name + "; ask for less detail (a larger detail_mm).");
} catch (const std::exception& e) {
  return fail("The surface of " + name + " could not be computed: " + e.what());
}

}  // namespace

std::vector<std::uint8_t> structuresIn(const LabelMap& labels) {
  std::array<bool, 256> present{};
  for (const std::uint8_t label : labels.voxels) present[label] = true;
  std::vector<std::uint8_t> result;
  for (int label = 1; label < 256; ++label)
    if (present[label]) result.push_back(static_cast<std::uint8_t>(label));
  return result;
}

Result<Mesh> extractSurface(const LabelMap& labels, std::uint8_t label, const SurfaceOptions& options,
                            const Progress& progress) {
  if (label == kBackground) return fail("Label 0 is the background and has no surface; name a structure.");
  LabelSet structure{};
  structure[label] = true;
  return surfaceOf(labels, structure, nameOf(label), options, progress);
}

Result<Mesh> extractBody(const LabelMap& labels, const SurfaceOptions& options, const Progress& progress) {
  LabelSet structure;
  structure.fill(true);
  structure[kBackground] = false;
  return surfaceOf(labels, structure, "the body (any label)", options, progress);
}

}  // namespace insonate
