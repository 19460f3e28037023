#pragma once

#include <insonate/cases/PatientCase.h>

#include <memory>
#include <optional>

namespace insonate {

/// The labels as images, hands and the check see them: each of the author's own as the tissue that it is made of.
/// None where the author has no labels of his own. Some hundredths of a second for a large CT.
std::optional<LabelMap> inTissues(const OwnLabels& own, const LabelMap& labels);

/// The same map where nothing is to be changed.
std::shared_ptr<const LabelMap> inTissues(const OwnLabels& own, std::shared_ptr<const LabelMap> labels);

/// In its place.
void putTissues(PatientCase& patient);

}  // namespace insonate
