#include "SharedViews.h"

#include <insonate/ui/CanvasInput.h>
#include <insonate/ui/Commands.h>
#include <insonate/ui/ViewKeys.h>
#include <insonate/ui/ViewWidget.h>

#include <utility>

namespace insonate::train {
namespace {

/// Offers the keys of a canvas to the commands. The view's own keys stay with the view, and away from the window's
/// shortcuts.
class CanvasKeys final : public QObject {
 public:
  CanvasKeys(const ui::Commands& commands, SharedViews::OwnKeys ownKeys, QWidget& canvas)
      : QObject(&canvas), commands_(commands), ownKeys_(std::move(ownKeys)) {}

  bool eventFilter(QObject* /*canvas*/, QEvent* event) override {
    return ui::handleViewKey(*event, [this](const QKeyEvent& pressed, bool isPerformed) {
      if (ownKeys_ && ownKeys_(pressed)) return !isPerformed;
      return commands_.key(pressed, isPerformed);
    });
  }

 private:
  const ui::Commands& commands_;
  SharedViews::OwnKeys ownKeys_;
};

}  // namespace

SharedViews::SharedViews(const ui::Commands& commands, QWidget& parent)
    : QObject(&parent),
      commands_(commands),
      image_(std::make_shared<views::UltrasoundView>()),
      imageWidget_(new ui::ViewWidget(image_, tr("Ultrasound image"), &parent)) {
  imageWidget_->setObjectName("ultrasoundView");
  imageWidget_->setMaximizeOnDoubleClick(false);
  add(*imageWidget_);
}

void SharedViews::addSlice(const Slice& slice, OwnKeys ownKeys) {
  slices_.push_back(slice);
  add(*slice.widget, std::move(ownKeys));
  Q_EMIT sliceAdded(slice);
}

void SharedViews::add(ui::ViewWidget& widget, OwnKeys ownKeys) {
  widgets_.push_back(&widget);
  QWidget& canvas = *widget.focusProxy();
  ui::CanvasInput::of(canvas).add(ui::InputRank::Commands, *new CanvasKeys(commands_, std::move(ownKeys), canvas));
}

void SharedViews::restoreSizes() {
  for (ui::ViewWidget* widget : widgets_) widget->setMaximized(false);
}

void SharedViews::setBounds(Bounds bounds) {
  bounds_ = std::move(bounds);
  Q_EMIT boundsChanged();
}

std::optional<views::ImageBounds> SharedViews::boundsFor(const views::ImageBounds& fieldOfView) const {
  return bounds_ ? bounds_(fieldOfView) : fieldOfView;
}

}  // namespace insonate::train
