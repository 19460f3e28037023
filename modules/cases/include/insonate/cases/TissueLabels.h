#pragma once

#include <insonate/cases/PatientCase.h>

#include <memory>
#include <optional>

namespace insonate {

/// Returns a copy of the label map in which each of the author's own labels is replaced by its tissue
/// (OwnLabel::tissue). Ultrasound, haptics and the check of a case need such a map. No value if the case has no own
/// labels. Takes some hundredths of a second for a large CT.
std::optional<LabelMap> withTissueLabels(const OwnLabels& own, const LabelMap& labels);

/// Returns the same copy for a shared label map; returns `labels` itself if the case has no own labels.
std::shared_ptr<const LabelMap> withTissueLabels(const OwnLabels& own, std::shared_ptr<const LabelMap> labels);

/// Replaces the author's own labels in the patient's label map by their tissues.
void replaceOwnLabels(PatientCase& patient);

}  // namespace insonate
