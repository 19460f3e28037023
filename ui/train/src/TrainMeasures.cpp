// The part of the workspace that measures, on the image and on slices of the CT.
#include "TrainParts.h"
#include "image/CineBar.h"
#include "image/CtBeside.h"
#include "image/ImageInput.h"
#include "image/SliceMeasure.h"
#include "patient3d/FourSlices.h"
#include "patient3d/PatientViews.h"

#include <insonate/ui/ViewWidget.h>

#include <algorithm>

namespace insonate::train {

void TrainWorkspace::Parts::showCallipers() {
  image_->setCallipers(input_->callipers().callipers());
}

void TrainWorkspace::Parts::chooseCalliper(int kind) {
  const auto chosen = input_->callipers().kind();
  const bool off = kind < 0 || (chosen && int(*chosen) == kind);
  const auto next = off ? std::nullopt : std::optional(views::CalliperKind(kind));
  input_->callipers().setKind(next);
  for (SliceMeasure* slice : measureSlices_) slice->setKind(next);
  cine_->setCalliper(off ? -1 : kind);
  std::vector<ui::ViewWidget*> views{imageWidget_, &beside_->widget(), &patient->mprWidget()};
  for (std::size_t n = 0; n < FourSlices::kCount; ++n) views.push_back(&patient->allSlices().widget(n));
  for (ui::ViewWidget* view : views) view->focusProxy()->setCursor(off ? Qt::ArrowCursor : Qt::CrossCursor);
  showCallipers();
  model.status.setHint(off ? QString() : tr("Click on image or CT from point to point, or drag. Esc ends measuring."));
}

void TrainWorkspace::Parts::clearCallipers() {
  struct Measures {
    std::vector<views::Calliper> picture;
    std::vector<std::vector<views::SliceCalliper>> slices;
  };
  const auto exchange = [this, other = Measures{}]() mutable {
    other.slices.resize(measureSlices_.size());
    Measures now{input_->callipers().done(), {}};
    input_->callipers().setDone(std::move(other.picture));
    for (std::size_t n = 0; n < measureSlices_.size(); ++n) {
      now.slices.push_back(measureSlices_[n]->callipers());
      measureSlices_[n]->setCallipers(std::move(other.slices[n]));
    }
    other = std::move(now);
    showCallipers();
    return true;
  };
  const bool any = !input_->callipers().done().empty() ||
                   std::ranges::any_of(measureSlices_, [](const auto* slice) { return !slice->callipers().empty(); });
  History::Exchange clear = exchange;
  clear();
  if (any) model.history.add(tr("removal of the measurements").toStdString(), std::move(clear));
}

}  // namespace insonate::train
