#include "JobThreads.h"

#include <insonate/ui/LiveFeed.h>

#include <QCoreApplication>
#include <QEvent>

namespace insonate::ui {

LiveFeed::LiveFeed(std::function<void()> news, QObject* parent) : QObject(parent), news_(std::move(news)) {}

LiveFeed::~LiveFeed() {
  setImaging(nullptr);
}

void LiveFeed::setImaging(std::unique_ptr<LiveImaging> live) {
  // After this call no images are posted; posted images are dropped before the next probe starts.
  if (live_) {
    live_->setFrameListener({});
    // Its threads take a fraction of a second to end, too long for the window's thread.
    runInBackground([old = std::shared_ptr<LiveImaging>(std::move(live_))] {});
  }
  QCoreApplication::removePostedEvents(this, QEvent::User);
  posted_ = false;
  live_ = std::move(live);
  if (!live_) return;
  live_->setFrameListener([this] {
    if (!posted_.exchange(true)) QCoreApplication::postEvent(this, new QEvent(QEvent::User));
  });
}

bool LiveFeed::event(QEvent* event) {
  if (event->type() != QEvent::User) return QObject::event(event);
  posted_ = false;
  news_();
  return true;
}

}  // namespace insonate::ui
