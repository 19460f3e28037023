#include <insonate/flow/VesselAreas.h>

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

/// Distance beside the image plane over which a compressed vessel regains its area: about the length of the housing.
constexpr double kBeside_mm = 30;

struct NearestPoint {
  std::size_t point = 0;
  bool inside = false;
};

NearestPoint nearestPoint(const NamedVessel& vessel, Vec3 patient_mm) {
  NearestPoint nearest;
  double least = 1e30;
  for (std::size_t i = 0; i < vessel.course.size(); ++i) {
    const Vec3 way = patient_mm - vessel.course[i].position_mm;
    if (const double square = dot(way, way); square < least) least = square, nearest.point = i;
  }
  nearest.inside = distanceToWall_mm(vessel, patient_mm) < 0;
  return nearest;
}

/// Area at rest of one displayed cell of the lattice, from its two diagonals.
double restArea_mm2(const PlaneDisplacement& d, int column, int row) {
  const auto at = [&](int c, int r) {
    const PlaneDisplacement::Shift& s = d.restFromDisplayed[std::size_t(r) * d.columns + c];
    return Vec3{c * d.step_mm + s.x_mm, 0, r * d.step_mm + s.z_mm};
  };
  const Vec3 a = at(column + 1, row + 1) - at(column, row), b = at(column, row + 1) - at(column + 1, row);
  return 0.5 * std::abs(a.x * b.z - a.z * b.x);
}

Vec3 restCenter(const PlaneDisplacement& d, int column, int row) {
  const double x = d.left_mm + (column + 0.5) * d.step_mm, z = d.top_mm + (row + 0.5) * d.step_mm;
  return Vec3{x, 0, z} + shiftAt(d, x, z);
}

/// Cells of the lattice that may show a vessel: `first` up to but without `end`; empty if the vessel is elsewhere.
struct Cells {
  int firstColumn = 0, endColumn = 0, firstRow = 0, endRow = 0;
};

/// `d` moves no tissue farther than the margin, else a part of the vessel is left out.
Cells cellsOf(const NamedVessel& vessel, const Transform& probeFromPatient, const PlaneDisplacement& d) {
  constexpr double kMargin_mm = 10;
  double left = 1e30, right = -1e30, top = 1e30, bottom = -1e30;
  for (const NamedVessel::Point& point : vessel.course) {
    const Vec3 p = probeFromPatient * point.position_mm;
    const double reach_mm = point.radius_mm + kMargin_mm;
    if (std::abs(p.y) > reach_mm) continue;
    left = std::min(left, p.x - reach_mm), right = std::max(right, p.x + reach_mm);
    top = std::min(top, p.z - reach_mm), bottom = std::max(bottom, p.z + reach_mm);
  }
  const auto cell = [&](double at_mm, double first_mm, int count) {
    return static_cast<int>(std::clamp((at_mm - first_mm) / d.step_mm, 0.0, count - 1.0));
  };
  return {cell(left, d.left_mm, d.columns), cell(right, d.left_mm, d.columns), cell(top, d.top_mm, d.rows),
          cell(bottom, d.top_mm, d.rows)};
}

struct Areas {
  double displayed_mm2 = 0, rest_mm2 = 0;
};

/// Sets the factors of the points that the plane does not show from those of the nearest points that it does.
void fillBeside(const NamedVessel& vessel, const std::vector<Areas>& measured, std::vector<double>& factors) {
  for (std::size_t i = 0; i < factors.size(); ++i) {
    double nearest_mm = kBeside_mm;
    for (std::size_t k = 0; k < factors.size(); ++k) {
      if (measured[k].rest_mm2 <= 0) continue;
      const double off_mm = norm(vessel.course[k].position_mm - vessel.course[i].position_mm);
      if (off_mm >= nearest_mm) continue;
      nearest_mm = off_mm;
      const double factor = measured[k].displayed_mm2 / measured[k].rest_mm2;
      factors[i] = factor + (1 - factor) * off_mm / kBeside_mm;
    }
  }
}

}  // namespace

void computeVesselAreas(std::span<const NamedVessel> vessels, const PlaneDisplacement& d,
                        const Transform& patientFromProbe, VesselAreas& areas) {
  areas.resize(vessels.size());
  const Transform probeFromPatient = inverted(patientFromProbe);
  thread_local std::vector<Areas> measured;
  for (std::size_t v = 0; v < vessels.size(); ++v) {
    const NamedVessel& vessel = vessels[v];
    areas[v].assign(vessel.course.size(), 1);
    if (d.empty()) continue;
    measured.assign(vessel.course.size(), {});
    const Cells cells = cellsOf(vessel, probeFromPatient, d);
    for (int row = cells.firstRow; row < cells.endRow; ++row)
      for (int column = cells.firstColumn; column < cells.endColumn; ++column) {
        const NearestPoint place = nearestPoint(vessel, patientFromProbe * restCenter(d, column, row));
        if (!place.inside) continue;
        measured[place.point].displayed_mm2 += d.step_mm * d.step_mm;
        measured[place.point].rest_mm2 += restArea_mm2(d, column, row);
      }
    fillBeside(vessel, measured, areas[v]);
  }
}

}  // namespace insonate
