#pragma once

#include <insonate/ultrasound/Engine.h>

namespace insonate {

/// Fails with a sentence where there is no OpenGL 4.3. Where the card fails later, frames come from the `cpu` engine,
/// and note() says why.
Result<std::unique_ptr<Engine>> makeGlslEngine();

}  // namespace insonate
