#include "PersonPage.h"

#include "../class/ClassController.h"
#include "../class/ClassWords.h"
#include "HistoryTable.h"
#include "PersonCharts.h"
#include "PersonController.h"

#include <insonate/ui/Chart.h>
#include <insonate/ui/Commands.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSplitter>
#include <QVBoxLayout>

namespace insonate::review {

PersonPage::PersonPage(PersonController& controller, const ClassController& room, ui::Commands& commands,
                       QWidget* parent)
    : QWidget(parent),
      controller_(controller),
      room_(room),
      name_(new QLabel),
      sentence_(new QLabel),
      save_(new QPushButton(ui::icon(QStringLiteral("save")), tr("Save"))),
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
  setFocusProxy(history_);
  showPerson();
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
}

}  // namespace insonate::review
