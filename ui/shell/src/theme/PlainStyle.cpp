#include "PlainStyle.h"

#include <QLabel>

namespace insonate::ui {
namespace {

/// Minimum width of a wrapping label, equal for short and long words.
constexpr int kLeastWrapped_px = 40;

}  // namespace

void PlainStyle::polish(QWidget* widget) {
  // Tooltips and the text of a message box are labels, too.
  if (auto* label = qobject_cast<QLabel*>(widget)) {
    if (label->textFormat() == Qt::AutoText) label->setTextFormat(Qt::PlainText);
    if (label->wordWrap() && label->minimumWidth() == 0) label->setMinimumWidth(kLeastWrapped_px);
  }
  QProxyStyle::polish(widget);
}

}  // namespace insonate::ui
