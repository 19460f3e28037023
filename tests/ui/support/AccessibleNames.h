#pragma once

#include <insonate/ui/ViewWidget.h>

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAccessible>
#include <QComboBox>
#include <QLineEdit>
#include <QScrollBar>
#include <QTextBrowser>
#include <string>

namespace insonate::test {

/// Tells whether a user can act on a widget with mouse or keyboard; false for inner parts of Qt's own widgets.
inline bool isInteractive(const QWidget* widget) {
  if (qobject_cast<const QScrollBar*>(widget)) return false;
  const QByteArray name = widget->objectName().toLatin1();
  if (name.startsWith("qt_") || widget->inherits("QTableCornerButton") || widget->inherits("QHeaderView")) return false;
  for (const QWidget* outer = widget->parentWidget(); outer; outer = outer->parentWidget())
    if (qobject_cast<const QComboBox*>(outer)) return false;
  if (qobject_cast<const QAbstractButton*>(widget) || qobject_cast<const QAbstractSlider*>(widget) ||
      qobject_cast<const QLineEdit*>(widget) || qobject_cast<const QComboBox*>(widget) ||
      qobject_cast<const QAbstractItemView*>(widget))
    return true;
  return widget->focusPolicy() & Qt::TabFocus && !widget->focusProxy() && !widget->isWindow();
}

inline QString nameOf(QWidget* widget) {
  QAccessibleInterface* said = QAccessible::queryAccessibleInterface(widget);
  return said ? said->text(QAccessible::Name) : QString();
}

/// Tells whether the widget, or the control that it is a part of, has a tooltip.
inline bool hasToolTip(const QWidget* widget) {
  for (const QWidget* at = widget; at && !at->isWindow(); at = at->parentWidget())
    if (!at->toolTip().isEmpty()) return true;
  return false;
}

inline std::string what(const QWidget* widget) {
  return std::string(widget->metaObject()->className()) + " '" + widget->objectName().toStdString() + "' in " +
         (widget->parentWidget() ? widget->parentWidget()->metaObject()->className() : "nothing");
}

/// Returns their number.
inline int expectNames(QWidget* root, bool toolTips) {
  int seen = 0;
  for (QWidget* widget : root->findChildren<QWidget*>()) {
    if (!isInteractive(widget)) continue;
    ++seen;
    EXPECT_FALSE(nameOf(widget).trimmed().isEmpty()) << what(widget) << " has no name for a screen reader";
    const bool view = widget->parentWidget() && qobject_cast<ui::ViewWidget*>(widget->parentWidget());
    const bool text = qobject_cast<QTextBrowser*>(widget) || qobject_cast<QAbstractItemView*>(widget);
    EXPECT_TRUE(!toolTips || view || text || hasToolTip(widget)) << what(widget) << " has no tooltip";
  }
  return seen;
}

}  // namespace insonate::test
