#include "LevelsFeature.h"

#include "../attempt/AttemptControl.h"
#include "../attempt/AttemptPanel.h"
#include "../feature/CommandWords.h"
#include "../layout/TrainLayout.h"
#include "../model/TrainModel.h"
#include "AttemptSaver.h"
#include "Course.h"
#include "CoursePage.h"
#include "LevelCard.h"
#include "LevelControl.h"
#include "LevelWords.h"
#include "TestAdmissions.h"
#include "UnsentFacts.h"
#include "VerdictView.h"

#include <insonate/ui/Widgets.h>
#include <insonate/ui/Workspace.h>

#include <QAction>
#include <QPushButton>
#include <algorithm>

namespace insonate::train {
namespace {

const QString kShowLevels = QStringLiteral("train.levels.show");

}  // namespace

LevelsFeature::LevelsFeature(TrainModel& model, TrainLayout& layout, AttemptControl& attempt, AttemptPanel& panel)
    : Feature(model, layout),
      attempt_(attempt),
      panel_(panel),
      course_(new Course(unsentFolder(), this)),
      admissions_(new TestAdmissions(*course_, this)),
      levels_(new LevelControl(model.status, model.patientCase, model.imaging, model.motion, attempt, *course_, this)),
      keeper_(new AttemptSaver(attempt, unsentFolder(), this)) {
  addCommands();
  pageAction_ = addSwitch(kShowLevels, [this] { return layout_.isPageShown(); });
  fillPanel();
  connectParts();
}

LevelsFeature::~LevelsFeature() {
  delete page_;
}

void LevelsFeature::fillPanel() {
  auto* card = new LevelCard(*levels_, *admissions_, commands().toolTip(kShowLevels));
  verdict_ = new VerdictView;
  auto* toLevels = ui::pushButton("attemptLevels", tr("Levels"), commands().toolTip(kShowLevels), Qt::TabFocus);
  panel_.addCard(card);
  panel_.addToResult(verdict_, toLevels);
  connect(card, &LevelCard::courseRequested, this, [this] { showPage(true); });
  connect(toLevels, &QPushButton::clicked, this, [this] { showPage(true); });
  connect(levels_, &LevelControl::changed, &panel_, [this] { panel_.setProcedureFixed(levels_->level()); });
}

void LevelsFeature::connectParts() {
  keeper_->setNeedlePath([this] { return levels_->aim(); });
  keeper_->setSitting([this](const Level& level) { return admissions_->expectedTestConditions(level); });
  connect(levels_, &LevelControl::caseRequested, &layout_.workspace(), &ui::Workspace::caseRequested);
  connect(levels_, &LevelControl::changed, this, [this] {
    if (!holdsCase()) Q_EMIT caseReleased();
  });
  connect(levels_, &LevelControl::changed, keeper_, &AttemptSaver::prepare);
  connect(keeper_, &AttemptSaver::messageReported, &model_.status, &StatusLine::showMessage);
  connect(keeper_, &AttemptSaver::allSent, course_, &Course::refresh);
  connect(keeper_, &AttemptSaver::ended, this, [this](const AttemptFacts& facts) { judge(facts); });
  connect(course_, &Course::changed, this, [this] { judgeAgain(); });
  connect(&attempt_, &AttemptControl::begun, this, [this] {
    judged_.reset();
    verdict_->show(course_->isSomebodys()
                       ? tr("Free practice: the attempt is listed, but counts for no level.")
                       : tr("You are a guest: the attempt is recorded, but does not count at any level."));
  });
}

void LevelsFeature::setAccount(ui::Account& account) {
  account_ = &account;
  // Unsent facts are stored first, so that the course knows them.
  keeper_->setAccount(account);
  admissions_->setAccount(account);
  course_->setAccount(account);
}

void LevelsFeature::judge(const AttemptFacts& facts) {
  const Curriculum* curriculum = course_->curriculum();
  const Level* level = curriculum && facts.curriculum == curriculum->name ? curriculum->level(facts.level) : nullptr;
  const std::vector<LevelProgress> before = course_->progress();
  course_->add(facts);
  if (!level) return;
  judged_ = facts;
  verdict_->show(verdictOf(*curriculum, *level, facts, before, course_->progress()));
}

/// The store may decide otherwise than was expected whether a test was open.
void LevelsFeature::judgeAgain() {
  if (!judged_ || !course_->curriculum()) return;
  const auto history = course_->history();
  const auto now = std::ranges::find(history, judged_->id, &AttemptFacts::id);
  const Level* level = course_->curriculum()->level(judged_->level);
  if (now == history.end() || !level || now->testConditions == judged_->testConditions) return;
  judged_->testConditions = now->testConditions;
  verdict_->show(verdictOf(*course_->curriculum(), *level, *judged_, course_->progress(), course_->progress()));
}

void LevelsFeature::addCommands() {
  beginSection(KeySection::Attempts);
  // The page needs no patient.
  addCommand({.id = kShowLevels,
              .text = tr("Levels and attempts"),
              .does = tr("shows levels, your attempts and the questionnaire, or returns to the image"),
              .listed = tr("J"),
              .keys = keys({Qt::Key_J}),
              .perform = once([this] { showPage(!layout_.isPageShown()); }),
              .isAvailable = [] { return true; }});
}

bool LevelsFeature::holdsCase() const {
  return levels_->level();
}

void LevelsFeature::makePage() {
  ui::Workspace& workspace = layout_.workspace();
  page_ = new CoursePage(*course_, *levels_, *admissions_, account_, keysOf(commands(), kShowLevels), &workspace);
  connect(page_, &CoursePage::left, this, [this] { showPage(false); });
  connect(page_, &CoursePage::attemptRequested, &workspace, &ui::Workspace::attemptRequested);
  connect(page_, &CoursePage::messageReported, &model_.status, &StatusLine::showMessage);
  connect(page_, &CoursePage::written, &workspace, &ui::Workspace::written);
  connect(page_, &CoursePage::failed, &workspace,
          [&workspace](const QString& what, const QString& advice) { Q_EMIT workspace.failed(what, advice, {}); });
}

void LevelsFeature::showPage(bool isShown) {
  if (isShown && !page_) makePage();
  if (!page_) return;
  layout_.showPage(isShown ? page_ : nullptr);
  pageAction_->setChecked(isShown);
  model_.live.setWatched(!isShown);
  isShown ? page_->takeKeyboard() : layout_.workspace().setFocus();
  model_.status.setHint(
      isShown ? tr("Enter starts the selected level. %1 returns to the image.").arg(keysOf(commands(), kShowLevels))
              : QString());
}

}  // namespace insonate::train
