#include "LabelPreview.h"

#include <QFutureWatcher>
#include <QtConcurrent/QtConcurrentRun>
#include <exception>
#include <string>
#include <utility>

namespace insonate::prepare {
namespace {

Result<std::shared_ptr<const Proposal>> proposed(const LabelStep& step, const CtVolume& ct, const LabelMap& labels,
                                                 std::shared_ptr<Proposal> into, const std::atomic<bool>& stop) {
  try {
    const auto made = preview(step, ct, labels, *into, [&stop](std::string_view, double) { return !stop; });
    if (!made) return tl::unexpected(made.error());
    return into;
  } catch (const std::exception& error) {
    return fail("There is not enough memory for this preview (" + std::string(error.what()) +
                "); close other programs.");
  }
}

}  // namespace

LabelPreview::~LabelPreview() {
  if (stop_) *stop_ = true;
}

void LabelPreview::want(LabelStep step, std::shared_ptr<const CtVolume> ct, std::shared_ptr<const LabelMap> labels) {
  next_ = Wish{std::move(step), std::move(ct), std::move(labels)};
  if (stop_)
    *stop_ = true;
  else
    begin(*std::exchange(next_, std::nullopt));
  setComputing(true);
}

void LabelPreview::clear() {
  ++number_;
  next_.reset();
  if (stop_) *stop_ = true;
  store_.forget();
  setComputing(false);
  if (!std::exchange(proposal_, nullptr)) return;
  Q_EMIT changed();
}

void LabelPreview::setComputing(bool computing) {
  if (computing != std::exchange(computing_, computing)) Q_EMIT computingChanged();
}

void LabelPreview::begin(Wish wish) {
  stop_ = std::make_shared<std::atomic<bool>>(false);
  auto* watcher = new QFutureWatcher<Made>(this);
  connect(watcher, &QFutureWatcher<Made>::finished, this, [this, watcher, number = number_, label = wish.step.label] {
    watcher->deleteLater();
    take(number, label, watcher->result());
  });
  watcher->setFuture(QtConcurrent::run([wish = std::move(wish), into = store_.take(), stop = stop_] {
    return proposed(wish.step, *wish.ct, *wish.labels, into, *stop);
  }));
}

void LabelPreview::take(int number, std::uint8_t label, const Made& made) {
  stop_ = nullptr;
  if (number == number_ && made) {
    proposal_ = *made;
    label_ = label;
    Q_EMIT changed();
  }
  if (next_) return begin(*std::exchange(next_, std::nullopt));
  setComputing(false);
  if (number != number_ || made) return;
  proposal_ = nullptr;
  Q_EMIT changed();
  if (made.error().message != kCancelled) Q_EMIT failed(QString::fromStdString(made.error().message));
}

}  // namespace insonate::prepare
