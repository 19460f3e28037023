#pragma once

#include "LabelSprings.h"

#include <insonate/deformation/DeformationModel.h>

#include <vector>

namespace insonate::column {

/// Tissue of one column, from the skin downward.
struct TissueColumn {
  bool met = false;       ///< true if the column contains tissue under the face
  bool skinFound = true;  ///< false if tissue continues to the upper end of the grid
  double skin_mm = 0;     ///< depth z of the skin
  int first = 0;          ///< row of the column's first spring
  LengthByLabel length_mm{};
};

/// Divides the plane into columns of springs; the middle column lies under the middle of the face. The lower end of the
/// last row does not move. Memory is reused from solution to solution.
class ColumnGrid {
 public:
  /// Distance above the face within which skin is searched for.
  static constexpr double kReach_mm = 30;
  /// Half width of the grid in standard deviations of the Gaussian indentation profile.
  static constexpr double kCovered = 3.5;
  static constexpr int kMaxSprings = 400000;

  /// Returns the standard deviation of the Gaussian with the height and area of a rectangle of this width: width /
  /// sqrt(2 pi).
  static double profileSd_mm(double faceWidth_mm);

  void layOut(double faceWidth_mm, const DeformationSettings& settings);

  /// Samples only the middle column, to decide whether the face touches the tissue.
  void sampleMiddle(const TissuePlane& plane);
  void sampleAll(const TissuePlane& plane);

  int columns() const { return columnCount; }
  int rows() const { return rowCount; }
  int middle() const { return columnCount / 2; }
  double step_mm() const { return step; }
  double bottom_mm() const { return bottom; }
  double x_mm(int column) const { return (column - middle()) * step; }
  /// Returns z of the upper end of a row.
  double z_mm(int row) const { return bottom - (rowCount - row) * step; }
  double profile(int column) const { return weights[column]; }

  const TissueColumn& column(int column) const { return measured[column]; }
  std::uint8_t label(int column, int row) const { return tissue[at(column, row)].label; }
  /// Returns the length of a spring; the first spring of a column begins at the skin.
  double length_mm(int column, int row) const {
    return row == measured[column].first ? z_mm(row + 1) - measured[column].skin_mm : step;
  }

 private:
  std::size_t at(int column, int row) const { return std::size_t(column) * rowCount + row; }
  TissueColumn measure(int column) const;

  int columnCount = 0, rowCount = 0;
  double step = 0, bottom = 0, width = 0;
  std::vector<PlanePoint> points;  ///< centers of the springs, [column][row]
  std::vector<PlaneTissue> tissue;
  std::vector<TissueColumn> measured;
  std::vector<double> weights;
};

}  // namespace insonate::column
