#include "Notice.h"

namespace insonate::prepare {

Notice::Notice(QObject* parent) : QObject(parent) {
  shown_.setSingleShot(true);
  shown_.setInterval(kShown_ms);
  connect(&shown_, &QTimer::timeout, this, [this] {
    text_.clear();
    Q_EMIT changed();
  });
}

void Notice::showMessage(const QString& sentence) {
  shown_.start();
  text_ = sentence;
  Q_EMIT changed();
}

}  // namespace insonate::prepare
