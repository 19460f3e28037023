#pragma once

namespace insonate::views {

/// A position in a view, in device pixels from its top left corner; the center of the first pixel is (0.5, 0.5).
struct DisplayPoint {
  double x = 0, y = 0;
};

enum class Button { None, Left, Middle, Right };

/// State of a mouse or pen at an event. A toolkit's events are converted to this type, so that views need no toolkit.
struct Pointer {
  DisplayPoint at;
  Button button = Button::None;  ///< the button that was pressed or released, or is held
  bool shift = false, control = false;
};

enum class Key { Up, Down, Left, Right, PageUp, PageDown, A, D, G, R };

}  // namespace insonate::views
