#include "JudgementTable.h"

#include "../class/ClassWords.h"
#include "JudgeWords.h"

#include <insonate/curriculum/FormAgreement.h>
#include <insonate/ui/AttemptWords.h>
#include <insonate/ui/RowTable.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QCheckBox>
#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

namespace insonate::review {
namespace {

constexpr int kAnswerRow_px = 24, kAnswer_px = 130;

/// Text of a cell: the answer, and its note.
QString cellOf(const FormItem& item, const FormAnswers& answers) {
  const QString answer = QString::fromStdString(answerText(item, answers));
  const QString note = QString::fromStdString(noteText(item, answers));
  if (note.isEmpty()) return answer.isEmpty() ? JudgementTable::tr("n/a") : answer;
  return answer.isEmpty() ? note : QStringLiteral("%1: %2").arg(answer, note);
}

QLabel* lowParagraph(const char* object) {
  auto* label = ui::paragraph(object);
  label->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
  return label;
}

}  // namespace

JudgementTable::JudgementTable(QWidget* parent)
    : QWidget(parent),
      words_(lowParagraph("judgementWords")),
      agreement_(lowParagraph("judgementAgreement")),
      onlyDiffering_(new QCheckBox(tr("Only items where raters differ"))),
      table_(new QTableWidget) {
  onlyDiffering_->setObjectName(QStringLiteral("onlyDiffering"));
  onlyDiffering_->setToolTip(tr("Hides items that all raters answered equally and without a note"));
  connect(onlyDiffering_, &QCheckBox::toggled, this, [this] { fill(); });
  table_->setObjectName(QStringLiteral("judgements"));
  table_->setAccessibleName(tr("Answers item by item, a column for each form that was handed in"));
  ui::makeRowTable(*table_, kAnswerRow_px);
  table_->setWordWrap(true);
  table_->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  table_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(ui::kGap);
  box->addWidget(words_);
  box->addWidget(onlyDiffering_);
  box->addWidget(table_, 1);
  box->addWidget(agreement_);
  box->addStretch(0);
}

void JudgementTable::show(const Form& form, const std::vector<StoredForm>& forms) {
  form_ = form;
  forms_.clear(), columns_.clear();
  std::ranges::copy_if(forms, std::back_inserter(forms_),
                       [&](const StoredForm& one) { return one.filled.form == form.name; });
  for (const StoredForm& one : forms_)
    if (const auto answers = parseAnswers(one.filled.answers); answers && !one.withheld)
      columns_.push_back(
          {QStringLiteral("%1\n%2").arg(QString::fromStdString(one.rater), dayOf(one.filled.filled_us)), *answers});
  fill();
}

void JudgementTable::fill() {
  words_->setText(wordsAbove());
  agreement_->setText(agreementWords());
  onlyDiffering_->setVisible(columns_.size() > 1);
  table_->setVisible(!columns_.empty());
  table_->setRowCount(0);
  table_->setColumnCount(1 + int(columns_.size()));
  QStringList titles{tr("Item")};
  for (const Column& column : columns_) titles << column.title;
  table_->setHorizontalHeaderLabels(titles);
  table_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  for (int column = 1; column < table_->columnCount(); ++column)
    table_->horizontalHeader()->resizeSection(column, kAnswer_px);
  for (const FormSection& section : form_.sections)
    for (const FormItem& item : section.items) {
      const bool differs = std::ranges::any_of(columns_, [&](const Column& one) {
        return answerText(item, one.answers) != answerText(item, columns_.front().answers);
      });
      const bool noted =
          std::ranges::any_of(columns_, [&](const Column& one) { return !noteText(item, one.answers).empty(); });
      if (onlyDiffering_->isChecked() && columns_.size() > 1 && !differs && !noted) continue;
      const int row = table_->rowCount();
      table_->setRowCount(row + 1);
      fillRow(row, item, differs && item.kind != FormItem::Kind::Text);
    }
}

/// A sign marks items on which raters differ, in addition to color.
void JudgementTable::fillRow(int row, const FormItem& item, bool differs) {
  const auto set = [&](int column, const QString& text) {
    auto* cell = new QTableWidgetItem(text);
    cell->setToolTip(plainToolTip(text));
    if (differs) cell->setForeground(ui::toQColor(views::theme::kCaution));
    table_->setItem(row, column, cell);
  };
  const QString title = QString::fromStdString(item.title);
  set(0, differs ? QStringLiteral("\u2260 %1").arg(title) : title);
  for (std::size_t i = 0; i < columns_.size(); ++i) set(int(i) + 1, cellOf(item, columns_[i].answers));
}

/// Rater of each column.
QString JudgementTable::wordsAbove() const {
  if (forms_.empty())
    return tr("No rater has handed in '%1' about this attempt yet.").arg(QString::fromStdString(form_.title));
  QStringList lines;
  for (const StoredForm& one : forms_) {
    const QString who =
        QStringLiteral("%1, %2").arg(QString::fromStdString(one.rater), ui::dayAndTimeOf(one.filled.filled_us));
    const auto answers = parseAnswers(one.filled.answers);
    if (one.withheld)
      lines << tr("%1: visible once you have handed in your own form").arg(who);
    else if (answers && one.filled.formVersion == form_.version)
      lines << QStringLiteral("%1: %2").arg(who, scoreWords(formScore(form_, *answers)));
    else
      lines
          << tr("%1: no score; the form was filled in with another version (%2)").arg(who).arg(one.filled.formVersion);
  }
  return lines.join(QLatin1Char('\n'));
}

QString JudgementTable::agreementWords() const {
  QStringList lines;
  for (const RaterPair& pair : agreementOf(form_, forms_).pairs) lines << displayText(pair);
  if (lines.empty())
    return columns_.empty() ? QString()
                            : tr("Agreement between raters: n/a, since only one rater has judged this attempt.");
  return lines.join(QLatin1Char('\n'));
}

}  // namespace insonate::review
