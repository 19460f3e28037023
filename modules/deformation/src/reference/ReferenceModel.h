#pragma once

#include <insonate/deformation/DeformationModel.h>

namespace insonate {

std::unique_ptr<DeformationModel> makeReferenceModel(const MechanicalTable& tissues,
                                                     const DeformationSettings& settings);

}  // namespace insonate
