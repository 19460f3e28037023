#include "ColumnGrid.h"
#include "LabelSprings.h"
#include "Models.h"

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

using column::ColumnGrid;
using column::ColumnLoad;
using column::LabelSprings;
using column::TissueColumn;

constexpr double kTouch_mm = 1e-6;  // a smaller indentation does not count as compression
constexpr double kNewtonPerkPamm2 = 1e-3;

double sane(double value, double low, double high, double otherwise) {
  return std::isfinite(value) ? std::clamp(value, low, high) : otherwise;
}

/// Resets the answer to no motion; keeps its memory.
void rest(Deformation& answer) {
  answer.displacement.columns = answer.displacement.rows = 0;
  answer.displacement.restFromDisplayed.clear();
  answer.mesh.clear();
  answer.pressure_kPa.clear();
  answer.lumens.clear();
  answer.meshColumns = answer.meshRows = answer.iterations = 0;
  answer.force_N = answer.faceShift_mm = 0;
  answer.moved = false;
  answer.converged = true;
}

class ColumnModel : public DeformationModel {
 public:
  ColumnModel(const MechanicalTable& tissues, const DeformationSettings& wanted) : springs(tissues), settings(wanted) {}

  std::string_view name() const override { return "column"; }
  void reset() override {}  // questions are independent of each other

  void solve(const DeformationInput& input, Deformation& answer) override {
    rest(answer);
    if (!input.plane) return;
    grid.layOut(sane(input.face.width_mm, 1, 300, 38), settings);
    footprint_mm = sane(input.face.footprint_mm, 0.1, 300, 10);
    grid.sampleMiddle(*input.plane);
    const TissueColumn& middle = grid.column(grid.middle());
    if (!middle.met) return;
    const bool byForce = input.force_N > 0 && std::isfinite(input.force_N);
    if (!byForce && !(middle.skin_mm < -kTouch_mm)) return;
    answer.converged = middle.skinFound;
    if (!middle.skinFound) return;
    if (!(springs.limit_mm(middle.length_mm) > 0)) return restOnRigid(byForce ? input.force_N : 0, middle, answer);

    grid.sampleAll(*input.plane);
    const double indentation_mm = byForce ? indentationFor(input.force_N, answer) : -middle.skin_mm;
    if (byForce) answer.faceShift_mm = middle.skin_mm + indentation_mm;
    press(indentation_mm, answer);
    write(answer);
  }

 private:
  /// No tissue under the middle of the face can yield.
  static void restOnRigid(double force_N, const TissueColumn& middle, Deformation& answer) {
    answer.force_N = force_N;
    answer.faceShift_mm = force_N > 0 ? middle.skin_mm : 0;
    answer.converged = force_N > 0;
  }

  /// Equations 2 and 3: the normal profile, and the pressure in a column that follows from it.
  ColumnLoad loadOf(int c, double indentation_mm) const {
    const TissueColumn& column = grid.column(c);
    return column.met ? springs.loadAtShortening(indentation_mm * grid.profile(c), column.length_mm) : ColumnLoad{};
  }

  double forceAt(double indentation_mm) const {
    double pressure_kPa = 0;
    for (int c = 0; c < grid.columns(); ++c) pressure_kPa += loadOf(c, indentation_mm).pressure_kPa;
    return pressure_kPa * grid.step_mm() * footprint_mm * kNewtonPerkPamm2;
  }

  /// Equation 1, with all columns that the profile compresses; the force increases with the indentation.
  double indentationFor(double force_N, Deformation& answer) const {
    double low_mm = 0, high_mm = springs.limit_mm(grid.column(grid.middle()).length_mm);
    answer.iterations = 1;
    answer.converged = forceAt(high_mm) >= force_N;
    if (!answer.converged) return high_mm;
    // Below all limits the law is linear, and the first guess is exact.
    constexpr double kSmall_mm = 1e-3;
    double guess_mm = std::min(high_mm, force_N * kSmall_mm / forceAt(kSmall_mm));
    for (; answer.iterations < 60; ++answer.iterations) {
      const double error_N = forceAt(guess_mm) - force_N;
      if (std::abs(error_N) <= 1e-10 * force_N) break;
      (error_N > 0 ? high_mm : low_mm) = guess_mm;
      guess_mm = (low_mm + high_mm) / 2;
    }
    return guess_mm;
  }

  void press(double indentation_mm, Deformation& answer) {
    loads.resize(grid.columns());
    double pressure_kPa = 0;
    for (int c = 0; c < grid.columns(); ++c) {
      loads[c] = loadOf(c, indentation_mm);
      pressure_kPa += loads[c].pressure_kPa;
    }
    answer.force_N = pressure_kPa * grid.step_mm() * footprint_mm * kNewtonPerkPamm2;
    answer.moved = true;
    if (loads[grid.middle()].limited) answer.converged = false;
  }

  void write(Deformation& answer) {
    PlaneDisplacement& field = answer.displacement;
    field.left_mm = grid.x_mm(0);
    field.top_mm = grid.z_mm(0);
    field.step_mm = grid.step_mm();
    field.columns = answer.meshColumns = grid.columns();
    field.rows = answer.meshRows = grid.rows() + 1;
    field.restFromDisplayed.assign(std::size_t(field.columns) * field.rows, {});
    answer.mesh.resize(field.restFromDisplayed.size());
    seen_mm.resize(field.rows);
    for (int c = 0; c < grid.columns(); ++c) {
      placeSprings(c);
      writeMesh(c, answer);
      if (grid.column(c).met) writeDisplacement(c, field);
    }
    fillAirColumns(field);
    writePressure(answer);
    writeLumens(answer);
  }

  /// Equation 5: positions of the springs of a column, summed from the bottom. Above the skin, air moves with it.
  void placeSprings(int c) {
    seen_mm[grid.rows()] = grid.bottom_mm();
    const int first = grid.column(c).met ? grid.column(c).first : grid.rows();
    for (int r = grid.rows() - 1; r >= first; --r)
      seen_mm[r] =
          seen_mm[r + 1] - grid.length_mm(c, r) * (1 - springs.strain(grid.label(c, r), loads[c].pressure_kPa));
  }

  /// Deformed position of the upper end of a row.
  double seenOf(int c, int r) const {
    const TissueColumn& column = grid.column(c);
    if (!column.met || r < column.first || grid.z_mm(r) < column.skin_mm) return grid.z_mm(r) + loads[c].shortening_mm;
    if (r > column.first) return seen_mm[r];
    return seen_mm[r + 1] - grid.step_mm() * (1 - springs.strain(grid.label(c, r), loads[c].pressure_kPa));
  }

  void writeMesh(int c, Deformation& answer) const {
    for (int r = 0; r <= grid.rows(); ++r)
      answer.mesh[std::size_t(r) * answer.meshColumns + c] = {
          static_cast<float>(grid.x_mm(c)), static_cast<float>(grid.z_mm(r)), static_cast<float>(grid.x_mm(c)),
          static_cast<float>(seenOf(c, r))};
  }

  /// The exact inverse of the piecewise linear map of a column, at the lattice's points.
  void writeDisplacement(int c, PlaneDisplacement& field) const {
    const int first = grid.column(c).first;
    int spring = grid.rows() - 1;
    for (int r = grid.rows(); r >= 0; --r) {
      const double z_mm = grid.z_mm(r);
      while (spring > first && seen_mm[spring] > z_mm) --spring;
      double shift_mm = -loads[c].shortening_mm;
      if (z_mm > seen_mm[first]) {
        const double left = 1 - springs.strain(grid.label(c, spring), loads[c].pressure_kPa);
        shift_mm = grid.z_mm(spring + 1) - (seen_mm[spring + 1] - z_mm) / left - z_mm;
      }
      field.restFromDisplayed[std::size_t(r) * field.columns + c].z_mm = static_cast<float>(shift_mm);
    }
  }

  /// Columns without tissue get the nearest column's displacement: they show nothing, and interpolation does not bend
  /// the tissue beside them.
  void fillAirColumns(PlaneDisplacement& field) const {
    const auto copy = [&](int from, int to) {
      for (int r = 0; r < field.rows; ++r)
        field.restFromDisplayed[std::size_t(r) * field.columns + to] =
            field.restFromDisplayed[std::size_t(r) * field.columns + from];
    };
    for (int c = 0; c < field.columns; ++c) {
      if (grid.column(c).met) continue;
      for (int away = 1; away < field.columns; ++away) {
        const bool before = c - away >= 0 && grid.column(c - away).met;
        const bool behind = c + away < field.columns && grid.column(c + away).met;
        if (!before && !behind) continue;
        copy(before ? c - away : c + away, c);
        break;
      }
    }
  }

  void writePressure(Deformation& answer) const {
    const int cells = grid.columns() - 1;
    answer.pressure_kPa.resize(std::size_t(cells) * grid.rows());
    const auto pressure = [&](int c, int r) {
      return grid.column(c).met && r >= grid.column(c).first ? loads[c].pressure_kPa : 0.0;
    };
    for (int r = 0; r < grid.rows(); ++r)
      for (int c = 0; c < cells; ++c)
        answer.pressure_kPa[std::size_t(r) * cells + c] = static_cast<float>((pressure(c, r) + pressure(c + 1, r)) / 2);
  }

  void writeLumens(Deformation& answer) const {
    for (const Label vessel : {kArtery, kVein}) {
      LumenArea lumen{vessel, 0, 0};
      for (int c = 0; c < grid.columns(); ++c) {
        const double share = 1 - springs.strain(vessel, loads[c].pressure_kPa);
        for (int r = grid.column(c).first; grid.column(c).met && r < grid.rows(); ++r) {
          if (grid.label(c, r) != vessel) continue;
          lumen.rest_mm2 += grid.length_mm(c, r) * grid.step_mm();
          lumen.area_mm2 += grid.length_mm(c, r) * grid.step_mm() * share;
        }
      }
      if (lumen.rest_mm2 > 0) answer.lumens.push_back(lumen);
    }
  }

  LabelSprings springs;
  DeformationSettings settings;
  double footprint_mm = 10;
  ColumnGrid grid;
  std::vector<ColumnLoad> loads;
  std::vector<double> seen_mm;  ///< upper ends of one column's springs; the last is the bottom
};

}  // namespace

std::unique_ptr<DeformationModel> makeColumnModel(const MechanicalTable& tissues, const DeformationSettings& settings) {
  return std::make_unique<ColumnModel>(tissues, settings);
}

}  // namespace insonate
