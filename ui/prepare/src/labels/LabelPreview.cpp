#include "LabelPreview.h"

#include <QFutureWatcher>
#include <QtConcurrent/QtConcurrentRun>
#include <exception>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

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

/// Unused proposals, for reuse: a proposal for a whole CT takes tens of megabytes, and allocating this memory takes
/// longer than filling it by a threshold.
struct LabelPreview::Buffers {
  std::mutex mutex;
  std::vector<std::unique_ptr<Proposal>> free;
};

LabelPreview::LabelPreview(QObject* parent) : QObject(parent), buffers_(std::make_shared<Buffers>()) {}

LabelPreview::~LabelPreview() {
  if (stop_) *stop_ = true;
}

/// The thread that releases the proposal last returns its memory, or frees it if clear() was called meanwhile.
std::shared_ptr<Proposal> LabelPreview::takeBuffer() {
  std::unique_ptr<Proposal> one;
  {
    const std::lock_guard lock(buffers_->mutex);
    if (!buffers_->free.empty()) {
      one = std::move(buffers_->free.back());
      buffers_->free.pop_back();
    }
  }
  if (!one) one = std::make_unique<Proposal>();
  return {one.release(), [buffers = std::weak_ptr(buffers_)](Proposal* back) {
            std::unique_ptr<Proposal> held(back);
            const auto there = buffers.lock();
            if (!there) return;
            const std::lock_guard lock(there->mutex);
            there->free.push_back(std::move(held));
          }};
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
  buffers_ = std::make_shared<Buffers>();
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
  watcher->setFuture(QtConcurrent::run([wish = std::move(wish), into = takeBuffer(), stop = stop_] {
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
