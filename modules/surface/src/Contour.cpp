#include "Contour.h"

#include "VtkRun.h"

#include <vtkCellArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <limits>
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
  // A left-handed grid is mirrored in patient space, and so is the orientation of its triangles.
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

}  // namespace

Result<Mesh> contour(Volume<std::uint8_t>& share, const Progress& progress, std::string_view doing, double from,
                     double to) {
  vtkNew<vtkUnsignedCharArray> values;
  values->SetArray(share.voxels.data(), static_cast<vtkIdType>(share.voxels.size()), 1);  // 1: VTK does not free the
                                                                                          // array
  vtkNew<vtkImageData> image;  // in index space, since VTK's directions exclude mirrored grids
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

}  // namespace insonate
