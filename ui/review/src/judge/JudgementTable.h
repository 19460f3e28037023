#pragma once

#include <insonate/curriculum/FilledForm.h>
#include <insonate/curriculum/Form.h>

#include <QWidget>
#include <vector>

class QCheckBox;
class QLabel;
class QTableWidget;

namespace insonate::review {

/// Shows the judgements of an attempt by one form: a row per item, a column per rater, differences, notes, and
/// agreement.
class JudgementTable final : public QWidget {
  Q_OBJECT

 public:
  explicit JudgementTable(QWidget* parent = nullptr);

  void show(const Form& form, const std::vector<StoredForm>& forms);

 private:
  struct Column {
    QString title;
    FormAnswers answers;
  };
  void fill();
  void fillRow(int row, const FormItem& item, bool differs);
  QString wordsAbove() const;
  QString agreementWords() const;

  Form form_;
  std::vector<StoredForm> forms_;
  std::vector<Column> columns_;  ///< columns of the judgements that the user may read
  QLabel *words_, *agreement_;
  QCheckBox* onlyDiffering_;
  QTableWidget* table_;
};

}  // namespace insonate::review
