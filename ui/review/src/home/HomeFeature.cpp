#include "HomeFeature.h"

#include "../ReviewSession.h"
#include "../judge/JudgingController.h"
#include "../list/AttemptList.h"
#include "ReviewHome.h"

#include <insonate/ui/Account.h>
#include <insonate/ui/Workspace.h>

namespace insonate::review {

HomeFeature::HomeFeature(const ReviewModel& model)
    : Feature(model), list_(new AttemptList), home_(new ReviewHome(*list_, model.workspace.commands(), model.tasks)) {
  connect(list_, &AttemptList::chosen, this, [this](const QString& file) { model_.session.open(file, model_.tasks); });
  connect(list_, &AttemptList::listed, this, &Feature::readinessChanged);
  connect(home_, &ReviewHome::replayRequested, this, [this](const QString& file, const QString& attempt) {
    model_.judging.expect(file, attempt);
    model_.session.open(file, model_.tasks);
  });
  connect(home_, &ReviewHome::readinessChanged, this, &Feature::readinessChanged);
  connect(home_, &ReviewHome::statusChanged, &model_.workspace, &ui::Workspace::statusChanged);
  connect(home_, &ReviewHome::written, &model_.workspace, &ui::Workspace::written);
  connect(home_, &ReviewHome::failed, this,
          [this](const QString& what, const QString& advice) { Q_EMIT model_.workspace.failed(what, advice, {}); });
  connect(&model_.session, &ReviewSession::attemptChanged, this, [this] {
    if (model_.session.attempt()) return;
    home_->focusPage();
    refresh();
    home_->refreshComments();
  });
}

QWidget* HomeFeature::page() {
  return home_;
}

void HomeFeature::addOpenAction(QAction* action) {
  list_->addOpenAction(action);
}

void HomeFeature::setAccount(ui::Account& account) {
  home_->setAccount(account);
  const auto show = [this, &account] {
    list_->setUser(account.person().id, account.isSignedIn() && account.person().role != Role::Trainee);
  };
  connect(&account, &ui::Account::changed, this, show);
  show();
}

void HomeFeature::refresh() {
  list_->refresh();
}

void HomeFeature::showSaving() {
  home_->showSaving();
}

QString HomeFeature::unwrittenPortfolio() const {
  return home_->unwrittenPortfolio();
}

QString HomeFeature::statusText() const {
  return home_->statusText();
}

bool HomeFeature::isReady() const {
  return model_.session.attempt() || (!list_->isReading() && home_->isSettled());
}

}  // namespace insonate::review
