#pragma once

#include "Anatomy.h"

#include <insonate/cases/Phantom.h>

namespace insonate::phantom {

struct VariantModel {
  PhantomVariant about;
  NeckParameters parameters;
};

std::span<const VariantModel> variantModels();

}  // namespace insonate::phantom
