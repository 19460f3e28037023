#pragma once

namespace insonate {

/// Computes the three-dimensional textures of tissues, which all scenes of a process share. This takes half a second of
/// one processor. Without this call, the first scene computes the textures. Call the function early, on any thread,
/// while the program waits for other things.
void prepareTextures();

}  // namespace insonate
