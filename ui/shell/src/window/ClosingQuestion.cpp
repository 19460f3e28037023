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

ClosingQuestion::ClosingQuestion(const QString& job, const QString& unsaved, QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("Close Insonate"));
  setAttribute(Qt::WA_DeleteOnClose);
  const bool working = !job.isEmpty();
  auto* title = new QLabel(working ? tr("Something is still being done") : tr("The case is not saved"));
  setRole(title, "title");
  QStringList sentences;
  if (working) sentences << tr("%1: closing stops it, and leaves nothing half done behind.").arg(job);
  if (!unsaved.isEmpty()) sentences << tr("\"%1\" is not on disk yet; closing loses it.").arg(unsaved);
  auto* text = new QLabel(sentences.join(QLatin1Char('\n')));
  text->setTextFormat(Qt::PlainText);
  text->setWordWrap(true);
  text->setMinimumWidth(kText_px);

  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(kGap);
  buttons->addStretch();
  const auto add = [this, buttons](const QString& words, const QString& tip) {
    auto* button = new QPushButton(words);
    button->setToolTip(tip);
    connect(button, &QPushButton::clicked, this, &QDialog::accept);
    buttons->addWidget(button);
    return button;
  };
  auto* leave = add(working ? tr("Stop and close") : tr("Close without saving"), tr("Close the window now"));
  connect(leave, &QPushButton::clicked, this, &ClosingQuestion::closeChosen);
  auto* usual = add(tr("Keep working"), tr("Back to the window (Esc)"));
  if (!working) {
    usual = add(tr("Save case as ..."), tr("Write the case to a folder, then close"));
    connect(usual, &QPushButton::clicked, this, &ClosingQuestion::saveChosen);
  }
  setRole(usual, "primary");
  usual->setDefault(true);

  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(kLargeGap, kLargeGap, kLargeGap, kLargeGap);
  column->setSpacing(kLargeGap);
  column->addWidget(title);
  column->addWidget(text);
  column->addLayout(buttons);
  usual->setFocus();
}

}  // namespace insonate::ui
