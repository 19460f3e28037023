#include "ReviewHome.h"

#include "../class/ClassController.h"
#include "../class/ClassPage.h"
#include "../compare/ComparePage.h"
#include "../judge/RatersPage.h"
#include "../list/AttemptList.h"
#include "../person/PersonController.h"
#include "../person/PersonPage.h"
#include "../reports/SaveMenu.h"
#include "StoreWatch.h"

#include <insonate/ui/Account.h>
#include <insonate/ui/Commands.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QAction>
#include <QButtonGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

namespace insonate::review {

ReviewHome::ReviewHome(AttemptList& list, ui::Commands& commands, ui::TaskBar& tasks, QWidget* parent)
    : QWidget(parent),
      list_(list),
      room_(new ClassController(this)),
      person_(new PersonController(this)),
      row_(new QHBoxLayout),
      bar_(buildTabs()),
      notice_(new QLabel),
      tabs_(new QButtonGroup(this)),
      pages_(new QStackedWidget),
      classPage_(new ClassPage(*room_, commands)),
      personPage_(new PersonPage(*person_, *room_, commands)),
      comparePage_(new ComparePage(*room_)),
      ratersPage_(new RatersPage(*room_)),
      saveClass_(new SaveMenu(SaveMenu::Subject::Class, *room_, *person_, tasks, this)),
      savePerson_(new SaveMenu(SaveMenu::Subject::Person, *room_, *person_, tasks, this)) {
  classPage_->setSaving(saveClass_);
  personPage_->setSaving(savePerson_);
  addTabs(commands);
  addPortfolio(commands);
  notice_->setObjectName(QStringLiteral("accountNotice"));
  notice_->setWordWrap(true);
  notice_->setTextFormat(Qt::PlainText);
  notice_->setContentsMargins(ui::kGap, ui::kSmallGap, ui::kGap, ui::kSmallGap);
  ui::setRole(notice_, "quiet");
  for (QWidget* page : std::initializer_list<QWidget*>{classPage_, personPage_, comparePage_, &list_, ratersPage_})
    pages_->addWidget(page);
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(0);
  box->addWidget(bar_);
  box->addWidget(notice_);
  box->addWidget(pages_, 1);
  connectParts();
  showSignedInPages();
}

QWidget* ReviewHome::buildTabs() {
  auto* bar = new QFrame;
  ui::setRole(bar, "bar");
  bar->setLayout(row_);
  row_->setContentsMargins(ui::kGap, 0, ui::kGap, 0);
  row_->setSpacing(0);
  return bar;
}

void ReviewHome::addTabs(ui::Commands& commands) {
  const auto add = [&](Tab tab, const char* object, const char* id, const QString& text, const QString& does) {
    auto* button = ui::tabButton(object, text, {});
    commands.add(QLatin1String(id), does, *button, QKeySequence(QStringLiteral("Alt+%1").arg(tab + 1)));
    tabs_->addButton(button, tab);
    row_->addWidget(button);
  };
  commands.beginSection(tr("Pages"));
  add(kClass, "classTab", "review.home.class", tr("Class"), tr("shows the overview of a class"));
  add(kPerson, "personTab", "review.home.person", tr("Person"), tr("shows the learning curves of one person"));
  add(kCompare, "compareTab", "review.home.compare", tr("Compare"), tr("compares two classes"));
  add(kRecordings, "recordingsTab", "review.home.recordings", tr("Recordings"),
      tr("lists the recordings of this computer that you may see"));
  add(kRaters, "ratersTab", "review.home.raters", tr("Raters"), tr("shows how well the raters of the class agree"));
  commands.addListed(tr("Ctrl+Shift+E"), tr("saves a plot as PNG, SVG or PDF"));
  row_->addStretch(1);
}

void ReviewHome::addPortfolio(ui::Commands& commands) {
  QAction& portfolio = savePerson_->addPortfolio();
  portfolio.setShortcut(QKeySequence(QStringLiteral("Ctrl+Shift+P")));
  portfolio.setShortcutContext(Qt::WidgetWithChildrenShortcut);
  // The key works wherever the focus is, also in the tabs, but only on the page of the person whose data are saved.
  addAction(&portfolio);
  const auto enable = [this, &portfolio] {
    portfolio.setEnabled(person_->facts() && pages_->currentIndex() == kPerson);
  };
  connect(pages_, &QStackedWidget::currentChanged, &portfolio, enable);
  connect(person_, &PersonController::personChanged, &portfolio, enable);
  enable();
  commands.add(QStringLiteral("review.home.portfolio"),
               tr("saves levels, tests, learning curves, checklists, ratings and attempts of the person as PDF"),
               portfolio);
}

void ReviewHome::connectParts() {
  connect(tabs_, &QButtonGroup::idClicked, this, [this](int tab) {
    // From the class page to the selected person.
    const QString person = tab == kPerson && classPage_->isVisible() ? classPage_->chosenPerson() : QString();
    person.isEmpty() ? showTab(tab) : choosePerson(person);
  });
  connect(classPage_, &ClassPage::personChosen, this, [this](const QString& person) { choosePerson(person); });
  connect(personPage_, &PersonPage::replayRequested, this, &ReviewHome::replayRequested);
  connect(personPage_, &PersonPage::personRequested, this, [this](const QString& person) { choosePerson(person); });
  connect(personPage_, &PersonPage::written, this, &ReviewHome::written);
  connect(personPage_, &PersonPage::failed, this, &ReviewHome::failed);
  connect(comparePage_, &ComparePage::written, this, &ReviewHome::written);
  connect(comparePage_, &ComparePage::failed, this, &ReviewHome::failed);
  connect(ratersPage_, &RatersPage::written, this, &ReviewHome::written);
  connect(ratersPage_, &RatersPage::failed, this, &ReviewHome::failed);
  for (SaveMenu* menu : {saveClass_, savePerson_}) {
    connect(menu, &SaveMenu::written, this, &ReviewHome::written);
    connect(menu, &SaveMenu::failed, this, &ReviewHome::failed);
  }
  connect(person_, &PersonController::countChanged, room_, &ClassController::refresh);
  connect(room_, &ClassController::readingChanged, this, &ReviewHome::readinessChanged);
  connect(room_, &ClassController::standingChanged, this, &ReviewHome::readinessChanged);
  connect(person_, &PersonController::readingChanged, this, &ReviewHome::readinessChanged);
  connect(room_, &ClassController::classChanged, this, [this] { showSelf(); });
}

void ReviewHome::setAccount(ui::Account& account) {
  account_ = &account;
  person_->setAccount(account);
  connect(&account, &ui::Account::changed, this, [this] { showSignedInPages(); });
  room_->setAccount(account);
  connect(new StoreWatch(account, *this), &StoreWatch::changed, this, &ReviewHome::showChanges);
  showSignedInPages();
}

void ReviewHome::showChanges(const std::set<std::string>& people) {
  const bool concernsAll = people.contains("");
  const auto isAmong = [&](const Member& one) { return people.contains(one.person.id); };
  if (concernsAll || (room_->facts() && std::ranges::any_of(room_->facts()->learners, isAmong))) room_->refresh();
  if (person_->facts() && (concernsAll || people.contains(person_->facts()->person.id))) person_->refresh();
}

void ReviewHome::refreshComments() {
  person_->refreshComments();
}

/// Shows the tabs and pages of the present user, and no data of the former one.
void ReviewHome::showSignedInPages() {
  const bool somebody = room_->isSomebody();
  bar_->setVisible(somebody);
  for (const Tab tab : {kClass, kCompare, kRaters}) tabs_->button(tab)->setVisible(room_->teaches());
  const QKeySequence key = tabs_->button(kPerson)->shortcut();
  tabs_->button(kPerson)->setText(room_->teaches() ? tr("Person") : tr("My attempts"));
  tabs_->button(kPerson)->setShortcut(key);  // setting a text removes the shortcut
  person_->show({}, std::nullopt);
  notice_->setVisible(!somebody);
  notice_->setText(account_ && account_->state() == ui::Account::State::Unreachable
                       ? tr("Cannot load people and classes: %1").arg(account_->error())
                       : tr("Sign in (Ctrl+L) to see classes, people and learning curves."));
  showTab(!somebody ? kRecordings : room_->teaches() ? kClass : kPerson);
  if (somebody && !room_->teaches()) person_->show(account_->person().id, std::nullopt);
}

/// The own page of a trainee uses the curriculum of the trainee's class.
void ReviewHome::showSelf() {
  if (room_->isSomebody() && !room_->teaches() && room_->curriculum())
    person_->show(account_->person().id, *room_->curriculum());
}

void ReviewHome::showTab(int tab) {
  tabs_->button(tab)->setChecked(true);
  pages_->setCurrentIndex(tab);
  if (tab == kRecordings) list_.refresh();
  Q_EMIT statusChanged();
}

void ReviewHome::choosePerson(const QString& person) {
  const Curriculum* curriculum = room_->curriculum();
  person_->show(person.toStdString(), curriculum ? std::optional(*curriculum) : std::nullopt);
  showTab(kPerson);
  personPage_->setFocus();
}

void ReviewHome::showSaving() {
  if (classPage_->isVisible()) classPage_->openSaving();
  if (personPage_->isVisible()) personPage_->openSaving();
}

void ReviewHome::focusPage() {
  pages_->currentWidget()->setFocus();
}

QString ReviewHome::unwrittenPortfolio() const {
  const QString name = savePerson_->waitingPortfolio();
  return name.isEmpty()
             ? QString()
             : tr("The portfolio of %1 is not written yet. If you close the window, the portfolio is lost.").arg(name);
}

bool ReviewHome::isSettled() const {
  return !room_->isReading() && room_->pendingStandings() == 0 && !person_->isReading();
}

QString ReviewHome::statusText() const {
  switch (pages_->currentIndex()) {
    case kClass:
      return tr("Choose a person; Enter shows the person's page.");
    case kPerson:
      return tr("Choose an attempt; Enter replays it.");
    case kCompare:
      return tr("Choose a class to compare with, and a metric.");
    case kRaters:
      return tr("Choose a form, and two raters to compare item by item.");
    default:
      return tr("Choose an attempt; Enter opens it.");
  }
}

}  // namespace insonate::review
