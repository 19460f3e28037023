#pragma once

#include <insonate/haptics/NeedleState.h>
#include <insonate/simulator/HandsSession.h>

#include <QString>

namespace insonate::train {

/// Name of the vessel of this label, vein or artery, at a point of the patient; empty for other labels, and where the
/// case names none.
QString vesselAt(const HandsSession& session, Label label, Vec3 patient_mm);

/// Describes an event of the needle in a sentence. `vessel`: name of the vessel whose wall it is, as vesselName(); may
/// be empty.
QString sentenceOf(const NeedleEvent& event, const QString& vessel);

/// Describes the tip's place and the force on it: "in the right internal jugular vein, inserted 22.3 mm, depth 15.8
/// mm, 0.6 N". `vessel`: name of the vessel that it is in; may be empty. `imageDepth_mm`: depth of the tip below the
/// probe's face along the image's depth axis, as the scale beside the image reads.
QString wordsOf(const NeedleState& state, const QString& vessel, double imageDepth_mm);

/// Description in a test, by the marks on the shaft and the force in the hand: "inserted 22.3 mm, 0.6 N".
QString plainWordsOf(const NeedleState& state);

}  // namespace insonate::train
