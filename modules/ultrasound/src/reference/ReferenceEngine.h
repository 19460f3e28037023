#pragma once

#include <insonate/ultrasound/Engine.h>

namespace insonate {

/// Makes the engine with the plainest form of the acoustic model: scalar, double precision, one thread. Every other
/// engine must agree with it.
std::unique_ptr<Engine> makeReferenceEngine();

}  // namespace insonate
