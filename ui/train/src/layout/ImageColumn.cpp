#include "ImageColumn.h"

#include <QVBoxLayout>

namespace insonate::train {

ImageColumn::ImageColumn(QWidget* parent) : QWidget(parent) {
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(0);
  for (QVBoxLayout*& slot : slots_) {
    slot = new QVBoxLayout;
    slot->setSpacing(0);
    box->addLayout(slot, slot == slots_[Image] ? 1 : 0);
  }
}

void ImageColumn::add(Slot slot, QWidget* widget) {
  slots_[slot]->addWidget(widget, slot == Image ? 1 : 0);
}

}  // namespace insonate::train
