#pragma once

#include "CrossSections.h"

#include <insonate/core/Vec3.h>

#include <cstdint>
#include <span>
#include <vector>

namespace insonate::wire {

/// A piece of a tube: a straight center line, along which the cross-section changes linearly.
struct TubePiece {
  Vec3 from_mm, along;  ///< start and unit direction
  double length_mm = 0, radius_mm = 0, slope = 0;
  int vessel = 0;
  double start_mm = 0;          ///< length of the vessel's center line up to the start
  int point = 0;                ///< index of the start among the points of all vessels; the next index is the end
  bool isRound = true;          ///< the radius describes the wall; otherwise, the cross-sections at both ends do
  Section section{}, change{};  ///< at the start, and for each millimeter

  struct Nearest {
    double distance_mm, t_mm;  ///< distance to the wall, and position along the piece
    Vec3 away;                 ///< from the center line to the point
    double relative;           ///< distance from the center line, 1 at the wall
  };
  Nearest nearest(Vec3 p) const noexcept;
  /// Gradient of the distance.
  Vec3 outward(const Nearest& nearest) const noexcept;
  /// Second derivative of the distance around the tube.
  double curvature_1pmm(const Nearest& nearest) const noexcept;

 private:
  Section sectionAt(double t_mm) const noexcept;
};

/// Finds the piece with the nearest wall. A grid of 4 mm lists the pieces that can be the nearest one in each cell.
class WallGrid {
 public:
  explicit WallGrid(std::vector<TubePiece> pieces);
  std::span<const TubePiece> pieces() const { return pieces_; }
  /// Returns the index of the piece with the smallest distance, the first of equals; `nearest` receives the distance.
  int find(Vec3 p, TubePiece::Nearest& nearest) const noexcept;

 private:
  std::vector<int> candidatesFor(std::span<const int> among, Vec3 middle, double half_mm) const;

  std::vector<TubePiece> pieces_;
  Vec3 low_mm{};
  int size_[3] = {0, 0, 0};
  std::vector<std::uint32_t> first_;  ///< [cell]: position of the cell's first piece in list_
  std::vector<int> list_;
};

}  // namespace insonate::wire
