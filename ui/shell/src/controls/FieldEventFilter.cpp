#include <insonate/ui/FieldEventFilter.h>

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QKeyEvent>
#include <QLineEdit>
#include <QScrollBar>
#include <QWheelEvent>

namespace insonate::ui {
namespace {

bool turnsWithTheWheel(const QWidget& widget) {
  return qobject_cast<const QAbstractSpinBox*>(&widget) || qobject_cast<const QComboBox*>(&widget) ||
         (qobject_cast<const QAbstractSlider*>(&widget) && !qobject_cast<const QScrollBar*>(&widget));
}

bool isTyped(const QWidget* widget) {
  return qobject_cast<const QLineEdit*>(widget) || qobject_cast<const QAbstractSpinBox*>(widget);
}

class FieldWatch : public QObject {
 public:
  using QObject::QObject;

  bool eventFilter(QObject* object, QEvent* event) override {
    auto* widget = qobject_cast<QWidget*>(object);
    if (!widget) return false;
    switch (event->type()) {
      case QEvent::Polish:
        // The wheel alone does not give a field the keyboard focus.
        if (widget->focusPolicy() == Qt::WheelFocus && turnsWithTheWheel(*widget))
          widget->setFocusPolicy(Qt::StrongFocus);
        return false;
      case QEvent::Wheel:
        return passesBy(*widget, *static_cast<QWheelEvent*>(event));
      case QEvent::MouseButtonPress:
        clicked(*widget);
        return false;
      case QEvent::KeyPress:
        typed(*widget, static_cast<QKeyEvent*>(event)->key());
        return false;
      default:
        return false;
    }
  }

 private:
  /// An ignored event goes on to the parent, the panel.
  static bool passesBy(const QWidget& widget, QWheelEvent& event) {
    if (!turnsWithTheWheel(widget) || widget.hasFocus() || event.modifiers() & Qt::ControlModifier) return false;
    event.ignore();
    return true;
  }

  /// Leaves widgets that take the focus by a click to themselves.
  static void clicked(const QWidget& widget) {
    QWidget* field = QApplication::focusWidget();
    if (!isTyped(field) || widget.window() != field->window() || widget.focusPolicy() & Qt::ClickFocus) return;
    if (&widget != field && !field->isAncestorOf(&widget)) field->clearFocus();
  }

  /// After the field has handled the key.
  static void typed(QWidget& widget, int key) {
    const bool ends = key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Escape;
    if (!ends || !isTyped(&widget) || qobject_cast<QDialog*>(widget.window())) return;
    QMetaObject::invokeMethod(
        &widget, [field = &widget] { field->clearFocus(); }, Qt::QueuedConnection);
  }
};

}  // namespace

void filterFieldEvents(QApplication& application) {
  application.installEventFilter(new FieldWatch(&application));
}

}  // namespace insonate::ui
