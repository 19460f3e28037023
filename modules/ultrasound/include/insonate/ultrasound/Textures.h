#pragma once

namespace insonate {

/// Makes the three-dimensional textures of tissues, which all scenes of a process share. This takes half a second of
/// one processor. Without this call, making the first scene also makes the textures. Call the function early, on any
/// thread, while the program waits for something else.
void prepareTextures();

}  // namespace insonate
