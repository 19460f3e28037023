#include "PlainStyle.h"

#include <QLabel>

namespace insonate::ui {
namespace {

/// Of a label that wraps: no narrower for a short word, and no wider for one without an end.
constexpr int kLeastWrapped_px = 40;

}  // namespace

void PlainStyle::polish(QWidget* widget) {
  // A tooltip and the text of a message box are labels, too.
  if (auto* label = qobject_cast<QLabel*>(widget)) {
    if (label->textFormat() == Qt::AutoText) label->setTextFormat(Qt::PlainText);
    if (label->wordWrap() && label->minimumWidth() == 0) label->setMinimumWidth(kLeastWrapped_px);
  }
  QProxyStyle::polish(widget);
}

}  // namespace insonate::ui
