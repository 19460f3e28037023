#include "VesselAreas.h"

#include <insonate/ui/Theme.h>

namespace insonate::train {
namespace {

constexpr double kLeast_N = 0.05;                       // one digit after the point is shown
constexpr views::Color kArteryWords{0xf2, 0x9a, 0x94};  // red at 7:1 on every ground

}  // namespace

const LumenArea* lumenOf(const LiveDeformation& press, Label label) {
  for (const LumenArea& area : press.lumens)
    if (area.label == label && area.rest_mm2 > 0) return &area;
  return nullptr;
}

bool presses(const LiveDeformation& press) {
  return press.force_N >= kLeast_N;
}

QColor vesselColor(Label label) {
  return ui::toQColor(label == kVein ? views::theme::kLink : kArteryWords);
}

}  // namespace insonate::train
