#include "ReviewSession.h"
#include "case/CaseFeature.h"
#include "comments/CommentFeature.h"
#include "home/HomeFeature.h"
#include "judge/JudgeFeature.h"
#include "judge/JudgingController.h"
#include "page/AttemptPage.h"
#include "replay/ReplayFeature.h"
#include "replay/SceneFeature.h"
#include "result/ResultFeature.h"

#include <insonate/review/ReviewWorkspace.h>
#include <insonate/ui/Account.h>
#include <insonate/ui/Theme.h>

#include <QAction>
#include <QKeyEvent>
#include <QStackedLayout>
#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <utility>

namespace insonate::review {

namespace {

/// Makes the action that saves what is shown: the result of the open attempt, or the page of the class or the person.
QAction& saveAction(ReviewWorkspace& workspace) {
  auto* save = new QAction(ui::icon(QStringLiteral("save")), ReviewWorkspace::tr("Save result ..."), &workspace);
  save->setObjectName(QStringLiteral("saveResult"));
  save->setShortcut(QKeySequence(QStringLiteral("Ctrl+E")));
  save->setShortcutContext(Qt::WidgetWithChildrenShortcut);
  workspace.addAction(save);
  workspace.commands().beginSection(ReviewWorkspace::tr("Pages"));
  workspace.commands().add(QStringLiteral("review.save"),
                           ReviewWorkspace::tr("saves the page that is shown: result, class or person"), *save);
  return *save;
}

}  // namespace

/// The model and the features. Members are deleted in reverse order: the features before their pages, and these before
/// the model.
struct ReviewWorkspace::Parts {
  Parts(ReviewWorkspace& workspace, ui::TaskBar& tasks)
      : session(*new ReviewSession(&workspace)),
        judging(session),
        model{workspace, session, judging, tasks, saveAction(workspace)},
        attemptPage(std::make_unique<AttemptPage>(model)),
        home(model),
        replay(model, *attemptPage),
        scene(model, *attemptPage),
        result(model, *attemptPage, scene),
        judge(model, *attemptPage, replay),
        comments(model, *attemptPage, replay),
        patientCase(model, *attemptPage) {}

  std::array<Feature*, 7> features() { return {&home, &replay, &scene, &result, &judge, &comments, &patientCase}; }

  ReviewSession& session;
  JudgingController judging;
  ReviewModel model;
  std::unique_ptr<AttemptPage> attemptPage;
  HomeFeature home;
  ReplayFeature replay;
  SceneFeature scene;
  ResultFeature result;
  JudgeFeature judge;
  CommentFeature comments;
  CaseFeature patientCase;
  std::string user;  ///< Person::id of the signed-in user; empty for a guest
  bool ready = false;
};

ReviewWorkspace::ReviewWorkspace(ui::TaskBar& tasks, QWidget* parent)
    : ui::Workspace(parent), parts_(std::make_unique<Parts>(*this, tasks)) {
  auto* pages = new QStackedLayout(this);
  pages->setContentsMargins(0, 0, 0, 0);
  pages->addWidget(parts_->home.page());
  pages->addWidget(parts_->attemptPage.get());
  // Before the features' own connections: they give the keyboard to widgets of a page that is shown.
  connect(&parts_->session, &ReviewSession::attemptChanged, this, [this, pages] {
    pages->setCurrentWidget(parts_->session.attempt() ? parts_->attemptPage.get() : parts_->home.page());
  });
  connectParts();
  parts_->result.showResult();
  refreshReady();
}

ReviewWorkspace::~ReviewWorkspace() {
  stop();
}

void ReviewWorkspace::connectParts() {
  const ReviewSession& session = parts_->session;
  for (const Feature* feature : parts_->features())
    connect(feature, &Feature::readinessChanged, this, &ReviewWorkspace::refreshReady);
  for (const auto change : {&ReviewSession::openingChanged, &ReviewSession::caseChanged, &ReviewSession::timeChanged,
                            &ReviewSession::pictureShown, &ReviewSession::surfacesDone})
    connect(&session, change, this, &ReviewWorkspace::refreshReady);
  connect(&session, &ReviewSession::pictureShown, this, &ui::Workspace::statusChanged);
  connect(&session, &ReviewSession::messageChanged, this, &ui::Workspace::statusChanged);
  connect(&parts_->model.save, &QAction::triggered, this,
          [this] { parts_->session.attempt() ? parts_->result.chooseFile() : parts_->home.showSaving(); });
  connect(&session, &ReviewSession::failed, this,
          [this](const QString& what, const QString& advice) { Q_EMIT failed(what, advice, {}); });
}

void ReviewWorkspace::addOpenAction(QAction* action) {
  parts_->home.addOpenAction(action);
}

void ReviewWorkspace::saveResult(const QString& file) {
  if (parts_->session.attempt()) parts_->result.saveAs(file);
}

void ReviewWorkspace::openAttempt(const QString& file) {
  parts_->session.open(file, parts_->model.tasks);
}

void ReviewWorkspace::setCase(std::shared_ptr<const PatientCase> patient) {
  parts_->session.setPatient(std::move(patient));
}

void ReviewWorkspace::setAccount(ui::Account& account) {
  // Before the connections of the features, which would otherwise show the former user's attempt to the next user. A
  // guest's replay stays open at sign-in, so that an instructor can sign in to judge it.
  connect(&account, &ui::Account::changed, this, [this, &account] {
    const std::string before = std::exchange(parts_->user, account.person().id);
    if (!before.empty() && before != parts_->user) parts_->session.close();
  });
  parts_->user = account.person().id;
  parts_->home.setAccount(account);
  parts_->comments.setAccount(account);
  parts_->judging.setAccount(account);
}

QString ReviewWorkspace::windowCloseWarning() const {
  return parts_->home.unwrittenPortfolio();
}

QString ReviewWorkspace::statusText() const {
  if (!parts_->judge.statusText().isEmpty()) return parts_->judge.statusText();
  const QString message = parts_->session.message();
  return message.isEmpty() ? parts_->home.statusText() : message;
}

QString ReviewWorkspace::engineText() const {
  const auto& frame = parts_->session.picture().shown();
  return frame ? tr("processor   %1 ms per image").arg(frame->frame_ms, 4, 'f', 1) : QString();
}

bool ReviewWorkspace::isReady() const {
  return parts_->ready;
}

void ReviewWorkspace::refreshReady() {
  const bool now = parts_->session.isSettled() &&
                   std::ranges::all_of(parts_->features(), [](const Feature* feature) { return feature->isReady(); });
  if (now == std::exchange(parts_->ready, now)) return;
  Q_EMIT readyChanged();
}

void ReviewWorkspace::saveLayout(QSettings& settings) const {
  parts_->attemptPage->save(settings);
  for (const Feature* feature : parts_->features()) feature->save(settings);
}

void ReviewWorkspace::restoreLayout(QSettings& settings) {
  parts_->attemptPage->restore(settings);
  for (Feature* feature : parts_->features()) feature->restore(settings);
}

void ReviewWorkspace::stop() {
  parts_->session.stop();
}

bool ReviewWorkspace::event(QEvent* event) {
  return (event->type() == QEvent::ShortcutOverride && commands().handleKeyEvent(*event)) ||
         ui::Workspace::event(event);
}

void ReviewWorkspace::keyPressEvent(QKeyEvent* event) {
  if (!commands().key(*event, true)) ui::Workspace::keyPressEvent(event);
}

void ReviewWorkspace::showEvent(QShowEvent* event) {
  ui::Workspace::showEvent(event);
  parts_->session.setAwake(true);
  parts_->home.refresh();
}

void ReviewWorkspace::hideEvent(QHideEvent* event) {
  ui::Workspace::hideEvent(event);
  parts_->session.setAwake(false);
}

}  // namespace insonate::review
