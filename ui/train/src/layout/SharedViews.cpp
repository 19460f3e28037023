#include "SharedViews.h"

#include <insonate/ui/ViewWidget.h>

#include <utility>

namespace insonate::train {

SharedViews::SharedViews(QWidget& parent)
    : QObject(&parent),
      image_(std::make_shared<views::UltrasoundView>()),
      imageWidget_(new ui::ViewWidget(image_, tr("Ultrasound image"), &parent)),
      widgets_{imageWidget_} {
  imageWidget_->setObjectName("ultrasoundView");
  imageWidget_->setMaximiseOnDoubleClick(false);
}

void SharedViews::addSlice(const Slice& slice) {
  slices_.push_back(slice);
  add(*slice.widget);
  Q_EMIT sliceAdded(slice);
}

void SharedViews::add(ui::ViewWidget& widget) {
  widgets_.push_back(&widget);
  Q_EMIT added(&widget);
}

void SharedViews::restoreSizes() {
  for (ui::ViewWidget* widget : widgets_) widget->setMaximised(false);
}

void SharedViews::setBounds(Bounds bounds) {
  bounds_ = std::move(bounds);
  Q_EMIT boundsChanged();
}

std::optional<views::PictureBounds> SharedViews::boundsFor(const views::PictureBounds& fieldOfView) const {
  return bounds_ ? bounds_(fieldOfView) : fieldOfView;
}

}  // namespace insonate::train
