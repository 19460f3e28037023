#pragma once

#include <insonate/views/Theme.h>

class vtkTextProperty;

namespace insonate::views {

/// Sets the system's sans-serif font at a size in pixels; VTK's own font if the system has none.
void useSystemSans(vtkTextProperty& text, double size_px, Color color, bool bold = false);

}  // namespace insonate::views
