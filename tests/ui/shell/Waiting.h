#pragma once

#include <ui/support/Patience.h>

#include <QString>
#include <functional>

class QTemporaryDir;
class QWidget;

namespace insonate::test {

/// Lets the window live until the condition holds; false when it does not within the time.
bool waitUntil(const std::function<bool()>& condition, int longest_ms = kPatience_ms);

/// Writes tests/support/SmallCase.h to a folder of that name in `home`; the folder's path.
QString writtenSmallCase(const QTemporaryDir& home, const QString& name);

/// Types this name into the next dialog of `window` that asks for a file or folder, and accepts it.
void answerFileDialog(QWidget& window, const QString& name);

}  // namespace insonate::test
