#include "NeedleWords.h"

#include <insonate/ui/Text.h>

#include <QCoreApplication>

namespace insonate::train {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("NeedleWords", text);
}

QString wall(Label label) {
  switch (label) {
    case kSkin:
      return tr("skin");
    case kVein:
      return tr("vein");
    case kArtery:
      return tr("artery");
    case kAirway:
      return tr("airway");
    case kCartilage:
      return tr("cartilage");
    default:
      return tr("bone");
  }
}

QString tissue(Label label) {
  for (const LabelInfo& info : labelTable())
    if (info.label == label) return ui::qt(info.name);
  return tr("soft tissue");
}

}  // namespace

QString sentenceOf(const NeedleEvent& event) {
  const QString deep = QString::number(event.depth_mm, 'f', 1);
  switch (event.kind) {
    case NeedleEventKind::Entered:
      if (event.wall == kSkin) return tr("Through the skin.");
      if (event.wall == kVein) return tr("Vein entered, %1 mm from the skin.").arg(deep);
      if (event.wall == kArtery)
        return tr("Artery punctured, %1 mm from the skin. Withdraw the needle and press.").arg(deep);
      if (event.wall == kAirway) return tr("Airway or lung punctured, %1 mm from the skin. Withdraw.").arg(deep);
      return tr("Into the %1, %2 mm from the skin.").arg(wall(event.wall), deep);
    case NeedleEventKind::Left:
      return tr("Out through the back wall of the %1, %2 mm from the skin.").arg(wall(event.wall), deep);
    case NeedleEventKind::Withdrawn:
      if (event.wall == kSkin) return tr("The needle is out of the skin.");
      return tr("Back through the wall of the %1.").arg(wall(event.wall));
    case NeedleEventKind::Struck:
      return tr("On bone, %1 mm from the skin: the needle goes no further here.").arg(deep);
  }
  return {};
}

QString wordsOf(const NeedleState& state, bool silent) {
  if (silent && state.inBody)
    return tr("%1 mm deep, %2 N").arg(state.depth_mm, 0, 'f', 1).arg(std::max(0.0, state.axial_N), 0, 'f', 1);
  if (silent) return tr("outside the skin");
  if (state.onBone) return tr("on bone, %1 mm deep").arg(state.depth_mm, 0, 'f', 1);
  const QString felt = tr("%1 N").arg(std::max(0.0, state.axial_N), 0, 'f', 1);
  if (state.tenting && state.tent_mm > 0.2)
    return tr("pushes the %1 %2 mm ahead, %3").arg(wall(state.tented)).arg(state.tent_mm, 0, 'f', 1).arg(felt);
  if (!state.inBody) return tr("outside the skin");
  return tr("in %1, %2 mm deep, %3").arg(tissue(state.in)).arg(state.depth_mm, 0, 'f', 1).arg(felt);
}

}  // namespace insonate::train
