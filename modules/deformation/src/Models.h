#pragma once

#include <insonate/deformation/DeformationModel.h>

namespace insonate {

/// makeColumnModel() makes the model of springs in series: equations 1 to 5 of the thesis. README.md states the model's
/// limits.
std::unique_ptr<DeformationModel> makeColumnModel(const MechanicalTable& tissues, const DeformationSettings& settings);
std::unique_ptr<DeformationModel> makeElasticModel(const MechanicalTable& tissues, const DeformationSettings& settings);
std::unique_ptr<DeformationModel> makeReferenceModel(const MechanicalTable& tissues,
                                                     const DeformationSettings& settings);

}  // namespace insonate
