#pragma once

namespace insonate {

/// Makes the texture of tissues, which all scenes of a process share and the first one would make otherwise: half a
/// second of one processor. To be called early, on any thread, where there is something else to wait for.
void prepareTextures();

}  // namespace insonate
