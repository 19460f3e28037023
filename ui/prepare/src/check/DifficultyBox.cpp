#include "DifficultyBox.h"

#include "../model/CaseMeasuring.h"
#include "../model/OpenCase.h"
#include "../model/PlacesEditor.h"
#include "../model/PrepareModel.h"

#include <insonate/ui/Theme.h>

#include <QComboBox>
#include <QLabel>
#include <QVBoxLayout>

namespace insonate::prepare {
namespace {

QString measuresText(const DifficultyEstimate& estimate) {
  QStringList lines;
  for (const DifficultyShare& share : estimate.shares)
    lines << QStringLiteral("%1: %2 (%3)")
                 .arg(QString::fromStdString(share.what), QString::fromStdString(share.value))
                 .arg(share.points, 0, 'f', 2);
  lines << DifficultyBox::tr(
               "Difficulty: %1 points in total; moderate from 0.25 points, hard from 1 point (version %2 of the "
               "formula).")
               .arg(estimate.points, 0, 'f', 2)
               .arg(DifficultyEstimate::kVersion);
  return lines.join(QLatin1Char('\n'));
}

}  // namespace

DifficultyBox::DifficultyBox(PrepareModel& shared, QWidget* parent)
    : QWidget(parent), shared_(shared), grade_(new QComboBox), sentence_(new QLabel), measures_(new QLabel) {
  grade_->setObjectName(QStringLiteral("grade"));
  grade_->setAccessibleName(tr("Difficulty of the case"));
  grade_->setToolTip(tr("Your own grade overrides the estimated difficulty; saved with the case"));
  grade_->addItem(tr("estimated difficulty"), QString());
  for (const QString& grade : {QStringLiteral("easy"), QStringLiteral("moderate"), QStringLiteral("hard")})
    grade_->addItem(grade, grade);
  sentence_->setObjectName(QStringLiteral("gradeSentence"));
  measures_->setObjectName(QStringLiteral("gradeMeasures"));
  ui::setRole(measures_, "quiet");
  for (QLabel* label : {sentence_, measures_}) label->setWordWrap(true);
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(ui::kSmallGap);
  box->addWidget(grade_);
  box->addWidget(sentence_);
  box->addWidget(measures_);
  connect(grade_, qOverload<int>(&QComboBox::activated), this, [this] {
    CasePlaces places = shared_.places.value();
    places.difficulty = grade_->currentData().toString().toStdString();
    shared_.places.set(std::move(places), tr("difficulty"));
  });
  connect(&shared_.openCase, &OpenCase::caseChanged, this, [this] { refresh(); });
  connect(&shared_.places, &PlacesEditor::changed, this, [this] { refresh(); });
  connect(&shared_.measuring, &CaseMeasuring::changed, this, [this] { refresh(); });
  refresh();
}

void DifficultyBox::refresh() {
  grade_->setCurrentIndex(std::max(0, grade_->findData(QString::fromStdString(shared_.places.value().difficulty))));
  const auto& measures = shared_.measuring.measures();
  measures_->setVisible(measures && measures->difficulty);
  if (!measures) return sentence_->setText(tr("Measuring the difficulty ..."));
  if (!measures->difficulty) return sentence_->setText(QString::fromStdString(measures->difficulty.error().message));
  sentence_->setText(tr("Estimated difficulty. %1").arg(QString::fromStdString(measures->difficulty->sentence)));
  measures_->setText(measuresText(*measures->difficulty));
}

}  // namespace insonate::prepare
