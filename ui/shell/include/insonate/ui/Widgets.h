#pragma once

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

namespace insonate::ui {

/// Sets a widget's object name, which tests use, its name for screen readers, and its tooltip.
template <class Widget>
Widget* named(Widget* widget, const char* object, const QString& name, const QString& tip) {
  widget->setObjectName(QLatin1String(object));
  widget->setAccessibleName(name);
  widget->setToolTip(tip);
  return widget;
}

/// Makes a label that wraps its text. The text is not interpreted as rich text, so that names and texts of users are
/// shown unchanged.
QLabel* paragraph(const char* object = "", const char* role = "", const QString& words = {});

/// Makes a label of one line with the font weight of a heading.
QLabel* heading(const QString& words);

/// Makes a push button that is not a default button: Enter in a field of a dialog does not press the button. With
/// Qt::TabFocus, a click on the button does not take the keyboard focus from the image.
QPushButton* pushButton(const char* object, const QString& words, const QString& tip,
                        Qt::FocusPolicy focus = Qt::StrongFocus);

/// Makes a tab button, which selects one of several pages.
QToolButton* tabButton(const char* object, const QString& words, const QString& tip);

/// Makes a combo box that shrinks to the available width. The wheel changes it only while it has the keyboard focus
/// (FieldEventFilter.h).
QComboBox* choiceBox(const char* object, const QString& name, const QString& tip,
                     Qt::FocusPolicy focus = Qt::StrongFocus);

}  // namespace insonate::ui
