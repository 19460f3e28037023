#include <insonate/ui/FileDialogTraces.h>

#include <QApplication>
#include <QEvent>
#include <QFileDialog>
#include <QSettings>

namespace insonate::ui {
namespace {

void removeTraces() {
  QSettings toolkit(QSettings::UserScope, QStringLiteral("QtProject"));
  for (const char* place : {"FileDialog/history", "FileDialog/lastVisited"}) toolkit.remove(QLatin1String(place));
}

/// A widget is polished once, before it is shown first; a dialog stores its folders in its destructor, before
/// destroyed() is emitted.
class DialogWatch : public QObject {
 public:
  using QObject::QObject;

  bool eventFilter(QObject* object, QEvent* event) override {
    if (event->type() == QEvent::Polish && qobject_cast<QFileDialog*>(object))
      connect(object, &QObject::destroyed, this, removeTraces);
    return false;
  }
};

}  // namespace

void removeFileDialogTraces(QApplication& application) {
  application.installEventFilter(new DialogWatch(&application));
}

}  // namespace insonate::ui
