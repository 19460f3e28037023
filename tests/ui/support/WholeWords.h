#pragma once

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QComboBox>
#include <QPushButton>
#include <QStyle>
#include <QStyleOptionButton>
#include <QStyleOptionComboBox>
#include <QToolButton>
#include <string>

namespace insonate::test {

/// Width that a choice has for words; a longer text is cut.
inline int roomForWords(const QComboBox& box) {
  QStyleOptionComboBox option;
  option.initFrom(&box);
  option.editable = box.isEditable();
  return box.style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &box).width();
}

/// Width that a button has for words: a QPushButton has its padding beside them.
inline int roomForWords(const QAbstractButton& button) {
  if (!qobject_cast<const QPushButton*>(&button)) return button.width() - 4;
  QStyleOptionButton option;
  option.initFrom(&button);
  return button.style()->subElementRect(QStyle::SE_PushButtonContents, &option, &button).width();
}

/// No choice and no button that is seen in `root` cuts its words; how many were looked at.
inline int expectWholeWords(QWidget* root) {
  int seen = 0;
  for (auto* box : root->findChildren<QComboBox*>()) {
    if (!box->isVisible() || box->currentText().isEmpty()) continue;
    ++seen;
    EXPECT_GE(roomForWords(*box), box->fontMetrics().horizontalAdvance(box->currentText()))
        << box->objectName().toStdString() << ": " << box->currentText().toStdString();
  }
  for (auto* button : root->findChildren<QAbstractButton*>()) {
    if (!button->isVisible() || button->text().isEmpty()) continue;
    if (auto* tool = qobject_cast<QToolButton*>(button); tool && tool->toolButtonStyle() == Qt::ToolButtonIconOnly)
      continue;
    ++seen;
    EXPECT_GE(roomForWords(*button), button->fontMetrics().horizontalAdvance(button->text()))
        << button->objectName().toStdString() << ": " << button->text().toStdString();
  }
  return seen;
}

}  // namespace insonate::test
