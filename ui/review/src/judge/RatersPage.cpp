#include "RatersPage.h"

#include "../class/ClassController.h"
#include "../class/ClassWords.h"
#include "JudgeWords.h"

#include <insonate/core/AtomicFile.h>
#include <insonate/curriculum/FormStore.h>
#include <insonate/ui/Account.h>
#include <insonate/ui/RowTable.h>
#include <insonate/ui/Theme.h>

#include <QComboBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

namespace insonate::review {
namespace {

constexpr int kRaterRow_px = 26, kCount_px = 90, kFigure_px = 170;

QTableWidget* tableOf(const char* object, const QString& name, const QStringList& titles) {
  auto* table = new QTableWidget;
  table->setObjectName(QLatin1String(object));
  table->setAccessibleName(name);
  table->setColumnCount(titles.size());
  table->setHorizontalHeaderLabels(titles);
  ui::makeRowTable(*table, kRaterRow_px);
  table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  for (int column = 1; column < titles.size(); ++column)
    table->horizontalHeader()->resizeSection(column, column + 1 < titles.size() ? kCount_px : kFigure_px);
  return table;
}

void setRow(QTableWidget& table, int row, const QStringList& cells) {
  for (int column = 0; column < cells.size(); ++column) {
    auto* cell = new QTableWidgetItem(cells[column]);
    cell->setToolTip(plainToolTip(cells[column]));
    table.setItem(row, column, cell);
  }
}

}  // namespace

RatersPage::RatersPage(const ClassController& controller, QWidget* parent)
    : QWidget(parent),
      controller_(controller),
      choice_(new QComboBox),
      save_(new QPushButton(ui::icon(QStringLiteral("save")), tr("Save table ..."))),
      words_(new QLabel),
      pairs_(tableOf(
          "raterPairs", tr("Pairs of raters and their agreement"),
          {tr("Raters"), tr("Attempts"), tr("Answers"), tr("Equal answers"), tr("Kappa"), tr("ICC of the scores")})),
      items_(tableOf("raterItems", tr("Agreement of the two selected raters on each item"),
                     {tr("Item"), tr("Answers"), tr("Equal answers"), tr("Kappa"), tr("ICC of the points")})) {
  for (const std::string& name : formPresetNames())
    if (auto form = loadForm(name); form && form->isJudgement()) forms_.push_back(std::move(*form));
  words_->setObjectName(QStringLiteral("raterWords"));
  words_->setTextFormat(Qt::PlainText);
  words_->setWordWrap(true);
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(ui::kGap, ui::kGap, ui::kGap, ui::kGap);
  box->setSpacing(ui::kGap);
  box->addWidget(buildHead());
  box->addWidget(words_);
  box->addWidget(pairs_, 1);
  box->addWidget(items_, 3);
  box->addStretch();  // if there are no tables
  connect(pairs_, &QTableWidget::itemSelectionChanged, this, [this] { showItems(); });
  connect(&controller_, &ClassController::classChanged, this, [this] {
    known_ = false;
    if (isVisible()) read();
  });
  show();
}

QWidget* RatersPage::buildHead() {
  auto* head = new QWidget;
  auto* row = new QHBoxLayout(head);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(ui::kGap);
  choice_->setObjectName(QStringLiteral("ratersForm"));
  choice_->setAccessibleName(tr("Form"));
  choice_->setToolTip(tr("The checklist or rating with which attempts were judged"));
  for (const Form& form : forms_) choice_->addItem(QString::fromStdString(form.title));
  connect(choice_, QOverload<int>::of(&QComboBox::activated), this, [this] { read(); });
  save_->setObjectName(QStringLiteral("saveRaters"));
  save_->setToolTip(tr("Saves the agreement values of all raters and items as CSV"));
  connect(save_, &QPushButton::clicked, this, [this] {
    const QString file = QFileDialog::getSaveFileName(
        this, tr("Save the agreement"), QDir::home().filePath(QStringLiteral("raters.csv")), tr("Table (*.csv)"));
    if (!file.isEmpty()) saveTable(file);
  });
  row->addWidget(choice_);
  row->addStretch(1);
  row->addWidget(save_);
  return head;
}

void RatersPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  read();
}

void RatersPage::read() {
  ++round_;
  known_ = false, agreement_ = {}, error_.clear();
  show();
  if (!controller_.facts()) return;
  controller_.account()->query<FormAgreement>(
      this,
      [cohort = controller_.facts()->cohort.id, form = forms_[std::size_t(choice_->currentIndex())]](
          const SignedIn& by) { return FormStore(by).agreement(cohort, form); },
      [this, round = round_](Result<FormAgreement> agreement) {
        if (round != round_) return;
        known_ = agreement.has_value();
        known_ ? void(agreement_ = std::move(*agreement))
               : void(error_ = QString::fromStdString(agreement.error().message));
        show();
      });
}

QString RatersPage::words() const {
  if (!error_.isEmpty()) return error_;
  if (!controller_.facts()) return tr("Choose a class on the page Class.");
  if (!known_) return tr("Reading ...");
  const QString twice =
      tr("Judged with this form in '%2': %1, of which %3 by two raters or more.")
          .arg(countOf(agreement_.judged, tr("attempt"), tr("attempts")),
               QString::fromStdString(controller_.facts()->cohort.name), QString::number(agreement_.judgedTwice));
  if (agreement_.pairs.empty())
    return twice + QLatin1Char(' ') +
           tr("There is nothing to compare yet. Replay an attempt that another rater has judged, press 4, and judge "
              "the attempt, too.");
  const QString left =
      agreement_.otherVersions > 0
          ? tr(" Forms with another version, which are not included: %1.").arg(agreement_.otherVersions)
          : QString();
  return twice + left;
}

void RatersPage::show() {
  words_->setText(words());
  save_->setEnabled(!agreement_.pairs.empty());
  pairs_->setRowCount(int(agreement_.pairs.size()));
  for (int row = 0; row < pairs_->rowCount(); ++row) {
    const RaterPair& pair = agreement_.pairs[std::size_t(row)];
    const RaterComparison& comparison = pair.comparison;
    setRow(*pairs_, row,
           {tr("%1 and %2").arg(QString::fromStdString(pair.first), QString::fromStdString(pair.second)),
            QString::number(pair.attempts), QString::number(comparison.pairs), percentOf(comparison.agreement),
            coefficientOf(comparison.kappa), coefficientOf(comparison.scores)});
  }
  for (QTableWidget* table : {pairs_, items_}) table->setVisible(!agreement_.pairs.empty());
  if (pairs_->rowCount() > 0) pairs_->selectRow(0);
  showItems();
}

void RatersPage::showItems() {
  const int chosen = pairs_->currentRow();
  const bool any = chosen >= 0 && chosen < int(agreement_.pairs.size());
  const auto items = any ? agreement_.pairs[std::size_t(chosen)].comparison.items : std::vector<ItemAgreement>();
  const Form& form = forms_[std::size_t(choice_->currentIndex())];
  items_->setRowCount(int(items.size()));
  for (int row = 0; row < int(items.size()); ++row) {
    const ItemAgreement& one = items[std::size_t(row)];
    const FormItem* item = form.item(one.item);
    setRow(*items_, row,
           {QString::fromStdString(item ? item->title : one.item), QString::number(one.pairs), percentOf(one.agreement),
            coefficientOf(one.kappa), coefficientOf(one.points)});
  }
}

void RatersPage::saveTable(const QString& file) {
  const auto done =
      writeAtomically(file.toStdString(), agreementCsv(forms_[std::size_t(choice_->currentIndex())], agreement_));
  if (!done) return Q_EMIT failed(QString::fromStdString(done.error().message), {});
  Q_EMIT written(tr("Agreement saved as %1.").arg(QFileInfo(file).fileName()), QFileInfo(file).absolutePath());
}

}  // namespace insonate::review
