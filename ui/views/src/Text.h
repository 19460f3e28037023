#pragma once

#include <insonate/views/Theme.h>

class vtkTextProperty;

namespace insonate::views {

/// The system's sans at a size in pixels; VTK's own face where the system has none.
void useSystemSans(vtkTextProperty& text, double size_px, Colour colour, bool bold = false);

}  // namespace insonate::views
