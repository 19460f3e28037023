#include <insonate/flow/VesselAreas.h>

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

/// Distance beside the image plane over which a compressed vessel regains its area: about the length of the housing.
constexpr double kBeside_mm = 30;

/// The inner part of a vessel is measured, since a lumen in a CT is not exactly as round and wide as the vessel's
/// radius states, and the tissue around it is compressed less than blood.
constexpr double kInner_radii = 0.6;
/// Parts of a lattice cell along each axis, since a lumen that is nearly closed is thinner than a cell.
constexpr int kParts = 5;

std::size_t nearestPoint(const NamedVessel& vessel, Vec3 patient_mm) {
  std::size_t nearest = 0;
  double least = 1e30;
  for (std::size_t i = 0; i < vessel.course.size(); ++i) {
    const Vec3 way = patient_mm - vessel.course[i].position_mm;
    if (const double square = dot(way, way); square < least) least = square, nearest = i;
  }
  return nearest;
}

Vec3 restOf(const PlaneDisplacement& d, int column, int row) {
  const PlaneDisplacement::Shift& s = d.restFromDisplayed[std::size_t(row) * d.columns + column];
  return {d.left_mm + column * d.step_mm + s.x_mm, 0, d.top_mm + row * d.step_mm + s.z_mm};
}

/// A displayed cell of the lattice, with the positions at rest of its corners, probe frame.
struct RestCell {
  Vec3 a, b, c, d;  ///< top left, top right, bottom left, bottom right

  RestCell(const PlaneDisplacement& field, int column, int row)
      : a(restOf(field, column, row)),
        b(restOf(field, column + 1, row)),
        c(restOf(field, column, row + 1)),
        d(restOf(field, column + 1, row + 1)) {}
  double area_mm2() const {
    const Vec3 down = d - a, up = c - b;
    return 0.5 * std::abs(down.x * up.z - down.z * up.x);
  }
  double size_mm() const { return std::max(norm(d - a), norm(c - b)); }
  Vec3 at(double across, double down) const {
    const Vec3 top = a + across * (b - a), bottom = c + across * (d - c);
    return top + down * (bottom - top);
  }
};

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

/// Adds the parts of a cell that lie in the inner part of the vessel.
void addCell(const NamedVessel& vessel, const PlaneDisplacement& d, const RestCell& cell,
             const Transform& patientFromProbe, std::vector<Areas>& measured) {
  const Vec3 center = patientFromProbe * cell.at(0.5, 0.5);
  const std::size_t point = nearestPoint(vessel, center);
  const double inner_mm = kInner_radii * vessel.course[point].radius_mm;
  if (distanceToCenterLine_mm(vessel, center) > inner_mm + cell.size_mm()) return;
  int inside = 0;
  for (int down = 0; down < kParts; ++down)
    for (int across = 0; across < kParts; ++across) {
      const Vec3 part = patientFromProbe * cell.at((across + 0.5) / kParts, (down + 0.5) / kParts);
      inside += distanceToCenterLine_mm(vessel, part) < inner_mm;
    }
  const double share = double(inside) / (kParts * kParts);
  measured[point].displayed_mm2 += share * d.step_mm * d.step_mm;
  measured[point].rest_mm2 += share * cell.area_mm2();
}

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
      for (int column = cells.firstColumn; column < cells.endColumn; ++column)
        addCell(vessel, d, RestCell(d, column, row), patientFromProbe, measured);
    fillBeside(vessel, measured, areas[v]);
  }
}

}  // namespace insonate
