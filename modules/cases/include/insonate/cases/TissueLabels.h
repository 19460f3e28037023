#pragma once

#include <insonate/cases/PatientCase.h>

#include <memory>
#include <optional>

namespace insonate {

/// Returns the label map that ultrasound, haptics and the case check use: each of the author's own labels is replaced
/// by its tissue. No value if the author has no own labels. Takes some hundredths of a second for a large CT.
std::optional<LabelMap> inTissues(const OwnLabels& own, const LabelMap& labels);

/// Replaces the author's own labels by their tissues; returns the same map if there are none.
std::shared_ptr<const LabelMap> inTissues(const OwnLabels& own, std::shared_ptr<const LabelMap> labels);

/// Replaces the author's own labels in the patient's label map by their tissues.
void putTissues(PatientCase& patient);

}  // namespace insonate
