#include "Screenshot.h"

#include <insonate/ui/MainWindow.h>
#include <insonate/ui/ViewWidget.h>

#include <QPixmap>

namespace insonate::app {
namespace {

constexpr int kTimeLimit_ms = 180'000;
/// Views are told what to show a moment after their data has come.
constexpr int kRedraw_ms = 1000;
/// Then they are drawn; after this they are asked again whether they are.
constexpr int kDraw_ms = 50;

}  // namespace

Screenshot::Screenshot(ui::MainWindow& window, const QString& file, std::function<void(const QString&)> done)
    : window_(window), file_(file), done_(std::move(done)) {
  patience_.setSingleShot(true);
  settling_.setSingleShot(true);
  connect(&patience_, &QTimer::timeout, this,
          [this] { done_(tr("The case did not appear in the window in time; no screenshot was written.")); });
  connect(&settling_, &QTimer::timeout, this, &Screenshot::take);
  connect(&window_, &ui::MainWindow::readyChanged, this, &Screenshot::look);
  patience_.start(kTimeLimit_ms);
  look();
}

void Screenshot::look() {
  if (!window_.isComplete())
    settling_.stop();
  else if (!settling_.isActive())
    settling_.start(kRedraw_ms);
}

void Screenshot::take() {
  for (const auto* view : window_.findChildren<ui::ViewWidget*>())
    if (view->isVisible() && view->isDrawing()) return settling_.start(kDraw_ms);
  patience_.stop();
  const bool written = window_.grab().save(file_, "PNG");
  done_(written ? QString()
                : tr("The screenshot could not be written to '%1'; choose a folder that exists.").arg(file_));
}

}  // namespace insonate::app
