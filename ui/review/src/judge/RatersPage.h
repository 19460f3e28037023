#pragma once

#include <insonate/curriculum/FormAgreement.h>

#include <QWidget>
#include <vector>

class QComboBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace insonate::review {

class ClassController;

/// Shows the agreement of raters about a class's attempts by one form, in pairs and item by item. The store is queried
/// when the page is shown.
class RatersPage final : public QWidget {
  Q_OBJECT

 public:
  explicit RatersPage(const ClassController& controller, QWidget* parent = nullptr);

  /// Saves the values as CSV.
  void saveTable(const QString& file);

 Q_SIGNALS:
  void written(const QString& sentence, const QString& folder);
  void failed(const QString& what, const QString& advice);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  QWidget* buildHead();
  void read();
  void show();
  void showItems();
  QString words() const;

  const ClassController& controller_;
  std::vector<Form> forms_;
  FormAgreement agreement_;
  QString error_;
  bool known_ = false;
  int round_ = 0;  ///< number of the last query; results about other classes or forms are dropped
  QComboBox* choice_;
  QPushButton* save_;
  QLabel* words_;
  QTableWidget *pairs_, *items_;
};

}  // namespace insonate::review
