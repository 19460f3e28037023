#include "needle/ShaftTissue.h"

#include <algorithm>

namespace insonate::haptics {
namespace {

ShaftTissue::Sum grown(const ShaftTissue::Sum& sum, const NeedleTissue& tissue, double length_mm) {
  return {sum.slides_N + tissue.friction_Npmm * length_mm, sum.holds_N + tissue.stiction_Npmm * length_mm,
          sum.viscous_Nspmm + tissue.viscosity_Nspmm2 * length_mm, sum.lateral_Npmm + tissue.lateral_Npmm2 * length_mm};
}

}  // namespace

void ShaftTissue::reach(double s_mm, const NeedleTable& table, Label label) {
  const int piece = std::clamp(static_cast<int>(s_mm / kPiece_mm), 0, kPieces - 1);
  for (int i = std::min(count_, piece); i <= piece; ++i) {
    label_[i] = label;
    before_[i + 1] = grown(before_[i], table.of(label), kPiece_mm);
  }
  count_ = piece + 1;
}

ShaftTissue::Sum ShaftTissue::upTo(double s_mm, const NeedleTable& table) const {
  if (count_ == 0 || s_mm <= 0) return {};
  const int piece = std::clamp(static_cast<int>(s_mm / kPiece_mm), 0, count_ - 1);
  return grown(before_[piece], table.of(label_[piece]), std::min(s_mm - piece * kPiece_mm, kPiece_mm));
}

}  // namespace insonate::haptics
