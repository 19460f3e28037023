#include "RestoreQuestion.h"

#include "KeptWork.h"

#include <insonate/ui/Text.h>
#include <insonate/ui/Theme.h>

#include <QDateTime>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

namespace insonate::prepare {
namespace {

constexpr int kText_px = 440;

QString timeText(std::int64_t time_s) {
  const QDateTime time = QDateTime::fromSecsSinceEpoch(time_s);
  const bool isToday = time.date() == QDate::currentDate();
  return QLocale(QLocale::English)
      .toString(time, isToday ? QStringLiteral("HH:mm") : QStringLiteral("d MMM yyyy, HH:mm"));
}

QString sentences(const KeptWork& kept) {
  QStringList all{RestoreQuestion::tr("Unsaved work on \"%1\" from %2 was found: %3.")
                      .arg(ui::qt(kept.work.after.title), timeText(kept.work.time_s), partsText(kept.work))};
  if (!kept.work.folder.empty()) all << RestoreQuestion::tr("Folder of the case: %1").arg(ui::qt(kept.work.folder));
  if (kept.wasChanged)
    all << RestoreQuestion::tr(
        "The case was saved again since then. Restore applies the unsaved work to the case as it is now: check the "
        "case before you save it.");
  else if (!kept.isHere)
    all << RestoreQuestion::tr("Restore opens this case.");
  return all.join(QLatin1Char('\n'));
}

}  // namespace

RestoreQuestion::RestoreQuestion(const KeptWork& kept, QWidget* parent) : QDialog(parent) {
  setObjectName(QStringLiteral("restoreQuestion"));
  setWindowTitle(tr("Unsaved work"));
  setAttribute(Qt::WA_DeleteOnClose);
  auto* title = new QLabel(tr("Unsaved work was found"));
  ui::setRole(title, "title");
  auto* text = new QLabel(sentences(kept));
  text->setObjectName(QStringLiteral("restoreText"));
  text->setTextFormat(Qt::PlainText);
  text->setWordWrap(true);
  text->setMinimumWidth(kText_px);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(ui::kSmallGap);
  buttons->addStretch();
  const auto add = [this, buttons](const char* name, const QString& words, const QString& tip) {
    auto* button = new QPushButton(words);
    button->setObjectName(QLatin1String(name));
    button->setToolTip(tip);
    connect(button, &QPushButton::clicked, this, &QDialog::accept);
    buttons->addWidget(button);
    return button;
  };
  auto* discard = add("discardWork", tr("Discard"), tr("Deletes the unsaved work; the saved case stays as it is"));
  connect(discard, &QPushButton::clicked, this, &RestoreQuestion::discardChosen);
  auto* later = add("later", tr("Later"), tr("Leaves the unsaved work where it is, and asks again later (Esc)"));
  connect(later, &QPushButton::clicked, this, &RestoreQuestion::laterChosen);
  connect(this, &QDialog::rejected, this, &RestoreQuestion::laterChosen);
  auto* restore = add("restoreWork", tr("Restore"), tr("Applies the unsaved work to the case, without saving it"));
  connect(restore, &QPushButton::clicked, this, &RestoreQuestion::restoreChosen);
  ui::setRole(restore, "primary");
  restore->setDefault(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(ui::kLargeGap, ui::kLargeGap, ui::kLargeGap, ui::kLargeGap);
  column->setSpacing(ui::kLargeGap);
  column->addWidget(title);
  column->addWidget(text);
  column->addLayout(buttons);
  restore->setFocus();
}

}  // namespace insonate::prepare
