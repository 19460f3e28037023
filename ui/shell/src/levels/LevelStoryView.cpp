#include "LevelStoryView.h"

#include <insonate/curriculum/LevelStory.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QLabel>
#include <QStringList>
#include <QVBoxLayout>

namespace insonate::ui {
namespace {

QString wordsOf(StoryTurn::When when) {
  switch (when) {
    case StoryTurn::When::Beginning:
      return LevelStoryView::tr("At the beginning");
    case StoryTurn::When::Reached:
      return LevelStoryView::tr("When the level is unlocked");
    case StoryTurn::When::AfterFailure:
      return LevelStoryView::tr("After a failed attempt");
    case StoryTurn::When::AfterPass:
      return LevelStoryView::tr("After a passed attempt");
    case StoryTurn::When::Mastered:
      return LevelStoryView::tr("Later");
    case StoryTurn::When::Lapsed:
      break;
  }
  return LevelStoryView::tr("Without practice");
}

}  // namespace

LevelStoryView::LevelStoryView(QWidget* parent)
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

void LevelStoryView::show(const Curriculum& curriculum, const std::string& level,
                          const std::vector<DraftError>& errors) {
  QStringList wrong, turns;
  for (const DraftError& one : errors)
    if (one.level.empty() || one.level == level) wrong << QStringLiteral("▲  ") + QString::fromStdString(one.sentence);
  const auto others = qsizetype(errors.size()) - wrong.size();
  if (others > 0) wrong << tr("▲  Errors in other levels, which are marked with ▲: %1").arg(others);
  errors_->setText(wrong.join(QLatin1Char('\n')));
  errors_->setVisible(!wrong.isEmpty());
  // A draft may have its levels in any order.
  const auto whole = parseCurriculum(curriculumText(curriculum));
  if (whole && whole->level(level))
    for (const StoryTurn& turn : levelStory(*whole, level))
      turns << QStringLiteral("%1:  %2").arg(wordsOf(turn.when), QString::fromStdString(turn.sentence));
  story_->setText(turns.isEmpty() ? tr("The text appears here when the curriculum has no errors.")
                                  : turns.join(QLatin1Char('\n')));
}

}  // namespace insonate::ui
