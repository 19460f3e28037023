#pragma once

#include <insonate/cases/PatientCase.h>

#include <memory>
#include <optional>

namespace insonate {

/// Returns a copy of the label map in which each label that the author has defined is replaced by the label of its
/// tissue (OwnLabel::tissue). Ultrasound, haptics and the check of a case need such a map. No value if the author has
/// defined no labels. Takes some hundredths of a second for a large CT.
std::optional<LabelMap> withTissueLabels(const OwnLabels& own, const LabelMap& labels);

/// Returns the same copy for a shared label map; returns `labels` itself if the author has defined no labels.
std::shared_ptr<const LabelMap> withTissueLabels(const OwnLabels& own, std::shared_ptr<const LabelMap> labels);

/// Replaces, in the patient's label map, the labels that the author has defined by the labels of their tissues.
void replaceOwnLabels(PatientCase& patient);

}  // namespace insonate
