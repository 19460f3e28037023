#include "StatusLine.h"

namespace insonate::train {

StatusLine::StatusLine(QObject* parent) : QObject(parent) {
  said_.setSingleShot(true);
  said_.setInterval(kSaid_ms);
  connect(&said_, &QTimer::timeout, this, [this] {
    message_ = standing();
    Q_EMIT messageChanged();
  });
}

QString StatusLine::standing() const {
  if (const auto state = state_ ? state_() : std::nullopt) return *state;
  return hint_.isEmpty() ? tr("Drag on the image to slide the probe; + compresses, - releases. Press ? for all keys.")
                         : hint_;
}

void StatusLine::setHint(const QString& hint) {
  hint_ = hint;
  say(standing());
}

void StatusLine::say(const QString& sentence) {
  said_.start();
  if (sentence == message_) return;
  message_ = sentence;
  Q_EMIT messageChanged();
}

}  // namespace insonate::train
