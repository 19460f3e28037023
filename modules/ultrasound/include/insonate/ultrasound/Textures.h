#pragma once

namespace insonate {

/// Makes the textures of tissues, which all scenes of a process share. This takes half a second of one processor.
/// Without this call, the first scene makes them. Call it early, on any thread, while the program waits for something
/// else.
void prepareTextures();

}  // namespace insonate
