#include <insonate/ui/ErrorPanel.h>
#include <insonate/ui/Theme.h>

#include <QAccessible>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QToolButton>

namespace insonate::ui {
namespace {

QLabel* wrapped(const char* role) {
  auto* label = new QLabel;
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  setRole(label, role);
  return label;
}

}  // namespace

ErrorPanel::ErrorPanel(QWidget* parent)
    : QFrame(parent),
      what_(wrapped("heading")),
      advice_(wrapped("")),
      details_(wrapped("quiet")),
      more_(new QToolButton),
      close_(new QToolButton) {
  setObjectName(QStringLiteral("errorPanel"));
  more_->setText(tr("Details"));
  more_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  more_->setCheckable(true);
  more_->setToolTip(tr("Details of the error"));
  close_->setIcon(icon(QStringLiteral("close")));
  close_->setAccessibleName(tr("Close this message"));
  close_->setToolTip(tr("Close (Esc)"));
  auto* sign = new QLabel;
  sign->setPixmap(icon(QStringLiteral("warning"), views::theme::kDanger).pixmap(20, 20));
  sign->setAccessibleName(tr("Error"));

  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(kLargeGap - 4, kGap, kGap, kGap);
  grid->setHorizontalSpacing(kGap);
  grid->setVerticalSpacing(kSmallGap);
  grid->addWidget(sign, 0, 0, Qt::AlignTop);
  grid->addWidget(what_, 0, 1);
  grid->addWidget(more_, 0, 2, Qt::AlignTop);
  grid->addWidget(close_, 0, 3, Qt::AlignTop);
  grid->addWidget(advice_, 1, 1);
  grid->addWidget(details_, 2, 1);
  grid->setColumnStretch(1, 1);
  connect(more_, &QToolButton::toggled, this, &ErrorPanel::fold);
  connect(close_, &QToolButton::clicked, this, &ErrorPanel::dismiss);
  hide();
}

void ErrorPanel::showError(const QString& what, const QString& advice, const QString& details) {
  const int lineEnd = what.indexOf(QLatin1Char('\n'));
  QString folded = lineEnd < 0 ? QString() : what.mid(lineEnd + 1);
  if (!details.isEmpty()) folded += (folded.isEmpty() ? QString() : QStringLiteral("\n")) + details;
  what_->setText(lineEnd < 0 ? what : what.left(lineEnd));
  advice_->setText(advice);
  advice_->setVisible(!advice.isEmpty());
  details_->setText(folded);
  more_->setVisible(!folded.isEmpty());
  more_->setChecked(false);
  fold(false);
  setAccessibleName(message());
  show();
  QAccessibleEvent alert(this, QAccessible::Alert);
  QAccessible::updateAccessibility(&alert);
}

void ErrorPanel::dismiss() {
  hide();
}

QString ErrorPanel::message() const {
  return advice_->text().isEmpty() ? what_->text() : what_->text() + QLatin1Char(' ') + advice_->text();
}

QString ErrorPanel::details() const {
  return details_->text();
}

void ErrorPanel::fold(bool open) {
  details_->setVisible(open);
  more_->setIcon(icon(open ? QStringLiteral("down") : QStringLiteral("right")));
}

void ErrorPanel::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape)
    dismiss();
  else
    QFrame::keyPressEvent(event);
}

}  // namespace insonate::ui
