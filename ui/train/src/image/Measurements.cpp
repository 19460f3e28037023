#include "Measurements.h"

#include "../model/History.h"
#include "../model/StatusLine.h"
#include "CineBar.h"
#include "ImageInput.h"
#include "SliceMeasure.h"

#include <insonate/ui/ViewWidget.h>

#include <algorithm>
#include <utility>

namespace insonate::train {

Measurements::Measurements(StatusLine& status, History& history, SharedViews& views, ImageInput& input, CineBar& cine,
                           QObject* parent)
    : QObject(parent), status_(status), history_(history), views_(views), input_(input), cine_(cine) {
  for (const SharedViews::Slice& slice : views_.slices()) addSlice(slice);
  connect(&views_, &SharedViews::sliceAdded, this, [this](const SharedViews::Slice& slice) { addSlice(slice); });
  input_.setMeasured([this] { show(); });
}

void Measurements::addSlice(const SharedViews::Slice& slice) {
  slices_.push_back(new SliceMeasure(*slice.view, *slice.widget->focusProxy(), this));
}

bool Measurements::isMeasuring() const {
  return input_.calipers().kind().has_value();
}

void Measurements::show() {
  views_.image().setCalipers(input_.calipers().calipers());
}

void Measurements::choose(int kind) {
  const auto chosen = input_.calipers().kind();
  const bool off = kind < 0 || (chosen && int(*chosen) == kind);
  const auto next = off ? std::nullopt : std::optional(views::CaliperKind(kind));
  input_.calipers().setKind(next);
  for (SliceMeasure* slice : slices_) slice->setKind(next);
  cine_.setCaliper(off ? -1 : kind);
  const Qt::CursorShape cursor = off ? Qt::ArrowCursor : Qt::CrossCursor;
  views_.imageWidget().focusProxy()->setCursor(cursor);
  for (const SharedViews::Slice& slice : views_.slices()) slice.widget->focusProxy()->setCursor(cursor);
  show();
  status_.setHint(off ? QString()
                      : tr("To measure, click from point to point on image or CT, or drag. Esc ends measuring."));
}

void Measurements::clear() {
  struct Measures {
    std::vector<views::Caliper> image;
    std::vector<std::vector<views::SliceCaliper>> slices;
  };
  const auto exchange = [this, other = Measures{}]() mutable {
    other.slices.resize(slices_.size());
    Measures now{input_.calipers().done(), {}};
    input_.calipers().setDone(std::move(other.image));
    for (std::size_t n = 0; n < slices_.size(); ++n) {
      now.slices.push_back(slices_[n]->calipers());
      slices_[n]->setCalipers(std::move(other.slices[n]));
    }
    other = std::move(now);
    show();
  };
  const bool any = !input_.calipers().done().empty() ||
                   std::ranges::any_of(slices_, [](const auto* slice) { return !slice->calipers().empty(); });
  History::Exchange clear = exchange;
  clear();
  if (any) history_.add(tr("removal of all measurements"), std::move(clear));
}

void Measurements::clearImage() {
  input_.calipers().clear();
  show();
}

void Measurements::forget() {
  for (SliceMeasure* slice : slices_) slice->setCalipers({});
  clearImage();
}

}  // namespace insonate::train
