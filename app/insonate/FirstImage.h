#pragma once

#include <QObject>
#include <functional>

namespace insonate::ui {
class MainWindow;
}

namespace insonate::app {

/// Milliseconds since this process was started, to a hundredth of a second: loading the program counts.
double sinceStart_ms();

/// Tells when the first live image is on the screen.
class FirstImage : public QObject {
 public:
  /// `there` is called once, later.
  FirstImage(ui::MainWindow& window, std::function<void()> there);

 private:
  void look();

  ui::MainWindow& window_;
  std::function<void()> there_;
  QMetaObject::Connection drawing_;
};

}  // namespace insonate::app
