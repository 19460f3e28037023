#include "ClassPage.h"

#include "../openings/OpeningBar.h"
#include "ClassController.h"
#include "ClassTable.h"
#include "ClassWords.h"
#include "HeatColors.h"
#include "NameColumn.h"

#include <insonate/ui/Commands.h>
#include <insonate/ui/NameOrder.h>
#include <insonate/ui/Theme.h>

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QListWidget>
#include <QPainter>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QSortFilterProxyModel>
#include <QStackedWidget>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>
#include <functional>
#include <vector>

namespace insonate::review {
namespace {

constexpr int kRow_px = 28, kHead_px = 78, kMetric_px = 96, kName_px = 170, kNeeds_px = 168, kLevel_px = 184,
              kNarrow_px = 88, kDay_px = 112, kConcerns_px = 130, kLegend_px = 160;

/// Sorts names by the user's language, and other columns by their values.
class SortedClass final : public QSortFilterProxyModel {
 public:
  explicit SortedClass(QObject* parent) : QSortFilterProxyModel(parent) { setSortRole(ClassTable::kSort); }

 protected:
  bool lessThan(const QModelIndex& left, const QModelIndex& right) const override {
    if (left.column() != ClassTable::kName) return QSortFilterProxyModel::lessThan(left, right);
    return names_.compare(left.data(ClassTable::kSort).toString(), right.data(ClassTable::kSort).toString()) < 0;
  }

 private:
  const QCollator names_ = ui::nameCollator();
};

/// Legend of the heat map's colors.
class HeatLegend final : public QWidget {
 public:
  HeatLegend() {
    setObjectName(QStringLiteral("heatLegend"));
    setToolTip(ClassPage::tr("Colors range from the published novice value to the published expert value; the number "
                             "is the mean of the last %1 counted attempts at levels, without free practice")
                   .arg(kLastAttempts));
    setFixedHeight(fontMetrics().height() + ui::kSmallGap);
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.setPen(ui::toQColor(views::theme::kQuiet));
    const QString left = ClassPage::tr("as a novice"), right = ClassPage::tr("as an expert");
    const int from = painter.fontMetrics().horizontalAdvance(left) + ui::kGap;
    painter.drawText(QRect(0, 0, from, height()), Qt::AlignVCenter, left);
    for (int x = 0; x < kLegend_px; ++x)
      painter.fillRect(from + x, ui::kSmallGap, 1, height() - 2 * ui::kSmallGap, heatColor(100.0 * x / kLegend_px));
    painter.drawText(QRect(from + kLegend_px + ui::kGap, 0, width(), height()), Qt::AlignVCenter,
                     right + ClassPage::tr("      mean of the last %1 attempts, without free practice      n/a: no "
                                           "data      no color: no published values")
                                 .arg(kLastAttempts));
  }
};

}  // namespace

ClassPage::ClassPage(ClassController& controller, ui::Commands& commands, QWidget* parent)
    : QWidget(parent),
      controller_(controller),
      model_(new ClassTable(controller, this)),
      sorted_(new SortedClass(this)),
      cohorts_(new QComboBox),
      facts_(new QLabel),
      words_(new QLabel),
      concernsTitle_(new QLabel),
      save_(new QPushButton(ui::icon(QStringLiteral("save")), tr("Save"))),
      again_(new QPushButton(ui::icon(QStringLiteral("reload")), tr("Refresh"))),
      table_(new QTableView),
      concerns_(new QListWidget),
      center_(new QStackedWidget) {
  words_->setObjectName(QStringLiteral("classWords"));
  words_->setWordWrap(true);
  words_->setTextFormat(Qt::PlainText);
  words_->setAlignment(Qt::AlignCenter);
  auto* both = new QWidget;
  auto* column = new QVBoxLayout(both);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(ui::kGap);
  column->addWidget(new OpeningBar(controller_, commands));
  column->addWidget(buildTable(), 1);
  setFocusProxy(table_);
  column->addWidget(buildConcerns());
  center_->addWidget(words_);
  center_->addWidget(both);
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(ui::kGap, ui::kGap, ui::kGap, ui::kGap);
  box->setSpacing(ui::kGap);
  box->addWidget(buildHead(commands));
  box->addWidget(center_, 1);
  connect(&controller_, &ClassController::cohortsChanged, this, [this] { showCohorts(); });
  connect(&controller_, &ClassController::classChanged, this, [this] { showClass(); });
  connect(&controller_, &ClassController::readingChanged, this, [this] { showPlace(); });
  connect(&controller_, &ClassController::standingChanged, this, [this](const QString& person) {
    model_->renewPerson(person);
    showFacts();
    showConcerns();
  });
  showCohorts();
  showClass();
}

QWidget* ClassPage::buildHead(ui::Commands& commands) {
  auto* head = new QWidget;
  auto* row = new QHBoxLayout(head);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(ui::kGap);
  cohorts_->setObjectName(QStringLiteral("cohorts"));
  cohorts_->setAccessibleName(tr("Class"));
  cohorts_->setToolTip(tr("Class shown"));
  cohorts_->setMinimumWidth(220);
  cohorts_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  connect(cohorts_, QOverload<int>::of(&QComboBox::activated), this, [this](int at) { controller_.choose(at); });
  facts_->setObjectName(QStringLiteral("classFacts"));
  facts_->setTextFormat(Qt::PlainText);
  facts_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  ui::setRole(facts_, "quiet");
  commands.beginSection(tr("Class"));
  commands.add({.id = QStringLiteral("review.class.refresh"),
                .text = again_->text(),
                .does = tr("reads the class again, with new attempts and people"),
                .listed = tr("F5"),
                .keys = {{Qt::Key_F5}},
                .perform = [this](ui::KeyPress) { again_->click(); },
                .isAvailable = [this] { return again_->isVisible() && again_->isEnabled(); }});
  again_->setToolTip(commands.toolTip(QStringLiteral("review.class.refresh")));
  connect(again_, &QPushButton::clicked, this, [this] { controller_.refresh(); });
  save_->setObjectName(QStringLiteral("saveClass"));
  save_->setToolTip(
      commands.toolTip(tr("Saves the class results as a page, a table or statements for a learning record store"),
                       QStringLiteral("review.save")));
  row->addWidget(cohorts_);
  row->addWidget(facts_, 1);
  row->addWidget(again_);
  row->addWidget(save_);
  return head;
}

QWidget* ClassPage::buildTable() {
  sorted_->setSourceModel(model_);
  sorted_->setSortCaseSensitivity(Qt::CaseInsensitive);
  sorted_->setDynamicSortFilter(true);
  table_->setObjectName(QStringLiteral("classTable"));
  table_->setAccessibleName(tr("People of the class and their performance in each metric"));
  table_->setToolTip(tr("Enter or a double click opens the person's page"));
  table_->setModel(sorted_);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setShowGrid(false);
  table_->setTabKeyNavigation(false);
  table_->setSortingEnabled(true);
  table_->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(kRow_px);
  QHeaderView* header = table_->horizontalHeader();
  header->setHighlightSections(false);
  header->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  header->setFixedHeight(kHead_px);
  header->setMinimumSectionSize(kNarrow_px);
  header->setSortIndicator(ClassTable::kName, Qt::AscendingOrder);
  for (int column = 0; column < model_->columnCount(); ++column) {
    table_->setColumnWidth(column, column == ClassTable::kName         ? kName_px
                                   : column == ClassTable::kNeeds      ? kNeeds_px
                                   : column == ClassTable::kLevel      ? kLevel_px
                                   : column == ClassTable::kLast       ? kDay_px
                                   : column < ClassTable::kFirstMetric ? kNarrow_px
                                                                       : kMetric_px);
    if (column >= ClassTable::kFirstMetric) table_->setItemDelegateForColumn(column, new HeatDelegate(table_));
  }
  new NameColumn(*table_);
  connect(table_, &QTableView::activated, this, [this] { announceChosenPerson(); });
  auto* part = new QWidget;
  auto* box = new QVBoxLayout(part);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(ui::kSmallGap);
  box->addWidget(table_, 1);
  box->addWidget(new HeatLegend);
  return part;
}

QWidget* ClassPage::buildConcerns() {
  ui::setRole(concernsTitle_, "heading");
  concerns_->setObjectName(QStringLiteral("concerns"));
  concerns_->setAccessibleName(tr("People who need attention, with the reason"));
  concerns_->setToolTip(tr("Enter or a double click opens the person's page"));
  concerns_->setWordWrap(true);
  concerns_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  connect(concerns_, &QListWidget::itemActivated, this,
          [this](const QListWidgetItem* item) { Q_EMIT personChosen(item->data(Qt::UserRole).toString()); });
  concerns_->setMaximumHeight(kConcerns_px);
  auto* part = new QWidget;
  auto* box = new QVBoxLayout(part);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(ui::kSmallGap);
  box->addWidget(concernsTitle_);
  box->addWidget(concerns_, 1);
  return part;
}

void ClassPage::showCohorts() {
  const QSignalBlocker quiet(cohorts_);
  cohorts_->clear();
  for (const Cohort& cohort : controller_.cohorts()) cohorts_->addItem(QString::fromStdString(listedName(cohort)));
  cohorts_->setCurrentIndex(controller_.cohorts().empty() ? -1 : controller_.chosen());
  cohorts_->setVisible(!controller_.cohorts().empty());
}

void ClassPage::showClass() {
  const QModelIndex before = table_->currentIndex();
  const QString person = before.data(ClassTable::kPerson).toString();
  model_->renew();
  for (int row = 0; row < sorted_->rowCount(); ++row)
    if (sorted_->index(row, 0).data(ClassTable::kPerson).toString() == person || row == 0)
      table_->setCurrentIndex(sorted_->index(row, 0));
  showPlace();
  showConcerns();
}

/// The table, or the reason why there is none.
void ClassPage::showPlace() {
  QString words;
  if (!controller_.error().isEmpty())
    words = controller_.error();
  else if (controller_.isReading() && !controller_.facts())
    words = tr("Reading the class ...");
  else if (controller_.cohorts().empty())
    words =
        controller_.administers()
            ? tr("There is no class yet. Open the menu under your name at the top right (Alt+U), choose People and "
                 "classes, make a class, and add its instructors and trainees.")
            : tr("You have no class yet. An administrator creates classes and assigns instructors; your classes then "
                 "appear here.");
  else if (controller_.facts() && controller_.facts()->learners.empty())
    words = tr("This class has no trainees yet. Add people, or a class list (CSV), under People and classes (Alt+U).");
  words_->setText(words);
  save_->setEnabled(words.isEmpty() && controller_.facts());
  center_->setCurrentIndex(words.isEmpty() ? 1 : 0);
  showFacts();
}

void ClassPage::showFacts() {
  QStringList facts;
  if (const ClassFacts* now = controller_.facts()) {
    facts << countOf(int(now->learners.size()), tr("person"), tr("people"));
    facts << (now->curriculum
                  ? tr("%1, version %2")
                        .arg(QString::fromStdString(now->curriculum->title), QString::number(now->curriculum->version))
                  : QString::fromStdString(now->error));
  }
  if (controller_.isReading()) facts << tr("reading ...");
  if (controller_.pendingStandings() > 0)
    facts << tr("computing mastery of levels; %1 remaining")
                 .arg(countOf(controller_.pendingStandings(), tr("person"), tr("people")));
  facts_->setText(facts.join(QStringLiteral("   ·   ")));
  facts_->setToolTip(plainToolTip(facts_->text()));
}

void ClassPage::addConcern(const Person& person, const QString& what, const QString& why) {
  auto* item = new QListWidgetItem(QStringLiteral("▲ %1, %2").arg(QString::fromStdString(person.fullName), what) +
                                   (why.isEmpty() ? QString() : QStringLiteral(":  ") + why));
  item->setData(Qt::UserRole, QString::fromStdString(person.id));
  concerns_->addItem(item);
}

void ClassPage::showConcerns() {
  concerns_->clear();
  if (const ClassFacts* now = controller_.facts()) {
    std::vector<const Member*> learners;
    for (const Member& member : now->learners) learners.push_back(&member);
    std::ranges::stable_sort(learners, std::greater(), [&](const Member* one) { return attentionOf(*now, *one); });
    for (const Member* one : learners)
      if (const Member& member = *one; attentionOf(*now, member) != Attention::None)
        addConcern(member.person, stateWords(*now, member),
                   member.standing ? QString::fromStdString(member.standing->sentence) : QString());
    const auto addAttempt = [&](const AttemptFacts& attempt, const QString& why) {
      const auto member = std::ranges::find(now->learners, attempt.person, [](const Member& m) { return m.person.id; });
      if (member != now->learners.end())
        addConcern(member->person, tr("attempt of %1").arg(dayOf(attempt.begun_us)), why);
    };
    for (const AttemptFacts& one : now->unproven)
      addAttempt(one, tr("not proven; counts only after you accept it on the page of the person"));
    for (const FlaggedAttempt& one : now->implausible) addAttempt(one.facts, displayText(one.facts, one.flags));
  }
  concernsTitle_->setText(concerns_->count() > 0               ? tr("Needs attention")
                          : controller_.pendingStandings() > 0 ? tr("Needs attention: still being computed")
                                                               : tr("No trainee needs attention"));
  concerns_->setVisible(concerns_->count() > 0);
  shareHeight();
}

/// Gives the list the height that a short table leaves.
void ClassPage::shareHeight() {
  const int frame_px = 2 * concerns_->frameWidth();
  const int content_px = std::max(0, concerns_->sizeHintForRow(0)) * concerns_->count() + frame_px;
  const int table_px =
      kHead_px + kRow_px * sorted_->rowCount() + 2 * table_->horizontalScrollBar()->sizeHint().height();
  const int others_px = kConcerns_px;  // head of the page, legend, tests and gaps
  concerns_->setMaximumHeight(
      std::clamp(height() - table_px - others_px, kConcerns_px, std::max(kConcerns_px, content_px)));
}

void ClassPage::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  shareHeight();
}

QString ClassPage::chosenPerson() const {
  return table_->currentIndex().data(ClassTable::kPerson).toString();
}

void ClassPage::announceChosenPerson() {
  if (const QString person = chosenPerson(); !person.isEmpty()) Q_EMIT personChosen(person);
}

}  // namespace insonate::review
