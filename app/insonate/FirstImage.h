#pragma once

#include <QObject>
#include <functional>

namespace insonate::ui {
class MainWindow;
}

namespace insonate::app {

/// Milliseconds since this process started, including the loading of the program; resolution 10 ms.
double sinceStart_ms();

/// Reports when the first live image is on the screen.
class FirstImage : public QObject {
 public:
  /// `there` is called once, after the constructor has returned.
  FirstImage(ui::MainWindow& window, std::function<void()> there);

 private:
  void look();

  ui::MainWindow& window_;
  std::function<void()> there_;
  QMetaObject::Connection drawing_;
};

}  // namespace insonate::app
