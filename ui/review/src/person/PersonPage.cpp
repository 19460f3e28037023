#include "PersonPage.h"

#include "../class/ClassController.h"
#include "../class/ClassWords.h"
#include "HistoryTable.h"
#include "PersonCharts.h"
#include "PersonController.h"

#include <insonate/ui/Chart.h>
#include <insonate/ui/Commands.h>
#include <insonate/ui/NameOrder.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QCollator>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSplitter>
#include <QVBoxLayout>
#include <algorithm>
#include <vector>

namespace insonate::review {

PersonPage::PersonPage(PersonController& controller, const ClassController& room, ui::Commands& commands,
                       QWidget* parent)
    : QWidget(parent),
      controller_(controller),
      room_(room),
      name_(new QLabel),
      sentence_(new QLabel),
      save_(new QPushButton(ui::icon(QStringLiteral("save")), tr("Save"))),
      previous_(ui::pushButton("previousPerson", {}, {})),
      next_(ui::pushButton("nextPerson", {}, {})),
      metric_(choice("metricShown", tr("Metric"), tr("Metric of the learning curve and the box plot"))),
      level_(choice("levelShown", tr("Level"), tr("Level whose attempts are shown"))),
      learning_(new ui::Chart),
      cusum_(new ui::Chart),
      place_(new ui::Chart),
      history_(new HistoryTable(controller, commands)) {
  for (const MetricMeaning& meaning : MetricCatalog::instance().all()) metric_->addItem(titleWithUnit(meaning));
  auto* split = new QSplitter(Qt::Vertical);
  split->setChildrenCollapsible(false);
  split->addWidget(buildCharts());
  split->addWidget(history_);
  split->setSizes({360, 300});
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(ui::kGap, ui::kGap, ui::kGap, ui::kGap);
  box->setSpacing(ui::kGap);
  box->addWidget(buildHead(commands));
  box->addWidget(sentence_);
  box->addWidget(split, 1);
  connect(&controller_, &PersonController::personChanged, this, [this] { showPerson(); });
  connect(&controller_, &PersonController::readingChanged, this, [this] { showWhere(); });
  connect(&controller_, &PersonController::failed, this, [this](const QString& what) { Q_EMIT failed(what, {}); });
  connect(history_, &HistoryTable::replayRequested, this, &PersonPage::replayRequested);
  connect(history_, &HistoryTable::failed, this, &PersonPage::failed);
  addSteps(commands);
  setFocusProxy(history_);
  showPerson();
}

void PersonPage::addSteps(ui::Commands& commands) {
  commands.beginSection(tr("Person"));
  for (const int by : {-1, 1}) {
    QPushButton* button = by < 0 ? previous_ : next_;
    const int key = by < 0 ? int(Qt::Key_Left) : int(Qt::Key_Right);
    const auto id = by < 0 ? QStringLiteral("review.person.previous") : QStringLiteral("review.person.next");
    button->setIcon(ui::icon(by < 0 ? QStringLiteral("left") : QStringLiteral("right")));
    button->setAccessibleName(by < 0 ? tr("Previous person") : tr("Next person"));
    commands.add(
        {.id = id,
         .text = button->accessibleName(),
         .does = by < 0 ? tr("shows the previous person of the class") : tr("shows the next person of the class"),
         .listed = by < 0 ? tr("Alt+Left") : tr("Alt+Right"),
         .keys = {{key, Qt::AltModifier}},
         .perform = [this, by](ui::KeyPress) { step(by); },
         .isAvailable = [this] { return isVisible() && room_.teaches(); }});
    button->setToolTip(commands.toolTip(id));
    connect(button, &QPushButton::clicked, this, [this, by] { step(by); });
  }
}

/// Goes through the people of the class in the order of their names.
void PersonPage::step(int by) {
  if (!room_.facts() || !controller_.facts()) return;
  std::vector<const Member*> people;
  for (const Member& one : room_.facts()->learners) people.push_back(&one);
  const QCollator names = ui::nameCollator();
  std::ranges::stable_sort(people, [&](const Member* a, const Member* b) {
    return names.compare(QString::fromStdString(a->person.fullName), QString::fromStdString(b->person.fullName)) < 0;
  });
  const auto here =
      std::ranges::find(people, controller_.facts()->person.id, [](const Member* one) { return one->person.id; });
  const auto at = here - people.begin() + by;
  if (here != people.end() && at >= 0 && at < std::ssize(people))
    Q_EMIT personRequested(QString::fromStdString(people[std::size_t(at)]->person.id));
}

QComboBox* PersonPage::choice(const char* name, const QString& title, const QString& tip) {
  auto* box = ui::choiceBox(name, title, tip);
  box->setMinimumWidth(230);
  connect(box, QOverload<int>::of(&QComboBox::activated), this, [this] { showCharts(); });
  return box;
}

QWidget* PersonPage::buildHead(const ui::Commands& commands) {
  auto* head = new QWidget;
  auto* row = new QHBoxLayout(head);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(ui::kGap);
  name_->setObjectName(QStringLiteral("personName"));
  name_->setTextFormat(Qt::PlainText);
  name_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  ui::setRole(name_, "title");
  sentence_->setObjectName(QStringLiteral("personSentence"));
  sentence_->setTextFormat(Qt::PlainText);
  sentence_->setWordWrap(true);
  save_->setObjectName(QStringLiteral("savePerson"));
  save_->setToolTip(
      commands.toolTip(tr("Saves the person's results as a page, a table or statements for a learning record store"),
                       QStringLiteral("review.save")));
  row->addWidget(previous_);
  row->addWidget(next_);
  row->addWidget(name_, 1);
  row->addWidget(metric_);
  row->addWidget(level_);
  row->addWidget(save_);
  return head;
}

QWidget* PersonPage::buildCharts() {
  learning_->setObjectName(QStringLiteral("learningChart"));
  cusum_->setObjectName(QStringLiteral("cusumChart"));
  place_->setObjectName(QStringLiteral("placeChart"));
  auto* charts = new QWidget;
  auto* row = new QHBoxLayout(charts);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(ui::kGap);
  // The legends and titles of the two smaller charts fit at 1366 px.
  row->addWidget(learning_, 9);
  row->addWidget(cusum_, 8);
  row->addWidget(place_, 5);
  for (ui::Chart* chart : {learning_, cusum_, place_}) {
    connect(chart, &ui::Chart::written, this, &PersonPage::written);
    connect(chart, &ui::Chart::failed, this, &PersonPage::failed);
  }
  return charts;
}

void PersonPage::showPerson() {
  showWhere();
  fillLevels();
  showCharts();
}

/// Shows the person's name, and the level with its sentence.
void PersonPage::showWhere() {
  const PersonFacts* facts = controller_.facts();
  name_->setText(facts ? QString::fromStdString(facts->person.fullName) : QString());
  name_->setToolTip(plainToolTip(name_->text()));
  QString words;
  if (!controller_.error().isEmpty())
    words = controller_.error();
  else if (!facts)
    words = controller_.isReading() ? tr("Reading ...")
                                    : tr("Choose a person on the page Class; Enter shows the person's page.");
  else if (facts->standing)
    words = QStringLiteral("%1   ·   %2")
                .arg(facts->standing->level.empty() ? tr("all levels")
                                                    : levelTitle(&*facts->curriculum, facts->standing->level),
                     QString::fromStdString(facts->standing->sentence));
  else
    words = tr("The class has no curriculum yet; an instructor chooses a curriculum under People and classes (Alt+U).");
  sentence_->setText(words);
  save_->setEnabled(facts);
  for (QPushButton* one : {previous_, next_}) one->setVisible(room_.teaches() && facts);
}

void PersonPage::fillLevels() {
  const QSignalBlocker quiet(level_);
  const QVariant before = level_->currentData();
  level_->clear();
  level_->addItem(tr("All attempts"), QString());
  const PersonFacts* facts = controller_.facts();
  if (!facts || !facts->curriculum) return;
  for (const Level& level : facts->curriculum->levels)
    level_->addItem(QString::fromStdString(level.title), QString::fromStdString(level.name));
  const int kept = level_->findData(before);
  const QString last = facts->history.empty() ? QString() : QString::fromStdString(facts->history.back().level);
  level_->setCurrentIndex(before.isValid() && kept > 0 ? kept : std::max(0, level_->findData(last)));
}

void PersonPage::showCharts() {
  const PersonFacts* facts = controller_.facts();
  if (!facts) {
    for (ui::Chart* chart : {learning_, cusum_, place_}) chart->show({});
    return;
  }
  const MetricMeaning& meaning = MetricCatalog::instance().all()[std::size_t(std::max(0, metric_->currentIndex()))];
  const std::string level = level_->currentData().toString().toStdString();
  learning_->show(learningOf(*facts, level, meaning));
  cusum_->show(cusumOf(*facts, level));
  place_->show(placeInClass(*facts, room_.heat(), meaning));
  // A trainee sees no data of the class.
  place_->setVisible(room_.teaches());
  history_->showLevel(level);
}

}  // namespace insonate::review
