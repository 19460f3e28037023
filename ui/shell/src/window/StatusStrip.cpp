#include "StatusStrip.h"

#include <insonate/ui/Theme.h>

#include <QDesktopServices>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QTimer>
#include <QToolButton>
#include <QUrl>

namespace insonate::ui {
namespace {

constexpr int kMessage_ms = 8000;
/// Time to reach the link with the pointer.
constexpr int kLink_ms = 30000;

}  // namespace

StatusStrip::StatusStrip(QWidget* parent)
    : QFrame(parent), text_(new QLabel), engine_(new QLabel), timer_(new QTimer(this)) {
  setRole(this, "footer");
  setRole(engine_, "quiet");
  text_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  engine_->setTextFormat(Qt::PlainText);
  setEngine({}, {});
  auto* help = new QToolButton;
  help->setIcon(icon(QStringLiteral("help")));
  help->setText(tr(" Help"));
  help->setAccessibleName(tr("Help"));
  help->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  // A click must leave the keyboard to the image.
  help->setFocusPolicy(Qt::TabFocus);
  help->setToolTip(tr("Help for this view (F1), all keys (?)"));

  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(kLargeGap, 2, kGap, 2);
  row->setSpacing(kLargeGap);
  row->addWidget(text_, 1);
  row->addWidget(engine_);
  row->addWidget(help);
  text_->installEventFilter(this);
  timer_->setSingleShot(true);
  connect(text_, &QLabel::linkActivated, this,
          [](const QString& folder) { QDesktopServices::openUrl(QUrl::fromLocalFile(folder)); });
  connect(timer_, &QTimer::timeout, this, [this] { write(standing_); });
  connect(help, &QToolButton::clicked, this, &StatusStrip::helpRequested);
}

void StatusStrip::setStanding(const QString& text) {
  standing_ = text;
  if (!timer_->isActive()) write(text);
}

void StatusStrip::showMessage(const QString& text, const QString& folder) {
  write(text, folder);
  timer_->start(folder.isEmpty() ? kMessage_ms : kLink_ms);
}

void StatusStrip::setEngine(const QString& text, const QString& note) {
  engine_->setText(text);
  const QString about =
      tr("Processor that computes the ultrasound image, frames in the last second, and time per frame");
  engine_->setToolTip(note.isEmpty() ? about : about + ".\n" + note);
}

QString StatusStrip::text() const {
  return written_;
}

void StatusStrip::write(const QString& text, const QString& folder) {
  written_ = text;
  const bool link = !folder.isEmpty();
  text_->setTextFormat(link ? Qt::RichText : Qt::PlainText);
  text_->setTextInteractionFlags(link ? Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard
                                      : Qt::NoTextInteraction);
  if (link)
    text_->setText(QStringLiteral("%1 &nbsp;<a href=\"%2\">%3</a>")
                       .arg(text.toHtmlEscaped(), folder.toHtmlEscaped(), tr("Open folder")));
  else
    elide();
  text_->setToolTip(link ? QStringLiteral("%1\n%2").arg(text, folder) : text);
}

/// Cuts a long text with an ellipsis; the tooltip has all of it.
void StatusStrip::elide() {
  text_->setText(text_->fontMetrics().elidedText(written_, Qt::ElideRight, text_->width()));
}

bool StatusStrip::eventFilter(QObject* watched, QEvent* event) {
  if (watched == text_ && event->type() == QEvent::Resize && text_->textFormat() == Qt::PlainText) elide();
  return QFrame::eventFilter(watched, event);
}

}  // namespace insonate::ui
