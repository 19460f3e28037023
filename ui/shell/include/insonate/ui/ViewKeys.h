#pragma once

#include <QKeyEvent>

namespace insonate::ui {

/// Handles a key event in the event filter of a view. Keys of the view take precedence over shortcuts of the window.
/// `key(event, act)` returns whether the view uses the key and, if `act` is true, performs the action of the key.
/// @returns whether the event is consumed
template <class Key>
bool handleViewKey(QEvent& event, Key key) {
  if (event.type() == QEvent::KeyPress) return key(static_cast<QKeyEvent&>(event), true);
  if (event.type() != QEvent::ShortcutOverride || !key(static_cast<QKeyEvent&>(event), false)) return false;
  event.accept();
  return true;
}

}  // namespace insonate::ui
