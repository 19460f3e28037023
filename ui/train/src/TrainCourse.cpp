// The part of the workspace about levels: whose attempts count, what they change, and the page that tells it.
#include "TrainParts.h"
#include "attempt/AttemptControl.h"
#include "attempt/AttemptPanel.h"
#include "levels/AttemptKeeper.h"
#include "levels/Course.h"
#include "levels/CoursePage.h"
#include "levels/LevelControl.h"
#include "levels/LevelWords.h"
#include "levels/UnsentFacts.h"
#include "levels/VerdictView.h"

#include <insonate/ui/Account.h>

#include <QSplitter>
#include <QVBoxLayout>

namespace insonate::train {

void TrainWorkspace::Parts::buildCourse() {
  // The workspace's, so that they hear of an attempt that ends with everything else.
  course_ = new Course(unsentFolder(), &workspace_);
  levels_ =
      new LevelControl(model.status, model.patientCase, model.imaging, model.motion, *attempt, *course_, &workspace_);
  keeper_ = new AttemptKeeper(*attempt, unsentFolder(), &workspace_);
  keeper_->setAim([this] { return levels_->aim(); });
  connect(levels_, &LevelControl::caseWanted, &workspace_, &TrainWorkspace::caseWanted);
  connect(levels_, &LevelControl::changed, this, [this] { takeWaiting(); });
  connect(levels_, &LevelControl::changed, keeper_, &AttemptKeeper::prepare);
  connect(keeper_, &AttemptKeeper::said, &model.status, &StatusLine::say);
  connect(keeper_, &AttemptKeeper::allSent, course_, &Course::refresh);
  connect(keeper_, &AttemptKeeper::ended, this, [this](const AttemptFacts& facts) { judgeAttempt(facts); });
  connect(attempt, &AttemptControl::begun, this, [this] {
    attemptPanel_->verdict().show(course_->isSomebodys()
                                      ? tr("Free practice: the attempt is listed, but counts for no level.")
                                      : tr("You are a guest: the attempt is recorded, but counts for nobody."));
  });
}

void TrainWorkspace::Parts::setAccount(ui::Account& account) {
  account_ = &account;
  // Unsent facts are stored first, so that the course knows them.
  keeper_->setAccount(account);
  course_->setAccount(account);
}

void TrainWorkspace::Parts::judgeAttempt(const AttemptFacts& facts) {
  const Curriculum* curriculum = course_->curriculum();
  const Level* level = curriculum && facts.curriculum == curriculum->name ? curriculum->level(facts.level) : nullptr;
  const std::vector<LevelProgress> before = course_->progress();
  course_->add(facts);
  if (level) attemptPanel_->verdict().show(verdictOf(*curriculum, *level, facts, before, course_->progress()));
}

bool TrainWorkspace::Parts::isCourseShown() const {
  return coursePage_ && coursePage_->isVisibleTo(&workspace_);
}

void TrainWorkspace::Parts::showCourse(bool on) {
  if (on && !coursePage_) {
    coursePage_ = new CoursePage(*course_, *levels_, account_, &workspace_);
    workspace_.layout()->addWidget(coursePage_);
    connect(coursePage_, &CoursePage::left, this, [this] { showCourse(false); });
    connect(coursePage_, &CoursePage::attemptWanted, &workspace_, &TrainWorkspace::attemptWanted);
    connect(coursePage_, &CoursePage::said, &model.status, &StatusLine::say);
    connect(coursePage_, &CoursePage::written, &workspace_, &TrainWorkspace::written);
    connect(coursePage_, &CoursePage::failed, &workspace_,
            [this](const QString& what, const QString& advice) { Q_EMIT workspace_.failed(what, advice, {}); });
  }
  if (!coursePage_) return;
  columns->setVisible(!on);
  coursePage_->setVisible(on);
  courseAction_->setChecked(on);
  model.live.setWatched(!on);
  on ? coursePage_->takeKeyboard() : workspace_.setFocus();
  model.status.setHint(on ? tr("Enter starts the marked level. J returns to the image.") : QString());
}

}  // namespace insonate::train
