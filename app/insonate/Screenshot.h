#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <functional>

namespace insonate::ui {
class MainWindow;
}

namespace insonate::app {

/// Waits until the window shows the case, writes an image of it, and tells how that went.
class Screenshot : public QObject {
 public:
  /// `done` gets an empty string, or a sentence when there is no picture.
  Screenshot(ui::MainWindow& window, const QString& file, std::function<void(const QString& trouble)> done);

 private:
  void look();
  void take();

  ui::MainWindow& window_;
  QString file_;
  std::function<void(const QString&)> done_;
  QTimer patience_, settling_;
};

}  // namespace insonate::app
