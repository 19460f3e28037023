#pragma once

#include <insonate/tissue/NeedleTable.h>

#include <array>

namespace insonate::haptics {

/// Tissue along the shaft, from the entry to the tip, in pieces of half a millimeter, with cumulative sums. Entries are
/// written as the tip advances; after a withdrawal, the advancing tip overwrites them.
class ShaftTissue {
 public:
  struct Sum {
    double slides_N = 0, holds_N = 0, viscous_Nspmm = 0, lateral_Npmm = 0;
  };

  void restart() { count_ = 0; }
  /// Records that the tip is in `label` at depth s >= 0.
  void reach(double s_mm, const NeedleTable& table, Label label);
  /// Sums from the entry to depth s.
  Sum upTo(double s_mm, const NeedleTable& table) const;

 private:
  static constexpr double kPiece_mm = 0.5;
  static constexpr int kPieces = 400;  // pieces; 200 mm in total, longer than any needle
  std::array<Label, kPieces> label_{};
  std::array<Sum, kPieces + 1> before_{};
  int count_ = 0;
};

}  // namespace insonate::haptics
