#pragma once

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

namespace insonate::ui {

/// Sets the name for tests, what screen readers say and what the pointer shows.
template <class Widget>
Widget* named(Widget* widget, const char* object, const QString& name, const QString& tip) {
  widget->setObjectName(QLatin1String(object));
  widget->setAccessibleName(name);
  widget->setToolTip(tip);
  return widget;
}

/// Words which break their lines. Plain text: names and texts of people and files go in as they are.
QLabel* paragraph(const char* object = "", const char* role = "", const QString& words = {});

/// One line, in the weight of a heading.
QLabel* heading(const QString& words);

/// Makes a push button that Enter in a field of a dialog does not press. With Qt::TabFocus a click does not take the
/// keyboard focus from the image.
QPushButton* pushButton(const char* object, const QString& words, const QString& tip,
                        Qt::FocusPolicy focus = Qt::StrongFocus);

/// One of a row of pages.
QToolButton* tabButton(const char* object, const QString& words, const QString& tip);

/// No wider than it is given room for; the wheel scrolls past it, see QuietWheel.
QComboBox* choiceBox(const char* object, const QString& name, const QString& tip,
                     Qt::FocusPolicy focus = Qt::StrongFocus);

}  // namespace insonate::ui
