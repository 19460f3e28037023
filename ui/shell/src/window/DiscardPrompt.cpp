#include "DiscardPrompt.h"

#include <insonate/ui/Theme.h>

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace insonate::ui {
namespace {

constexpr int kText_px = 420;

QString headingOf(const Loss& loss) {
  if (loss.isWork()) return DiscardPrompt::tr("Work is in progress");
  return loss.nowhere ? DiscardPrompt::tr("The case is not saved") : DiscardPrompt::tr("Changes are not saved");
}

QString sentencesOf(const Loss& loss) {
  QStringList sentences;
  if (!loss.job.isEmpty())
    sentences << DiscardPrompt::tr("%1: continuing cancels this job and discards its partial result.").arg(loss.job);
  if (!loss.ending.isEmpty()) sentences << loss.ending;
  if (!loss.title.isEmpty() && loss.nowhere)
    sentences << DiscardPrompt::tr("The case \"%1\" is not saved yet. If you do not save the case, it is lost.")
                     .arg(loss.title);
  else if (!loss.title.isEmpty())
    sentences << DiscardPrompt::tr(
                     "The case \"%1\" has unsaved changes. If you do not save the case, the changes are lost.")
                     .arg(loss.title);
  return sentences.join(QLatin1Char('\n'));
}

QString croppingText(const Loss& loss) {
  return loss.nowhere ? DiscardPrompt::tr(
                            "The case \"%1\" is not saved. If you continue, the cropped part replaces it, and the "
                            "rest of the CT and its labels are not kept. Then save the part.")
                            .arg(loss.title)
                      : DiscardPrompt::tr(
                            "The case \"%1\" has unsaved changes. The cropped part contains them, but the case on "
                            "disk does not.")
                            .arg(loss.title);
}

}  // namespace

DiscardPrompt::DiscardPrompt(const Loss& loss, LostBy by, QWidget* parent) : QDialog(parent) {
  const bool closing = by == LostBy::Closing, working = loss.isWork();
  const bool cropping = by == LostBy::Cropping && !working;
  setWindowTitle(closing ? tr("Close Insonate") : cropping ? tr("Crop the case") : tr("Open another case"));
  setAttribute(Qt::WA_DeleteOnClose);
  auto* title = new QLabel(headingOf(loss));
  setRole(title, "title");
  auto* text = new QLabel(cropping ? croppingText(loss) : sentencesOf(loss));
  text->setTextFormat(Qt::PlainText);
  text->setWordWrap(true);
  text->setMinimumWidth(kText_px);

  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(kGap);
  buttons->addStretch();
  const auto add = [this, buttons](const char* name, const QString& words, const QString& tip) {
    auto* button = new QPushButton(words);
    button->setObjectName(QLatin1String(name));
    button->setToolTip(tip);
    connect(button, &QPushButton::clicked, this, &QDialog::accept);
    buttons->addWidget(button);
    return button;
  };
  auto* go = closing ? add("goOn", working ? tr("Stop and close") : tr("Close without saving"), tr("Close the window"))
                     : add("goOn",
                           working    ? tr("Stop and continue")
                           : cropping ? tr("Continue with the part")
                                      : tr("Continue without saving"),
                           tr("Discard"));
  connect(go, &QPushButton::clicked, this, &DiscardPrompt::continueChosen);
  auto* usual = add("keep", tr("Cancel"), tr("Closes this dialog without changes (Esc)"));
  if (!working) {
    usual = loss.nowhere ? add("save", tr("Save case as ..."),
                               tr("Saves the case to a folder, and then continues what you started"))
                         : add("save", tr("Save case"),
                               tr("Saves the changes to the case's folder, and then continues what you started"));
    connect(usual, &QPushButton::clicked, this, &DiscardPrompt::saveChosen);
  }
  // A CT that was just imported can be imported again; to save the whole CT first would be the exception.
  if (cropping && loss.nowhere) usual = go;
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
