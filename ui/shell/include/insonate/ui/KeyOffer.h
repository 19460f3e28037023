#pragma once

#include <QKeyEvent>

namespace insonate::ui {

/// For the event filter of an image whose keys take precedence over the window's shortcuts. `key(event, act)` returns
/// whether the key is one of its own, and performs it if `act`. @returns whether the event ends here
template <class Key>
bool offerKey(QEvent& event, Key key) {
  if (event.type() == QEvent::KeyPress) return key(static_cast<QKeyEvent&>(event), true);
  if (event.type() != QEvent::ShortcutOverride || !key(static_cast<QKeyEvent&>(event), false)) return false;
  event.accept();
  return true;
}

}  // namespace insonate::ui
