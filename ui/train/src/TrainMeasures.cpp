// The part of the workspace that measures, on the picture and on slices of the CT.
#include "TrainParts.h"
#include "image/CineBar.h"
#include "image/CtBeside.h"
#include "image/ImageInput.h"
#include "image/SliceMeasure.h"
#include "scene/PatientViews.h"

#include <insonate/ui/ViewWidget.h>

namespace insonate::train {

void TrainWorkspace::Parts::showCallipers() {
  image_->setCallipers(input_->callipers().callipers());
}

void TrainWorkspace::Parts::chooseCalliper(int kind) {
  const auto chosen = input_->callipers().kind();
  const bool off = kind < 0 || (chosen && int(*chosen) == kind);
  const auto next = off ? std::nullopt : std::optional(views::CalliperKind(kind));
  input_->callipers().setKind(next);
  for (SliceMeasure* slice : {measureSlice_, measureBeside_}) slice->setKind(next);
  cine_->setCalliper(off ? -1 : kind);
  for (ui::ViewWidget* view : {imageWidget_, &beside_->widget(), &patient->mprWidget()})
    view->focusProxy()->setCursor(off ? Qt::ArrowCursor : Qt::CrossCursor);
  showCallipers();
  session.say(off ? tr("Drag on the image to slide the probe. Keys: ?")
                  : tr("Click on image or CT from point to point, or drag."));
}

void TrainWorkspace::Parts::clearCallipers() {
  struct Measures {
    std::vector<views::Calliper> picture;
    std::vector<views::SliceCalliper> slice, beside;
  };
  const auto exchange = [this, other = Measures{}]() mutable {
    Measures now{input_->callipers().done(), measureSlice_->callipers(), measureBeside_->callipers()};
    input_->callipers().setDone(std::move(other.picture));
    measureSlice_->setCallipers(std::move(other.slice));
    measureBeside_->setCallipers(std::move(other.beside));
    other = std::move(now);
    showCallipers();
    return true;
  };
  const bool any = !input_->callipers().done().empty() || !measureSlice_->callipers().empty() ||
                   !measureBeside_->callipers().empty();
  History::Exchange clear = exchange;
  clear();
  if (any) session.history().add(tr("removal of the measurements").toStdString(), std::move(clear));
}

}  // namespace insonate::train
