#pragma once

class QApplication;

namespace insonate::ui {

/// Keeps fields from taking input that is meant for others. Call it once.
///
/// - The wheel scrolls the panel around a slider, number field or choice, unless this field has the keyboard focus or
///   Ctrl is held.
/// - A text or number field in a window gives up the keyboard focus on Return, on Escape and on a click elsewhere, so
///   that keys reach the window's commands again. Dialogs keep Return and Escape for their buttons.
void keepFieldsQuiet(QApplication& application);

}  // namespace insonate::ui
