#pragma once

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAccessible>
#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QString>
#include <QTextDocumentFragment>
#include <QTextEdit>
#include <QToolButton>
#include <QWidget>
#include <vector>

namespace insonate::test {

struct VisibleText {
  QString where;  ///< object name or class, and what of it
  QString text;
};

namespace visible {

inline QString withoutTags(const QString& text) {
  return Qt::mightBeRichText(text) ? QTextDocumentFragment::fromHtml(text).toPlainText() : text;
}

inline void addModel(const QAbstractItemModel& model, const QString& name, std::vector<VisibleText>& texts) {
  for (int row = 0; row < model.rowCount(); ++row)
    for (int column = 0; column < model.columnCount(); ++column)
      for (const int role : {int(Qt::DisplayRole), int(Qt::ToolTipRole), int(Qt::AccessibleTextRole)})
        texts.push_back({name + " item", withoutTags(model.index(row, column).data(role).toString())});
}

inline void addMenu(const QMenu* menu, const QString& name, std::vector<VisibleText>& texts) {
  if (!menu) return;
  for (const QAction* action : menu->actions())
    for (const QString& text : {action->text(), action->toolTip()}) texts.push_back({name + " menu", text});
}

}  // namespace visible

/// Everything that `root` and what is seen in it say: texts, items of lists and choices, menus of buttons, tooltips,
/// titles, and names for a screen reader. What a widget paints by itself is in its accessible name.
inline std::vector<VisibleText> visibleTexts(QWidget& root) {
  std::vector<VisibleText> texts;
  QList<QWidget*> widgets = root.findChildren<QWidget*>();
  widgets.prepend(&root);
  for (QWidget* widget : widgets) {
    if (!widget->isVisible()) continue;
    const QString name = widget->objectName().isEmpty() ? widget->metaObject()->className() : widget->objectName();
    const auto add = [&](const char* what, const QString& text) {
      texts.push_back({name + ' ' + QLatin1String(what), visible::withoutTags(text)});
    };
    add("tooltip", widget->toolTip());
    add("status tip", widget->statusTip());
    add("what's this", widget->whatsThis());
    add("title", widget->windowTitle());
    add("name", widget->accessibleName());
    add("description", widget->accessibleDescription());
    if (auto* said = QAccessible::queryAccessibleInterface(widget)) {
      add("spoken name", said->text(QAccessible::Name));
      add("spoken value", said->text(QAccessible::Value));
    }
    if (auto* label = qobject_cast<QLabel*>(widget)) add("text", label->text());
    if (auto* edit = qobject_cast<QTextEdit*>(widget)) add("text", edit->toPlainText());
    if (auto* button = qobject_cast<QAbstractButton*>(widget)) add("text", button->text());
    if (auto* button = qobject_cast<QPushButton*>(widget)) visible::addMenu(button->menu(), name, texts);
    if (auto* button = qobject_cast<QToolButton*>(widget)) visible::addMenu(button->menu(), name, texts);
    if (auto* line = qobject_cast<QLineEdit*>(widget)) add("text", line->text() + ' ' + line->placeholderText());
    if (auto* box = qobject_cast<QComboBox*>(widget)) visible::addModel(*box->model(), name, texts);
    if (auto* view = qobject_cast<QAbstractItemView*>(widget); view && view->model())
      visible::addModel(*view->model(), name, texts);
  }
  return texts;
}

}  // namespace insonate::test
