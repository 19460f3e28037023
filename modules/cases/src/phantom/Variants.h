#pragma once

#include "arm/Arm.h"
#include "groin/Groin.h"
#include "neck/Anatomy.h"

#include <insonate/cases/Phantom.h>

#include <variant>

namespace insonate::phantom {

struct VariantModel {
  PhantomVariant about;
  std::variant<NeckParameters, GroinParameters, ArmParameters> parameters;
};

std::span<const VariantModel> variantModels();

}  // namespace insonate::phantom
