#include "StatusStrip.h"

#include <insonate/ui/Theme.h>

#include <QHBoxLayout>
#include <QLabel>
#include <QTimer>
#include <QToolButton>

namespace insonate::ui {
namespace {

constexpr int kSaid_ms = 8000;

}  // namespace

StatusStrip::StatusStrip(QWidget* parent)
    : QFrame(parent), text_(new QLabel), engine_(new QLabel), timer_(new QTimer(this)) {
  setRole(this, "footer");
  setRole(engine_, "quiet");
  text_->setTextFormat(Qt::PlainText);
  text_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  engine_->setTextFormat(Qt::PlainText);
  engine_->setToolTip(tr("What computes the ultrasound, and how many pictures it made in the last second"));
  auto* help = new QToolButton;
  help->setIcon(icon(QStringLiteral("help")));
  help->setText(tr(" Help"));
  help->setAccessibleName(tr("Help"));
  help->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  help->setFocusPolicy(Qt::StrongFocus);
  help->setToolTip(tr("Help for what is shown (F1), all keys (?)"));

  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(kLargeGap, 2, kGap, 2);
  row->setSpacing(kLargeGap);
  row->addWidget(text_, 1);
  row->addWidget(engine_);
  row->addWidget(help);
  timer_->setSingleShot(true);
  connect(timer_, &QTimer::timeout, this, [this] { write(standing_); });
  connect(help, &QToolButton::clicked, this, &StatusStrip::helpWanted);
}

void StatusStrip::setStanding(const QString& text) {
  standing_ = text;
  if (!timer_->isActive()) write(text);
}

void StatusStrip::say(const QString& text) {
  write(text);
  timer_->start(kSaid_ms);
}

void StatusStrip::setEngine(const QString& text) {
  engine_->setText(text);
}

QString StatusStrip::text() const {
  return text_->text();
}

void StatusStrip::write(const QString& text) {
  text_->setText(text);
  text_->setToolTip(text);
}

}  // namespace insonate::ui
