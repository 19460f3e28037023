#include "NeedleWords.h"

#include <insonate/ui/Text.h>

#include <QStringList>
#include <algorithm>

namespace insonate::train {
namespace {

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

/// "the right internal jugular vein"; "another vein"; "the vein" where the vessel has no name.
QString vesselWords(const NeedleEvent& event, const QString& vessel) {
  if (vessel.isEmpty()) return tr("the %1").arg(wall(event.wall));
  return vessel.startsWith(QLatin1String("another ")) ? vessel : tr("the %1").arg(vessel);
}

/// As the first word of a sentence, without an article.
QString subject(const NeedleEvent& event, const QString& vessel) {
  const QString name = vessel.isEmpty() ? wall(event.wall) : vessel;
  return name.left(1).toUpper() + name.mid(1);
}

QString insertedBy(double length_mm) {
  return tr("inserted %1\u00a0mm").arg(length_mm, 0, 'f', 1);
}

QString force(const NeedleState& state) {
  return tr("%1\u00a0N").arg(std::max(0.0, state.axial_N), 0, 'f', 1);
}

QString placeOf(const NeedleState& state, const QString& vessel) {
  if (state.onBone) return tr("on bone");
  if (vessel.isEmpty()) return tr("in %1").arg(tissue(state.in));
  return vessel.startsWith(QLatin1String("another ")) ? tr("in %1").arg(vessel) : tr("in the %1").arg(vessel);
}

}  // namespace

QString vesselAt(const HapticSession& session, Label label, Vec3 patient_mm) {
  return label == kVein || label == kArtery ? ui::qt(session.vesselAt(label, patient_mm)) : QString();
}

QString findingText(const NeedleEvent& event, const QString& vessel) {
  const QString length = tr("%1\u00a0mm").arg(event.inserted_mm, 0, 'f', 1);
  switch (event.kind) {
    case NeedleEventKind::Entered:
      if (event.wall == kSkin) return tr("The needle is through the skin.");
      if (event.wall == kVein) return tr("%1 entered, insertion length %2.").arg(subject(event, vessel), length);
      if (event.wall == kArtery)
        return tr("%1 punctured, insertion length %2. Withdraw the needle and apply pressure.")
            .arg(subject(event, vessel), length);
      if (event.wall == kAirway)
        return tr("Airway or lung punctured, insertion length %1. Withdraw the needle.").arg(length);
      return tr("The needle has entered the %1, insertion length %2.").arg(wall(event.wall), length);
    case NeedleEventKind::Left:
      return tr("The needle has passed out through the posterior wall of %1, insertion length %2.")
          .arg(vesselWords(event, vessel), length);
    case NeedleEventKind::Withdrawn:
      if (event.wall == kSkin) return tr("The needle is out of the skin.");
      return tr("The needle is withdrawn through the wall of %1.").arg(vesselWords(event, vessel));
    case NeedleEventKind::Struck:
      return tr("The needle is on bone, insertion length %1. It cannot advance further here.").arg(length);
  }
  return {};
}

QString displayText(const NeedleState& state, const QString& vessel, double imageDepth_mm) {
  if (!state.onBone && state.tenting && state.tent_mm > 0.2)
    return tr("needle indents the %1 by %2\u00a0mm, %3")
        .arg(wall(state.tented))
        .arg(state.tent_mm, 0, 'f', 1)
        .arg(force(state));
  if (!state.inBody) return tr("needle outside the skin");
  const QString depth = tr("depth %1\u00a0mm").arg(imageDepth_mm, 0, 'f', 1);
  QStringList words{placeOf(state, vessel), insertedBy(state.depth_mm), depth};
  if (!state.onBone) words << force(state);
  return words.join(QStringLiteral(", "));
}

QString plainWordsOf(const NeedleState& state) {
  return state.inBody ? tr("%1, %2").arg(insertedBy(state.depth_mm), force(state)) : tr("needle outside the skin");
}

}  // namespace insonate::train
