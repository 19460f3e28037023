#pragma once

#include <insonate/cases/PatientCase.h>

#include <memory>
#include <optional>

namespace insonate {

/// The labels as images, hands and the check see them: each of the author's own as the tissue that it is made of.
/// None where the author has no labels of his own. Some hundredths of a second for a large CT.
std::optional<LabelMap> inTissues(const OwnLabels& own, const LabelMap& labels);

/// Replaces own labels by their tissues; returns the same map if there are none.
std::shared_ptr<const LabelMap> inTissues(const OwnLabels& own, std::shared_ptr<const LabelMap> labels);

/// Replaces the patient's own labels by their tissues.
void putTissues(PatientCase& patient);

}  // namespace insonate
