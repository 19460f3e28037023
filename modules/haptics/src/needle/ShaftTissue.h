#pragma once

#include <insonate/tissue/NeedleTable.h>

#include <array>

namespace insonate::haptics {

/// Tissue along the needle's shaft, from the puncture of the skin to the tip, in pieces of half a millimeter, with
/// cumulative sums of friction and stiffness. Pieces are written as the tip advances; after a withdrawal, the advancing
/// tip overwrites them.
class ShaftTissue {
 public:
  struct Sum {
    double slides_N = 0, holds_N = 0, viscous_Nspmm = 0, lateral_Npmm = 0;
  };

  void restart() { count_ = 0; }
  /// Records that the tip is in tissue `label` at the depth `s_mm` (0 or more).
  void reach(double s_mm, const NeedleTable& table, Label label);
  /// Returns the sums from the puncture of the skin to the depth `s_mm`.
  Sum upTo(double s_mm, const NeedleTable& table) const;

 private:
  static constexpr double kPiece_mm = 0.5;
  static constexpr int kPieces = 400;  // number of pieces: 200 mm in total, longer than any needle
  std::array<Label, kPieces> label_{};
  std::array<Sum, kPieces + 1> before_{};
  int count_ = 0;
};

}  // namespace insonate::haptics
