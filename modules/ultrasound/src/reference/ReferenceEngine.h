#pragma once

#include <insonate/ultrasound/Engine.h>

namespace insonate {

/// The acoustic model in its plainest form: scalar, double, one thread. Every other engine must agree with it.
std::unique_ptr<Engine> makeReferenceEngine();

}  // namespace insonate
