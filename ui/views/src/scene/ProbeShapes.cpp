#include "ProbeShapes.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyDataNormals.h>

#include <cmath>
#include <initializer_list>
#include <numbers>
#include <vector>

namespace insonate::views {
namespace {

/// A cross-section of the housing: |x/a|^n + |y/b|^n = 1 at height z. `bulge` is the share of the face's curvature that
/// it follows.
struct Section {
  double z, a, b, n = 4, bulge = 0;
};

constexpr int kSides = 64;

class Loft {
 public:
  explicit Loft(double faceRadius_mm) : radius_(faceRadius_mm) {}

  void add(const Section& section) {
    const vtkIdType first = points_->GetNumberOfPoints();
    for (int k = 0; k < kSides; ++k) {
      const double turn = 2 * std::numbers::pi * k / kSides;
      insert(section, power(std::cos(turn), section.n), power(std::sin(turn), section.n));
    }
    if (rings_++ == 0) return;
    for (int k = 0; k < kSides; ++k) {
      const int next = (k + 1) % kSides;
      const vtkIdType quad[4] = {first + k, first + next, first + next - kSides, first + k - kSides};
      cells_->InsertNextCell(4, quad);
    }
  }

  /// Closes the last ring; a curved face needs more rings inside.
  void cap(const Section& last) {
    for (const double share : {0.75, 0.5, 0.25, 0.02})
      add({last.z, last.a * share, last.b * share, last.n, last.bulge});
  }

  vtkSmartPointer<vtkPolyData> smooth() {
    vtkNew<vtkPolyData> data;
    data->SetPoints(points_);
    data->SetPolys(cells_);
    vtkNew<vtkPolyDataNormals> normals;
    normals->SetInputData(data);
    normals->SetFeatureAngle(60);
    normals->ConsistencyOn();
    normals->AutoOrientNormalsOn();
    normals->Update();
    return normals->GetOutput();
  }

 private:
  static double power(double value, double n) { return std::copysign(std::pow(std::abs(value), 2 / n), value); }

  void insert(const Section& s, double u, double v) {
    const double x = s.a * u;
    // Arc through the middle of the face, which recedes toward its ends.
    const double arc = radius_ > 0 ? std::sqrt(std::max(0.0, radius_ * radius_ - x * x)) - radius_ : 0;
    points_->InsertNextPoint(x, s.b * v, s.z + s.bulge * arc);
  }

  double radius_;
  int rings_ = 0;
  vtkNew<vtkPoints> points_;
  vtkNew<vtkCellArray> cells_;
};

vtkSmartPointer<vtkPolyData> loft(double faceRadius_mm, std::initializer_list<Section> sections) {
  Loft shape(faceRadius_mm);
  for (const Section& section : sections) shape.add(section);
  shape.cap(*(sections.end() - 1));
  return shape.smooth();
}

}  // namespace

ProbeParts probeParts(const Probe& probe) {
  const bool linear = probe.shape == ProbeShape::Linear;
  const double halfAngle = 0.5 * probe.fovAngle_deg * std::numbers::pi / 180;
  // Sector probes have a small, flat array.
  const bool phased = probe.shape == ProbeShape::Phased;
  const double radius_mm = linear || phased ? 0 : probe.faceRadius_mm;
  const double margin = probe.faceMargin_mm;
  const double half = linear   ? probe.width_mm / 2 + margin
                      : phased ? 10 + margin
                               : probe.faceRadius_mm * std::sin(halfAngle + margin / probe.faceRadius_mm);
  const double thick = phased ? 6.5 : linear ? 4.5 : 7;
  const double head = half + 3, deep = thick + 3, grip = std::min(13.0, head * 0.85), round = 10.5;

  ProbeParts parts;
  parts.lens = loft(
      radius_mm, {{-3, half + 1, thick + 1, 6, 1}, {-0.8, half + 1, thick + 1, 6, 1}, {-0.1, half + 0.3, thick, 5, 1}});
  parts.body = loft(radius_mm, {{-150, 2.4, 2.4, 2},
                                {-132, 2.4, 2.4, 2},
                                {-131.5, 3.4, 3.4, 2},
                                {-108, 5, 5, 2},
                                {-106, 9, 8, 2.2},
                                {-98, grip, round, 2.5},
                                {-70, grip * 1.02, round * 1.05, 2.6},
                                {-48, grip * 0.96, round, 2.8},
                                {-34, 0.5 * (grip + head), 0.5 * (round + deep), 3.2},
                                {-22, 0.12 * grip + 0.88 * head, deep, 4, 0.3},
                                {-14, head, deep, 5, 0.7},
                                {-4, head, deep, 5, 1},
                                {-2.4, head - 0.9, deep - 0.9, 5, 1}});
  const double drop = radius_mm > 0 ? std::sqrt(std::max(0.0, radius_mm * radius_mm - half * half)) - radius_mm : 0;
  parts.marker = loft(0, {{-19 + drop * 0.5, 0.2, 0.2, 2},
                          {-18 + drop * 0.5, 1.1, 1.3, 2.5},
                          {-9 + drop * 0.5, 1.1, 1.3, 2.5},
                          {-8 + drop * 0.5, 0.2, 0.2, 2}});
  for (vtkIdType k = 0; k < parts.marker->GetNumberOfPoints(); ++k) {
    double* at = parts.marker->GetPoint(k);
    parts.marker->GetPoints()->SetPoint(k, at[0] + head - 0.2, at[1], at[2]);
  }
  return parts;
}

}  // namespace insonate::views
