#pragma once

#include <insonate/haptics/NeedleState.h>
#include <insonate/simulator/HapticSession.h>

#include <QString>

namespace insonate::train {

/// Returns the name of the vein or artery with this label at a point of the patient. Empty for other labels, or if the
/// case names no vessel there.
QString vesselAt(const HapticSession& session, Label label, Vec3 patient_mm);

/// Describes an event of the needle in a sentence. `vessel`: name of the vessel whose wall is concerned, as from
/// vesselName(); may be empty.
QString findingText(const NeedleEvent& event, const QString& vessel);

/// Describes the tip's place and the force on the needle: "in the right internal jugular vein, inserted 22.3 mm, depth
/// 15.8 mm, 0.6 N". `vessel`: name of the vessel that the tip is in; may be empty. `imageDepth_mm`: the tip's depth on
/// the image's depth scale, below the probe's face.
QString displayText(const NeedleState& state, const QString& vessel, double imageDepth_mm);

/// Describes the needle for an attempt in test mode, by the marks on the shaft and the force in the hand: "inserted
/// 22.3 mm, 0.6 N".
QString plainWordsOf(const NeedleState& state);

}  // namespace insonate::train
