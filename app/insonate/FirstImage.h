#pragma once

#include <QObject>
#include <functional>

namespace insonate::ui {
class MainWindow;
}

namespace insonate::app {

/// Returns the milliseconds since this process started, including the loading of the program; resolution 10 ms.
double sinceStart_ms();

/// Calls a function when the first live ultrasound image is on the screen.
class FirstImage : public QObject {
 public:
  /// Waits for the first image; then `there` is called once, never before the constructor has returned.
  FirstImage(ui::MainWindow& window, std::function<void()> there);

 private:
  void look();

  ui::MainWindow& window_;
  std::function<void()> there_;
  QMetaObject::Connection drawing_;
};

}  // namespace insonate::app
