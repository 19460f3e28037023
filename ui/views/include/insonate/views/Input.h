#pragma once

namespace insonate::views {

/// A place in a view, in device pixels from its top left corner; the first pixel's center is (0.5, 0.5).
struct DisplayPoint {
  double x = 0, y = 0;
};

enum class Button { None, Left, Middle, Right };

/// Action of a mouse or pen. A toolkit translates its own events into these, so that views need no toolkit.
struct Pointer {
  DisplayPoint at;
  Button button = Button::None;  ///< the one pressed, released or held
  bool shift = false, control = false;
};

enum class Key { Up, Down, Left, Right, PageUp, PageDown, A, D, G, R };

}  // namespace insonate::views
