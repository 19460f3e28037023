#include "FirstImage.h"

#include <insonate/ui/MainWindow.h>
#include <insonate/ui/ViewWidget.h>

#include <unistd.h>

#include <ctime>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>

namespace insonate::app {

double sinceStart_ms() {
  // Format by proc(5): the 22nd word is the start in ticks since boot; the second, the name, may contain blanks.
  std::ifstream in("/proc/self/stat");
  std::string text;
  std::getline(in, text);
  std::istringstream words(text.substr(text.rfind(')') + 1));
  double start_ticks = 0;
  std::string word;
  for (int n = 3; n <= 21; ++n) words >> word;
  words >> start_ticks;
  timespec now{};
  clock_gettime(CLOCK_BOOTTIME, &now);
  return double(now.tv_sec) * 1e3 + double(now.tv_nsec) * 1e-6 - start_ticks * 1e3 / double(sysconf(_SC_CLK_TCK));
}

FirstImage::FirstImage(ui::MainWindow& window, std::function<void()> there)
    : window_(window), there_(std::move(there)) {
  connect(&window_, &ui::MainWindow::readyChanged, this, [this] { look(); });
}

void FirstImage::look() {
  auto* picture = window_.findChild<ui::ViewWidget*>(QStringLiteral("ultrasoundView"));
  if (!there_ || drawing_ || !picture || !window_.isReady()) return;
  drawing_ = connect(
      picture, &ui::ViewWidget::rendered, this,
      [this] {
        disconnect(drawing_);
        if (const auto there = std::exchange(there_, nullptr)) there();
      },
      Qt::QueuedConnection);
}

}  // namespace insonate::app
