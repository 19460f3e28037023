#include <insonate/ui/CanvasInput.h>

#include <QEvent>
#include <QWidget>
#include <algorithm>

namespace insonate::ui {

CanvasInput::CanvasInput(QWidget& canvas) : QObject(&canvas) {
  canvas.installEventFilter(this);
}

CanvasInput& CanvasInput::of(QWidget& canvas) {
  auto* made = canvas.findChild<CanvasInput*>(QString(), Qt::FindDirectChildrenOnly);
  return made ? *made : *new CanvasInput(canvas);
}

void CanvasInput::add(InputRank rank, QObject& handler) {
  if (std::ranges::any_of(entries_, [&handler](const Entry& one) { return one.handler == &handler; })) return;
  entries_.insert(std::ranges::upper_bound(entries_, rank, {}, &Entry::rank), {rank, &handler});
}

void CanvasInput::remove(QObject& handler) {
  std::erase_if(entries_, [&handler](const Entry& one) { return one.handler == &handler; });
}

bool CanvasInput::eventFilter(QObject* canvas, QEvent* event) {
  // A handler may add or remove handlers, or be deleted by what it does.
  const std::vector<Entry> now = entries_;
  const QPointer<CanvasInput> self = this;
  for (const Entry& one : now) {
    if (one.handler && one.handler->eventFilter(canvas, event)) return true;
    if (!self) return true;
  }
  return false;
}

}  // namespace insonate::ui
