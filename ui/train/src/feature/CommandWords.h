#pragma once

#include <insonate/ui/Commands.h>

#include <QKeySequence>
#include <QString>
#include <cstddef>

namespace insonate::train {

/// Keys of a command as the list of keys shows them, e.g. "Space, F"; empty if there is no such command.
inline QString keysOf(const ui::Commands& commands, const QString& id) {
  const ui::Command* command = commands.find(id);
  return command ? command->listed : QString();
}

/// One key of a command as menus show it, e.g. "Alt+1"; empty if there is no such key.
inline QString keyText(const ui::Commands& commands, const QString& id, std::size_t index) {
  const ui::Command* command = commands.find(id);
  if (!command || index >= command->keys.size()) return {};
  const ui::CommandKey& key = command->keys[index];
  return QKeySequence(int(key.modifiers) | key.key).toString(QKeySequence::NativeText);
}

}  // namespace insonate::train
