#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <functional>

namespace insonate::ui {
class MainWindow;
}

namespace insonate::app {

/// Waits until the window shows the case, writes a screenshot of the window, and reports the result.
class Screenshot : public QObject {
 public:
  /// `done` receives an empty string or, if no image was written, an error message.
  Screenshot(ui::MainWindow& window, const QString& file, std::function<void(const QString& error)> done);

 private:
  void look();
  void take();

  ui::MainWindow& window_;
  QString file_;
  std::function<void(const QString&)> done_;
  QTimer patience_, settling_;
};

}  // namespace insonate::app
