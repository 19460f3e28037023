#include "LevelSituationsView.h"

#include <insonate/curriculum/LevelSituations.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QLabel>
#include <QStringList>
#include <QVBoxLayout>

namespace insonate::ui {
namespace {

QString displayText(LevelSituation::When when) {
  switch (when) {
    case LevelSituation::When::Beginning:
      return LevelSituationsView::tr("Before the first attempt");
    case LevelSituation::When::Reached:
      return LevelSituationsView::tr("When the level is unlocked");
    case LevelSituation::When::AfterFailure:
      return LevelSituationsView::tr("After a failed attempt");
    case LevelSituation::When::AfterPass:
      return LevelSituationsView::tr("After a passed attempt");
    case LevelSituation::When::Mastered:
      return LevelSituationsView::tr("When the level is mastered");
    case LevelSituation::When::Lapsed:
      break;
  }
  return LevelSituationsView::tr("After too many days without practice");
}

/// Replaces the names of levels, which the window does not show, by the titles.
QString withTitles(const std::string& sentence, const Curriculum& curriculum) {
  QString text = QString::fromStdString(sentence);
  for (const Level& level : curriculum.levels)
    if (!level.title.empty())
      text.replace(QStringLiteral("'%1'").arg(QString::fromStdString(level.name)),
                   QStringLiteral("'%1'").arg(QString::fromStdString(level.title)));
  return text;
}

}  // namespace

LevelSituationsView::LevelSituationsView(QWidget* parent)
    : QFrame(parent),
      errors_(paragraph("curriculumTroubles", "problem")),
      heading_(paragraph("levelStoryHeading", "heading")),
      story_(paragraph("levelStory", "quiet")) {
  setRole(this, "panel");
  heading_->setText(tr("What trainees read about this level"));
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(kGap, kGap, kGap, kGap);
  box->setSpacing(kSmallGap);
  for (QLabel* one : {errors_, heading_, story_}) box->addWidget(one);
}

void LevelSituationsView::show(const Curriculum& curriculum, const std::string& level,
                               const std::vector<DraftError>& errors) {
  QStringList wrong, turns;
  for (const DraftError& one : errors)
    if (one.level.empty() || one.level == level) wrong << QStringLiteral("▲  ") + withTitles(one.sentence, curriculum);
  const auto others = qsizetype(errors.size()) - wrong.size();
  if (others > 0) wrong << tr("▲  Errors in other levels (marked with ▲ in the list): %1").arg(others);
  errors_->setText(wrong.join(QLatin1Char('\n')));
  errors_->setVisible(!wrong.isEmpty());
  // A draft may have its levels in any order.
  const auto whole = parseCurriculum(curriculumText(curriculum));
  if (whole && whole->level(level))
    for (const LevelSituation& turn : levelSituations(*whole, level))
      turns << QStringLiteral("%1:  %2").arg(displayText(turn.when), QString::fromStdString(turn.sentence));
  story_->setText(turns.isEmpty() ? tr("The text that trainees read appears here when the curriculum has no errors.")
                                  : turns.join(QLatin1Char('\n')));
}

}  // namespace insonate::ui
