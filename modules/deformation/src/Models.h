#pragma once

#include <insonate/deformation/DeformationModel.h>

namespace insonate {

/// Springs in series: equations 1 to 5 of the thesis. See README.md for what they can and cannot show.
std::unique_ptr<DeformationModel> makeColumnModel(const MechanicalTable& tissues, const DeformationSettings& settings);
std::unique_ptr<DeformationModel> makeElasticModel(const MechanicalTable& tissues, const DeformationSettings& settings);
std::unique_ptr<DeformationModel> makeReferenceModel(const MechanicalTable& tissues,
                                                     const DeformationSettings& settings);

}  // namespace insonate
