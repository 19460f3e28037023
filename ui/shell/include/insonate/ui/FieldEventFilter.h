#pragma once

class QApplication;

namespace insonate::ui {

/// Prevents input fields from consuming wheel and key events that are meant for other widgets. Call it once.
///
/// - Over a slider, number field or combo box, the wheel scrolls the panel that contains the field, unless the field
///   has the keyboard focus or Ctrl is held.
/// - A text or number field in a window loses the keyboard focus on Return, on Escape and on a click elsewhere, so that
///   keys reach the commands of the window again. In dialogs, Return and Escape go to the buttons.
void filterFieldEvents(QApplication& application);

}  // namespace insonate::ui
