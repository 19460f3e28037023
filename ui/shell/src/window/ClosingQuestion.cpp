#include "ClosingQuestion.h"

#include <insonate/ui/Theme.h>

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace insonate::ui {
namespace {

constexpr int kText_px = 420;

}  // namespace

ClosingQuestion::ClosingQuestion(const QString& job, QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("Close Insonate"));
  setAttribute(Qt::WA_DeleteOnClose);
  auto* title = new QLabel(tr("Something is still being done"));
  setRole(title, "title");
  auto* text = new QLabel(tr("%1: closing stops it, and leaves nothing half done behind.").arg(job));
  text->setTextFormat(Qt::PlainText);
  text->setWordWrap(true);
  text->setMinimumWidth(kText_px);

  auto* leave = new QPushButton(tr("Stop and close"));
  leave->setToolTip(tr("Close the window now"));
  auto* stay = new QPushButton(tr("Keep working"));
  stay->setToolTip(tr("Back to the window (Esc)"));
  setRole(stay, "primary");
  stay->setDefault(true);
  connect(stay, &QPushButton::clicked, this, &QDialog::reject);
  connect(leave, &QPushButton::clicked, this, [this] {
    accept();
    Q_EMIT closeChosen();
  });
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(kGap);
  buttons->addStretch();
  buttons->addWidget(leave);
  buttons->addWidget(stay);

  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(kLargeGap, kLargeGap, kLargeGap, kLargeGap);
  column->setSpacing(kLargeGap);
  column->addWidget(title);
  column->addWidget(text);
  column->addLayout(buttons);
  stay->setFocus();
}

}  // namespace insonate::ui
