#pragma once

#include "../class/ClassReading.h"

#include <QWidget>
#include <optional>
#include <string>

class QComboBox;
class QLabel;

namespace insonate::ui {
class Chart;
}

namespace insonate::review {

class ClassController;

/// Compares the class with another class in one metric.
class ComparePage final : public QWidget {
  Q_OBJECT

 public:
  explicit ComparePage(const ClassController& controller, QWidget* parent = nullptr);

 Q_SIGNALS:
  void written(const QString& sentence, const QString& folder);
  void failed(const QString& what, const QString& advice);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void fillClasses();
  void takeClass();
  std::string ownClass() const;
  void readOther();
  void show();

  const ClassController& controller_;
  QLabel *own_, *words_;
  QComboBox *other_, *metric_;
  ui::Chart* chart_;
  std::string ownId_;  ///< Cohort::id of the class with which the other class is compared
  std::optional<ClassFacts> otherFacts_;
  int round_ = 0;  ///< number of the last query; results of earlier queries are dropped
};

}  // namespace insonate::review
