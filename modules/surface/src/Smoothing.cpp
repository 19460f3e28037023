#include "Smoothing.h"

#include "MeshParts.h"
#include "VtkRun.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeInt64Array.h>
#include <vtkWindowedSincPolyDataFilter.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace insonate {
namespace {

constexpr int kFewestPasses = 10, kMaxPasses = 40;
/// A part that would keep less of its volume is smoothed less.
constexpr double kVolumeKept = 0.8;

double meanEdge_mm(const Mesh& mesh) {
  double sum = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3)
    for (int c = 0; c < 3; ++c)
      sum += norm(pointOf(mesh.points_mm, mesh.triangles[t + c]) -
                  pointOf(mesh.points_mm, mesh.triangles[t + (c + 1) % 3]));
  return sum / double(mesh.triangles.size());
}

/// Limit of the pass band, as an eigenvalue of the mesh's umbrella operator: on a mesh of equal triangles of edge h, a
/// wave of length w has (pi h / w)^2.
double passBandFor(double wavelength_mm, double edge_mm) {
  const double wave = std::numbers::pi * edge_mm / wavelength_mm;
  return std::min(wave * wave, 2.0);
}

/// The filter is a polynomial in cos(theta) = 1 - k/2 under a Hamming window, whose edge is 10.4 / passes wide (full
/// width, in theta); the edge must not be wider than the pass band.
int passesFor(double passBand) {
  const double theta = std::acos(1 - passBand / 2);
  return std::clamp(static_cast<int>(std::ceil(10.4 / theta)), kFewestPasses, kMaxPasses);
}

vtkNew<vtkPolyData> toVtk(const Mesh& mesh) {
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(static_cast<vtkIdType>(mesh.pointCount()));
  std::ranges::copy(mesh.points_mm, coordinates->GetPointer(0));
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  vtkNew<vtkTypeInt64Array> corners;
  corners->SetNumberOfValues(static_cast<vtkIdType>(mesh.triangles.size()));
  std::ranges::copy(mesh.triangles, corners->GetPointer(0));
  vtkNew<vtkCellArray> cells;
  cells->SetData(3, corners);
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(points);
  surface->SetPolys(cells);
  return surface;
}

/// Moves each point from its place, by half an index at most.
void holdNear(const std::vector<float>& before_mm, std::vector<float>& after_mm, const Mat3& indexFromPatient) {
  const Mat3 patientFromIndex = inverted(indexFromPatient);
  for (std::size_t p = 0; p < before_mm.size() / 3; ++p) {
    const Vec3 start = pointOf(before_mm, p);
    Vec3 step = indexFromPatient * (pointOf(after_mm, p) - start);
    for (int a = 0; a < 3; ++a) step[a] = std::isfinite(step[a]) ? std::clamp(step[a], -0.5, 0.5) : 0;
    const Vec3 end = start + patientFromIndex * step;
    for (int a = 0; a < 3; ++a) after_mm[3 * p + a] = static_cast<float>(end[a]);
  }
}

}  // namespace

Result<void> smoothMesh(Mesh& mesh, double wavelength_mm, const Transform& indexFromPatient, const Progress& progress,
                        std::string_view doing, double from, double to) {
  const double passBand = passBandFor(wavelength_mm, meanEdge_mm(mesh));
  const vtkNew<vtkPolyData> surface = toVtk(mesh);
  vtkNew<vtkWindowedSincPolyDataFilter> filter;
  filter->SetInputData(surface);
  filter->SetPassBand(passBand);
  filter->SetNumberOfIterations(passesFor(passBand));
  filter->NormalizeCoordinatesOn();
  filter->BoundarySmoothingOff();
  filter->FeatureEdgeSmoothingOff();
  filter->NonManifoldSmoothingOn();
  const double filtered = from + 0.8 * (to - from);
  if (auto ok = runFilter(*filter, progress, doing, from, filtered); !ok) return ok;

  std::vector<float> smoothed(mesh.points_mm.size());
  vtkPoints& points = *filter->GetOutput()->GetPoints();
  for (std::size_t p = 0; p < mesh.pointCount(); ++p) {
    Vec3 patient;
    points.GetPoint(static_cast<vtkIdType>(p), &patient.x);
    for (int a = 0; a < 3; ++a) smoothed[3 * p + a] = static_cast<float>(patient[a]);
  }
  holdNear(mesh.points_mm, smoothed, indexFromPatient.linear);
  if (!report(progress, doing, (filtered + to) / 2)) return fail(std::string(kCancelled));
  keepSmallParts(mesh, smoothed, kVolumeKept);
  mesh.points_mm = std::move(smoothed);
  if (!report(progress, doing, to)) return fail(std::string(kCancelled));
  return {};
}

}  // namespace insonate
